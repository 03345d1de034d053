#pragma once
/// Quadratic model of an objective over a box when only products with its Hessian can be had: the subproblem of exact Newton.

#include <functional>

#include "lissom/core/types.h"

namespace lissom {

struct BoxCgSolution {
  VecX x;                    ///< within the bounds
  double decrease = 0;       ///< of the model, >= 0
  double gradient_left = 0;  ///< largest entry of the gradient of the model that no bound holds
  int products = 0;
  bool negative_curvature = false;  ///< met on the way
};

/// Lowers 1/2 x'Hx + g'x over lower <= x <= upper, 0 among them, from x = 0 until no entry of the gradient that no bound holds
/// is above `tolerance`, or no products are left. On the parameters that no bound holds conjugate gradients run; their step is
/// clipped and halved until the model falls; then bounds are looked at again [after Lin & More 1999]. A direction of negative
/// curvature is followed to the first bound, so all parameters need bounds when there may be some: those of a trust region.
/// `like_h` (m x m, symmetric, or empty): preconditions with its part on the free parameters, made positive definite.
BoxCgSolution solve_box_cg(const std::function<VecX(const VecX&)>& times, const VecX& g, const VecX& lower,
                           const VecX& upper, const MatX& like_h, double tolerance, int max_products);

}  // namespace lissom
