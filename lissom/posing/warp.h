#pragma once
/// A smooth motion of space that takes given places to others: how somebody drags a drawing into another shape.

#include <array>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/core/types.h"

namespace lissom {

/// x + A x + b + sum_i w_i |x - from_i|, which moves each from_i to its to_i: the polyharmonic spline r with
/// linear part, sum w_i = 0 and sum w_i from_i = 0 [Wendland 2005, chapter 8]. Where all places lie in a plane, what is off
/// it goes along.
class Warp {
 public:
  /// kGeometry at `where`/3 and the like for a place that appears twice; kRange for numbers that are not finite.
  static Result<Warp> make(std::vector<std::array<Vec3, 2>> pairs, const std::string& where);

  Vec3 operator()(const Vec3& x) const;  ///< m

 private:
  Warp() = default;
  std::vector<Vec3> from_;
  MatX weight_;                         // (n x 3)
  Eigen::Matrix<double, 4, 3> affine_;  // of (1, x): displacement
};

}  // namespace lissom
