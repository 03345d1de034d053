#pragma once
/// Least squares over a box of which some count on one side only: the subproblem of Gauss-Newton's method with wishes that
/// are inequalities. What a step brings to count is seen before it is taken.

#include <functional>

#include "lissom/core/types.h"
#include "lissom/design/box_cg.h"
#include "lissom/design/reduced_problem.h"

namespace lissom {

/// Lowers 1/2 x'Hx + g'x + k(x) over lower <= x <= upper, 0 among them, from x = 0. H and g have those of `sided` that count at 0
/// as if they counted everywhere, and k takes that back: 1/2 sum of max(0, t)^2 - [t(0) > 0] t^2 + constants, t = value + rows x.
/// Rounds of solve_box_cg with those that count where a round begins, each followed as far as the whole falls [Mangasarian 2004].
/// `decrease` is that of the whole.
BoxCgSolution solve_one_sided_cg(const std::function<VecX(const VecX&)>& times, const VecX& g, const OneSided& sided,
                                 const VecX& lower, const VecX& upper, double tolerance, int max_products);

}  // namespace lissom
