#include "lissom/geometry/triangle_finder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lissom/core/assert.h"

namespace lissom {

TriangleFinder::TriangleFinder(std::span<const Vec2> points, std::span<const std::array<int, 3>> triangles)
    : points_(points), triangles_(triangles) {
  LISSOM_ASSERT(!triangles.empty());
  low_ = points[static_cast<std::size_t>(triangles[0][0])];
  Vec2 high = low_;
  for (const Vec2& p : points) {
    low_ = low_.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec2 size = high - low_;
  width_ = std::max(std::sqrt(size.x() * size.y() / static_cast<double>(triangles.size())), 1e-3 * size.maxCoeff());
  columns_ = static_cast<int>(size.x() / width_) + 1;
  rows_ = static_cast<int>(size.y() / width_) + 1;
  in_cell_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    Vec2 least = points[triangles[t][0]], most = least;
    for (const int corner : triangles[t]) {
      least = least.cwiseMin(points[corner]);
      most = most.cwiseMax(points[corner]);
    }
    for (int j = cell(least.y(), 1); j <= cell(most.y(), 1); ++j) {
      for (int i = cell(least.x(), 0); i <= cell(most.x(), 0); ++i) in_cell_[j * columns_ + i].push_back(t);
    }
  }
}

int TriangleFinder::cell(double value, int axis) const {
  const int last = (axis == 0 ? columns_ : rows_) - 1;
  return static_cast<int>(std::clamp((value - low_[axis]) / width_, 0.0, static_cast<double>(last)));
}

Vec3 TriangleFinder::weights(int triangle, const Vec2& p) const {
  const Vec2 &a = points_[triangles_[triangle][0]], &b = points_[triangles_[triangle][1]],
             &c = points_[triangles_[triangle][2]];
  const auto twice = [](const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); };
  const double whole = twice(b - a, c - a);
  const Vec3 parts(twice(b - p, c - p), twice(c - p, a - p), twice(a - p, b - p));
  return parts / whole;
}

TriangleFinder::Place TriangleFinder::find(const Vec2& p) const {
  const int column = cell(p.x(), 0), row = cell(p.y(), 1);
  Place best;
  double deepest = -std::numeric_limits<double>::infinity();
  // Rings of cells around the point, one further than the first that has a triangle.
  for (int ring = 0, enough = std::max(columns_, rows_); ring <= enough; ++ring) {
    for (int j = std::max(row - ring, 0); j <= std::min(row + ring, rows_ - 1); ++j) {
      for (int i = std::max(column - ring, 0); i <= std::min(column + ring, columns_ - 1); ++i) {
        if (std::max(std::abs(i - column), std::abs(j - row)) != ring) continue;
        for (const int t : in_cell_[j * columns_ + i]) {
          const Vec3 weight = weights(t, p);
          if (!(weight.minCoeff() > deepest)) continue;
          deepest = weight.minCoeff();
          best = {t, weight};
        }
      }
    }
    if (deepest >= 0) return best;
    if (deepest > -std::numeric_limits<double>::infinity()) enough = std::min(enough, ring + 1);
  }
  return best;
}

}  // namespace lissom
