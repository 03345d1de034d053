#pragma once
/// Merges points that coincide: a spatial hash that answers "is there a point here already?" in constant time.

#include <cstdint>
#include <vector>

#include "lissom/core/types.h"

namespace lissom {

class PointGrid {
 public:
  /// Points within `distance` (m) are one. `cell` (m, at least 2 distance) is about the spacing of the points;
  /// `expected` their number.
  PointGrid(double distance, double cell, size_t expected);

  /// Number of the first point stored within the distance of `p`; stores `p` when there is none.
  int insert(const Vec3& p);

  const std::vector<Vec3>& points() const { return points_; }

 private:
  size_t slot(int64_t x, int64_t y, int64_t z) const;

  double distance_, inverse_cell_;
  Vec3 origin_ = Vec3::Zero();  ///< first point: cells are counted from there, so that far places need no large numbers
  std::vector<Vec3> points_;
  std::vector<int> head_, next_;  ///< chains of points by slot
};

}  // namespace lissom
