#include "scenes/cells.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "scenes/parts.h"

namespace lissom::scene_models {

namespace {

constexpr double kRadius = 1e-3;  // m
constexpr int kEdges = 10;        // of a rod

}  // namespace

std::span<const CellShape> cell_shapes() {
  static constexpr std::array<CellShape, 3> kShapes{{{"triangle", 3, 2}, {"square", 4, 2}, {"hexagon", 6, 3}}};
  return kShapes;
}

std::vector<Vec2> cell_corners(const CellShape& shape) {
  std::vector<Vec2> corners{Vec2(-kCellSide / 2, 0)};
  for (int k = 1; k < shape.corners; ++k) {
    const double direction = 2 * std::numbers::pi * (k - 1) / shape.corners;
    corners.push_back(corners.back() + kCellSide * Vec2(std::cos(direction), std::sin(direction)));
  }
  return corners;
}

Support held_in_plane() {
  Selector all;
  all.kind = Selector::Kind::kAll;
  Support support = hold(all, SupportKind::kFree);
  support.directions = {Vec3::UnitZ()};
  return support;
}

Model moved_cell(const CellShape& shape, const Vec2& by) {
  ObjLines lines;
  for (const Vec2& x : cell_corners(shape)) lines.points.emplace_back(x[0], x[1], 0);
  for (int k = 0; k < shape.corners; ++k) lines.segments.push_back({k, (k + 1) % shape.corners});
  Model model = sheet(std::string(shape.name), lines, kRadius, "TPU 92A", kEdges);
  Pose pose;
  pose.name = "moved";
  pose.supports = {held_in_plane(), hold(at_point(lines.points[0]), SupportKind::kPin),
                   hold(at_point(lines.points[1]), SupportKind::kPin),
                   hold(at_point(lines.points[static_cast<std::size_t>(shape.moved)]), SupportKind::kPin)};
  pose.supports.back().move = Vec3(by[0], by[1], 0);
  model.poses = {pose};
  return model;
}

}  // namespace lissom::scene_models
