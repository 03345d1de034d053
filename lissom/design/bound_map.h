#pragma once
/// Parameters that cannot leave their bounds: p = phi(u) with phi: R -> (lower, upper), so that a method without bounds may
/// work on u [mathematics 6.3; the thesis before (6.5) has the direction of the map inverted, erratum E26].

#include "lissom/core/types.h"

namespace lissom {

/// phi(u) = middle + range / pi * arctan(pi u / range), one by one; the identity where there are no bounds. Its slope is 1 in
/// the middle and falls to 0 at the bounds, where nothing can be learned about a parameter: `inside` keeps away from them.
class BoundMap {
 public:
  /// Bounds of each parameter, lower < upper, both finite or both infinite.
  BoundMap(VecX lower, VecX upper);

  int size() const { return static_cast<int>(lower_.size()); }

  VecX parameters(const VecX& u) const;
  /// u of parameters strictly within their bounds.
  VecX unbounded(const VecX& p) const;
  /// d p / d u and d^2 p / d u^2, the diagonals.
  VecX slope(const VecX& u) const;
  VecX curvature(const VecX& u) const;

  /// p, moved to at least `share` of the range away from its bounds.
  VecX inside(const VecX& p, double share = 1e-3) const;
  /// p, moved to the bounds where it is beyond them.
  VecX clamped(const VecX& p) const { return p.cwiseMax(lower_).cwiseMin(upper_); }

 private:
  bool bounded(int i) const;

  VecX lower_, upper_;
};

}  // namespace lissom
