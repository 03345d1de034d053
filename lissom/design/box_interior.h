#pragma once
/// Quadratic models over a box by interior points: what projected Newton steps turn to when many bounds are met or curvatures span
/// many decades. Ten to thirty factorisations whatever the problem; near the end, not at it.

#include "lissom/core/types.h"

namespace lissom {

struct BoxInterior {
  VecX x;                       ///< strictly within the bounds that are apart
  VecX push_lower, push_upper;  ///< multipliers of the bounds, > 0; 0 for infinite ones
  int factorizations = 0;
};

/// min 1/2 x'Bx + g'x over lower <= x <= upper, B (m x m) positive semidefinite but for `damping` that is to be added to its
/// diagonal, by a predictor and a corrector per factorisation [Mehrotra 1992; Nocedal & Wright 2006, 16.6]. Bounds may be
/// infinite or equal. Ends when complementarity and the gradient of the Lagrangian have fallen below `tolerance`, relative to
/// their first values, or no longer fall.
BoxInterior solve_box_interior(const MatX& b, double damping, const VecX& g, const VecX& lower, const VecX& upper,
                               double tolerance = 1e-9);

}  // namespace lissom
