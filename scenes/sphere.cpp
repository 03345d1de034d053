/// A sphere of laths after figure 3.4 of the thesis: pressed, it first moves straight down and then twists.

#include <cmath>
#include <numbers>

#include "scenes/parts.h"
#include "scenes/scene_models.h"

namespace lissom::scene_models {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRadius = 0.08;                            // m, of the sphere
constexpr double kLatitude = kPi / 3;                       // rad, of the lowest and the highest ring
constexpr double kOut = 0.002, kInPlane = 0.0008;           // m, half-axes of meridians across and in the tangent plane
constexpr double kBeltOut = 0.0015, kBeltInPlane = 0.0004;  // m, the same of belts
constexpr int kMeridians = 12, kStoreys = 3, kEdges = 5;
constexpr double kBeltDepth = 0.5;  // of a storey: belts zigzag, so that they give when the sphere widens
constexpr double kPress = 0.06;     // m
constexpr double kTime = 0.5;       // s, in which it is pressed

/// Place in the grid of meridians and storeys; fractions in between. `lean`: rad of longitude from bottom to top.
Vec3 grid_point(double meridian, double storey, double lean) {
  const double up = storey / kStoreys;
  const double longitude = 2 * kPi * meridian / kMeridians + lean * up, latitude = kLatitude * (2 * up - 1);
  return kRadius *
         Vec3(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude));
}

Rod lath(const std::string& name, const Vec2& from, const Vec2& to, double lean, const Vec2& section) {
  Polyline line;
  MaterialAxes axes;
  axes.kind = MaterialAxes::Kind::kPerPoint;
  for (int k = 0; k <= kEdges; ++k) {
    const Vec2 place = from + static_cast<double>(k) / kEdges * (to - from);
    line.points.push_back(grid_point(place.x(), place.y(), lean));
    axes.normals.push_back(line.points.back().normalized());
  }
  Rod rod = round_rod(name, line, section.x(), "TPU 92A", kEdges);
  rod.section.r_b = {section.y()};
  rod.axes = axes;
  return rod;
}

Selector set_named(const std::string& name) {
  Selector set;
  set.kind = Selector::Kind::kSet;
  set.name = name;
  return set;
}

Pose pressed_pose() {
  Pose pose;
  pose.name = "pressed";
  // The plate on top is smooth: it takes the wheel down and lets it turn, about a pin in its middle.
  Support plate = hold(set_named("top"), SupportKind::kFree);
  plate.directions = {Vec3::UnitZ()};
  plate.move = Vec3(0, 0, -kPress);
  Support pin = hold(rod_place("spoke 1", 0), SupportKind::kPin);
  pin.move = plate.move;
  pose.supports = {hold(set_named("bottom"), SupportKind::kPin), plate, pin};
  return pose;
}

}  // namespace

Model sphere_leaning(double lean) {
  Model model;
  model.title = "Sphere of laths under compression";
  model.source = "after Computational Design of Flexible Structures, figure 3.4";
  const Vec2 bar(kOut, kInPlane), belt(kBeltOut, kBeltInPlane);
  Selector top, bottom;
  top.kind = bottom.kind = Selector::Kind::kUnion;
  const auto add = [&](const Rod& rod, Selector* set) {
    model.rods.push_back(rod);
    if (set != nullptr) set->parts.push_back(rod_place(rod.name, -1));
  };
  const Vec3 middle(0, 0, grid_point(0, kStoreys, lean).z());
  for (int m = 0; m < kMeridians; ++m) {
    const std::string number = std::to_string(m + 1);
    for (int s = 0; s < kStoreys; ++s) {
      add(lath("meridian " + number + "." + std::to_string(s + 1), {m, s}, {m, s + 1}, lean, bar), nullptr);
    }
    // Belts point away from the equator.
    for (int s = 1; s < kStoreys; ++s) {
      const Vec2 tip(m + 0.5, s + (2 * s < kStoreys ? -kBeltDepth : kBeltDepth));
      const std::string place = number + "." + std::to_string(s);
      add(lath("belt " + place + " a", {m, s}, tip, lean, belt), nullptr);
      add(lath("belt " + place + " b", tip, {m + 1, s}, lean, belt), nullptr);
    }
    add(lath("bottom " + number, {m, 0}, {m + 1, 0}, lean, bar), &bottom);
    add(lath("top " + number, {m, kStoreys}, {m + 1, kStoreys}, lean, bar), &top);
    add(round_rod("spoke " + number, Polyline{{middle, grid_point(m, kStoreys, lean)}, false}, kOut, "TPU 92A", 2),
        &top);
  }
  model.sets = {{"top", top}, {"bottom", bottom}};
  model.poses = {pressed_pose()};

  MotionCase press;
  press.name = "press";
  press.pose = "pressed";
  press.duration = kTime;
  press.step = 1e-3;
  press.record_every = kTime / 200;
  press.error_tolerance = 1e-3;
  press.load_factor = {Vec2(0, 0), Vec2(kTime, 1)};
  model.motions = {press};
  return model;
}

Model sphere() { return sphere_leaning(0.2 * kPi / 180); }

}  // namespace lissom::scene_models
