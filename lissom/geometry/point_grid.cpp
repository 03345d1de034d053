#include "lissom/geometry/point_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lissom {

PointGrid::PointGrid(double distance, double cell, size_t expected)
    : distance_(distance), inverse_cell_(1 / std::max(cell, 2 * distance)) {
  size_t slots = 16;
  while (slots < 2 * expected) slots *= 2;
  head_.assign(slots, -1);
  points_.reserve(expected);
  next_.reserve(expected);
}

size_t PointGrid::slot(int64_t x, int64_t y, int64_t z) const {
  uint64_t h = static_cast<uint64_t>(x) * 0x9E3779B97F4A7C15u;
  h = (h ^ (h >> 29) ^ static_cast<uint64_t>(y)) * 0xBF58476D1CE4E5B9u;
  h = (h ^ (h >> 32) ^ static_cast<uint64_t>(z)) * 0x94D049BB133111EBu;
  return static_cast<size_t>(h ^ (h >> 31)) & (head_.size() - 1);
}

int PointGrid::insert(const Vec3& p) {
  if (points_.empty()) origin_ = p;
  // The shift keeps regular grids off the cell borders, where up to eight cells would have to be searched.
  const Vec3 shift(0.3819660, 0.4142136, 0.3027756);
  const auto cell = [&](double offset) -> Eigen::Matrix<int64_t, 3, 1> {
    return (((p - origin_).array() + offset) * inverse_cell_ + shift.array()).floor().cast<int64_t>();
  };
  const auto low = cell(-distance_), high = cell(distance_), own = cell(0);
  int first = std::numeric_limits<int>::max();
  for (int64_t x = low.x(); x <= high.x(); ++x) {
    for (int64_t y = low.y(); y <= high.y(); ++y) {
      for (int64_t z = low.z(); z <= high.z(); ++z) {
        for (int i = head_[slot(x, y, z)]; i >= 0; i = next_[static_cast<size_t>(i)]) {
          if (i < first && (points_[static_cast<size_t>(i)] - p).norm() <= distance_) first = i;
        }
      }
    }
  }
  if (first != std::numeric_limits<int>::max()) return first;
  const int number = static_cast<int>(points_.size());
  int& head = head_[slot(own.x(), own.y(), own.z())];
  points_.push_back(p);
  next_.push_back(head);
  head = number;
  return number;
}

}  // namespace lissom
