/// Windmills after figure 3.3 of the thesis: the twist of an axis passes into the bending of its blades.

#include <cmath>
#include <numbers>

#include "scenes/parts.h"
#include "scenes/scene_models.h"

namespace lissom::scene_models {

namespace {

constexpr double kAxisLength = 0.12, kBladeLength = 0.07;  // m
constexpr double kSpacing = 0.16;                          // m, between axes
constexpr double kBladeThin = 0.0012, kBladeWide = 0.003;  // m, half-axes of the blades' section
constexpr int kBlades = 4;
constexpr double kTwist = 5 * std::numbers::pi / 6;  // rad, of the hubs before release

}  // namespace

/// The axes along x are held along their centrelines and in a frame at their far ends; the hubs with the blades are at the
/// others.
Model windmills(std::span<const WindmillAxis> axes) {
  Model model;
  model.source = "after Computational Design of Flexible Structures, figure 3.3";
  Pose twisted, released;
  twisted.name = "twisted";
  released.name = "released";
  for (size_t i = 0; i < axes.size(); ++i) {
    const double y = kSpacing * (static_cast<double>(i) - 0.5 * static_cast<double>(axes.size() - 1));
    const Vec3 foot(0, y, 0), hub(kAxisLength, y, 0);
    const std::string axis = "axis of " + axes[i].name;
    model.rods.push_back(round_rod(axis, Polyline{{foot, hub}, false}, axes[i].radius, "TPU 92A", 24));
    Selector blades;
    blades.kind = Selector::Kind::kUnion;
    for (int k = 0; k < kBlades; ++k) {
      const double angle = 2 * std::numbers::pi * k / kBlades;
      const Vec3 along(0, std::cos(angle), std::sin(angle));
      Rod blade = round_rod("blade " + std::to_string(k + 1) + " of " + axes[i].name,
                            Polyline{{hub, hub + kBladeLength * along}, false}, kBladeThin, "TPU 92A", 14);
      // Wide along the axis, thin in the plane in which the hub turns.
      blade.section.r_b = {kBladeWide};
      blade.axes.normal = Vec3::UnitX().cross(along);
      model.rods.push_back(blade);
      blades.parts.push_back(rod_place(blade.name, -1));
    }
    model.sets.push_back({axes[i].name, blades});
    for (Pose* pose : {&twisted, &released}) {
      pose->supports.push_back(hold(rod_place(axis, -1), SupportKind::kPin));
      pose->supports.push_back(hold(rod_place(axis, 0), SupportKind::kClamp));
    }
    Support turned = hold(rod_place(axis, 1), SupportKind::kClamp);
    turned.turn_axis = Vec3::UnitX();
    turned.turn_angle = kTwist;
    twisted.supports.push_back(turned);
  }
  model.poses = {twisted, released};

  MotionCase release;
  release.name = "release";
  release.start_pose = "twisted";
  release.pose = "released";
  release.duration = 0.3;
  release.step = 1e-3;
  release.record_every = 2e-3;
  release.error_tolerance = 3e-4;
  model.motions = {release};
  return model;
}

Model windmill() {
  const WindmillAxis axes[] = {{"thin", 0.002}, {"medium", 0.0028}, {"thick", 0.004}};
  Model model = windmills(axes);
  model.motions[0].duration = 0.1;
  model.motions[0].record_every = 1e-3;
  model.title = "Windmills with a thin, a medium and a thick axis";
  return model;
}

}  // namespace lissom::scene_models
