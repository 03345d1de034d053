#include <algorithm>
#include <cmath>

#include "lissom/geometry/planar_patterns.h"
#include "scenes/object_surfaces.h"

namespace lissom::scene_models {

namespace {

constexpr double kWidth = 0.25;  // m
constexpr int kCells = 72;
constexpr double kSoft = 0.008;  // m, over which paint fades

/// 1 inside, 0 outside of a shape from which x is `distance` (m) away, negative inside.
double paint(double distance) { return std::clamp(0.5 - distance / kSoft, 0.0, 1.0); }

double darkness(const Vec2& x) {
  const double face = 0.35 * paint(x.norm() - 0.105);
  const double eyes = paint((Vec2(std::abs(x[0]), x[1]) - Vec2(0.04, 0.035)).norm() - 0.016);
  const Vec2 along(std::clamp(x[0], -0.05, 0.05), -0.042);
  const double mouth = paint((x - along).norm() - 0.010);
  return std::max({face, eyes, mouth});
}

}  // namespace

Surface face_surface() {
  const PlanarTriangles grid = grid_triangles(Vec2::Constant(-0.5 * kWidth), Vec2::Constant(kWidth), kCells, kCells);
  Surface sheet;
  for (const Vec2& x : grid.points) {
    sheet.vertices.emplace_back(x[0], x[1], 0);
    sheet.darkness.push_back(darkness(x));
  }
  sheet.triangles = grid.triangles;
  return sheet;
}

}  // namespace lissom::scene_models
