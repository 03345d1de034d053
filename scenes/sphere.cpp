/// A sphere of rods after figure 3.4 of the thesis: compressed, it first moves straight down and then twists.

#include <cmath>
#include <numbers>

#include "scenes/parts.h"
#include "scenes/scene_models.h"

namespace lissom::scene_models {

namespace {

constexpr double kRadius = 0.08;                    // m, of the sphere
constexpr double kOut = 0.002, kInPlane = 0.0005;   // m, half-axes across and in the tangent plane
constexpr int kMeridians = 12, kBands = 5;          // rings are between and around the bands
constexpr double kLatitude = std::numbers::pi / 3;  // rad, of the first and the last ring
constexpr double kLean =
    2 * std::numbers::pi / 180;  // rad of longitude from bottom to top: it decides the sense of the turn
constexpr double kPress = 0.05;  // m
constexpr double kTime = 0.5;    // s, in which it is pressed

Vec3 on_sphere(double longitude, double latitude) {
  return kRadius *
         Vec3(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude));
}

/// Place in the grid of meridians and rings; fractions in between.
Vec3 grid_point(double meridian, double ring) {
  const double up = ring / kBands;
  return on_sphere(2 * std::numbers::pi * meridian / kMeridians + kLean * up, kLatitude * (2 * up - 1));
}

Rod lath(const std::string& name, double meridian0, double ring0, double meridian1, double ring1, int edges) {
  Polyline line;
  MaterialAxes axes;
  axes.kind = MaterialAxes::Kind::kPerPoint;
  for (int k = 0; k <= edges; ++k) {
    const double s = static_cast<double>(k) / edges;
    line.points.push_back(grid_point(meridian0 + s * (meridian1 - meridian0), ring0 + s * (ring1 - ring0)));
    axes.normals.push_back(line.points.back().normalized());
  }
  Rod rod = round_rod(name, line, kOut, "TPU 92A", edges);
  rod.section.r_b = {kInPlane};
  rod.axes = axes;
  return rod;
}

}  // namespace

Model sphere() {
  Model model;
  model.title = "Sphere of rods under compression";
  model.source = "after Computational Design of Flexible Structures, figure 3.4";
  Selector top, bottom;
  top.kind = bottom.kind = Selector::Kind::kUnion;
  for (int m = 0; m < kMeridians; ++m) {
    for (int r = 0; r <= kBands; ++r) {
      const std::string place = std::to_string(m + 1) + "." + std::to_string(r + 1);
      model.rods.push_back(lath("ring " + place, m, r, m + 1, r, 4));
      if (r < kBands) model.rods.push_back(lath("meridian " + place, m, r, m, r + 1, 4));
      if (r == 0) bottom.parts.push_back(rod_place("ring " + place, -1));
      if (r == kBands) top.parts.push_back(rod_place("ring " + place, -1));
    }
  }
  model.sets = {{"top", top}, {"bottom", bottom}};

  Pose pressed;
  pressed.name = "pressed";
  Selector top_set, bottom_set;
  top_set.kind = bottom_set.kind = Selector::Kind::kSet;
  top_set.name = "top";
  bottom_set.name = "bottom";
  // The plate on top is smooth: it takes the ring down and lets it turn.
  Support plate = hold(top_set, SupportKind::kFree);
  plate.directions = {Vec3::UnitZ()};
  plate.move = Vec3(0, 0, -kPress);
  pressed.supports = {hold(bottom_set, SupportKind::kPin), plate};
  model.poses = {pressed};

  MotionCase press;
  press.name = "press";
  press.pose = "pressed";
  press.duration = kTime;
  press.step = 1e-3;
  press.record_every = kTime / 200;
  press.error_tolerance = 1e-4;
  press.load_factor = {Vec2(0, 0), Vec2(kTime, 1)};
  model.motions = {press};
  return model;
}

}  // namespace lissom::scene_models
