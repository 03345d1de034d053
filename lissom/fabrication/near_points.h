#pragma once
/// Which of many points in space may be near each other: cells instead of all pairs.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "lissom/core/types.h"

namespace lissom {

/// Calls visit(i, j) for every pair of points within `distance` (m), and some that are farther apart; each pair once, always
/// in the same order.
template <class Visit>
void for_near_points(const std::vector<Vec3>& points, double distance, const Visit& visit) {
  using Cell = std::array<int, 3>;
  Vec3 low = Vec3::Constant(INFINITY);
  for (const Vec3& p : points) low = low.cwiseMin(p);
  std::vector<std::pair<Cell, int>> entries;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 at = (points[i] - low) / distance;
    entries.push_back({{int(at.x()), int(at.y()), int(at.z())}, static_cast<int>(i)});
  }
  std::sort(entries.begin(), entries.end());
  const auto start = [&](int x, int y, int z) {
    return std::lower_bound(entries.begin(), entries.end(), std::pair(Cell{x, y, z}, -1));
  };
  for (const auto& [cell, i] : entries) {
    for (int x = cell[0] - 1; x <= cell[0] + 1; ++x) {
      for (int y = cell[1] - 1; y <= cell[1] + 1; ++y) {
        const auto end = start(x, y, cell[2] + 2);
        for (auto it = start(x, y, cell[2] - 1); it != end; ++it) {
          if (it->second > i) visit(i, it->second);
        }
      }
    }
  }
}

}  // namespace lissom
