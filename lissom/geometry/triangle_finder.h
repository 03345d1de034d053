#pragma once
/// Which triangle of a flat mesh holds a point: a grid of buckets.

#include <array>
#include <span>
#include <vector>

#include "lissom/core/types.h"

namespace lissom {

class TriangleFinder {
 public:
  /// Triangles anticlockwise; at least one. Points and triangles have to outlive the finder.
  TriangleFinder(std::span<const Vec2> points, std::span<const std::array<int, 3>> triangles);

  struct Place {
    int triangle = 0;
    Vec3 weight = Vec3::Zero();  ///< barycentric; negative entries where the point lies outside
  };
  /// The triangle that holds `p`, or the one nearest to holding it among those around; of several the first.
  Place find(const Vec2& p) const;

 private:
  Vec3 weights(int triangle, const Vec2& p) const;
  int cell(double value, int axis) const;

  std::span<const Vec2> points_;
  std::span<const std::array<int, 3>> triangles_;
  Vec2 low_ = Vec2::Zero();
  double width_ = 1;  // m, of a cell
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<int>> in_cell_;
};

}  // namespace lissom
