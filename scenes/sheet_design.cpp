#include "scenes/sheet_design.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "lissom/core/assert.h"
#include "scenes/parts.h"

namespace lissom::scene_models {

namespace {

constexpr double kEdge = 0.2 / 9.5;  // m, of a hexagon: the sheet is 0.2 m long
constexpr int kEdges = 10;           // of a rod
constexpr double kRadius = 2e-3;     // m, to start with
constexpr double kMargin = 0.55;     // of a hexagon's edge: how far a side that is held reaches in
constexpr double kWeight = 0.15;     // N, in all, at the far side
constexpr double kPull = 14;         // N, in all

/// Nodes within the margin of the side at the end of `axis` on which `sign` is.
std::vector<Vec3> side_nodes(const Model& model, int axis, double sign) {
  double reach = -1;
  for (const Rod& rod : model.rods) {
    for (const Vec3& x : std::get<Polyline>(rod.curve).points) reach = std::max(reach, sign * x[axis]);
  }
  std::vector<Vec3> places;
  for (const Rod& rod : model.rods) {
    const std::vector<Vec3>& ends = std::get<Polyline>(rod.curve).points;
    LISSOM_ASSERT(ends.size() == 2);
    for (int k = 0; k <= kEdges; ++k) {
      const Vec3 x = ends[0] + (ends[1] - ends[0]) * k / kEdges;
      if (sign * x[axis] < reach - kMargin * kEdge) continue;
      const bool known =
          std::any_of(places.begin(), places.end(), [&](const Vec3& y) { return (x - y).norm() < 1e-6; });
      if (!known) places.push_back(x);
    }
  }
  return places;
}

/// Held at the negative end of `axis`, `force` (N, in all) at the other one.
Pose side_pose(const Model& model, std::string name, int axis, const Vec3& force, double stiffness) {
  Pose pose;
  pose.name = std::move(name);
  for (const Vec3& x : side_nodes(model, axis, -1)) pose.soft_pins.push_back({at_point(x), stiffness, x});
  Selector far;
  far.kind = Selector::Kind::kUnion;
  for (const Vec3& x : side_nodes(model, axis, 1)) far.parts.push_back(at_point(x));
  pose.forces.push_back({far, force, true, Scaling::kProportional});
  pose.gravity = Gravity{};
  return pose;
}

}  // namespace

Model with_radii(const Model& model, const RadiiField& field) {
  Model changed = model;
  for (Rod& rod : changed.rods) {
    // Profiles are linear between even places: with two to an edge, every middle of an edge is one of them.
    const std::vector<Vec3>& ends = std::get<Polyline>(rod.curve).points;
    const Vec3 along = ends.back() - ends.front();
    rod.section.r_n.clear();
    rod.section.r_b.clear();
    for (int k = 0; k <= 2 * kEdges; ++k) {
      const Vec2 radii = field(ends.front() + along * k / (2 * kEdges), along.normalized());
      rod.section.r_n.push_back(radii[0]);
      rod.section.r_b.push_back(radii[1]);
    }
  }
  return changed;
}

Model sheet_to_design(double stiffness) {
  Model model = sheet("Sheet", hexagon_pattern(kEdge, 3, 6), kRadius, "TPU 92A", kEdges);
  model.joint_kind = JointKind::kCorotational;
  const Vec3 down = -kWeight * Vec3::UnitZ();
  model.poses = {side_pose(model, "bent lengthwise", 1, down, stiffness),
                 side_pose(model, "bent crosswise", 0, down, stiffness),
                 side_pose(model, "pulled lengthwise", 1, kPull * Vec3::UnitY(), stiffness),
                 side_pose(model, "pulled crosswise", 0, 3 * kPull * Vec3::UnitX(), stiffness)};
  return model;
}

std::vector<RadiiField> sheet_targets() {
  const auto graded = [](double r_n, double r_b, double grade, int axis) {
    return [=](const Vec3& x, const Vec3&) {
      const double f = 1 + grade * x[axis] / 0.1;
      return Vec2(r_n * f, r_b * f);
    };
  };
  return {graded(3.2e-3, 2.2e-3, 0.1, 1), graded(1.35e-3, 1.75e-3, -0.1, 0), graded(2e-3, 1.5e-3, 0.2, 1),
          graded(2e-3, 1.5e-3, 0.2, 0)};
}

}  // namespace lissom::scene_models
