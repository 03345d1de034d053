#pragma once
/// Quadratic model of an objective over a box: the subproblem of every step of an inverse design [mathematics 5.4 (b)].

#include <vector>

#include "lissom/core/types.h"

namespace lissom {

struct BoxQpSolution {
  VecX x;                         ///< within the bounds
  std::vector<bool> at_bound;     ///< where the gradient holds x at its bound
  double projected_gradient = 0;  ///< largest entry of the gradient that no bound holds
  double damping = 0;             ///< added to the diagonal because B was not positive definite on the free parameters
  int iterations = 0;
  int factorizations = 0;
  bool converged = false;
};

/// min 1/2 x'Bx + g'x over lower <= x <= upper by projected Newton steps: a Newton step in the parameters that are not held
/// at a bound, along which the others stay and all are clipped, with Armijo's rule [Bertsekas 1982]. Bounds may be infinite or
/// equal. `b` (m x m, symmetric) need not be positive definite: what is missing is added to its diagonal and reported.
BoxQpSolution solve_box_qp(const MatX& b, const VecX& g, const VecX& lower, const VecX& upper, double tolerance = 1e-10,
                           int max_iterations = 200);

}  // namespace lissom
