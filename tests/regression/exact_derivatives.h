#pragma once
/// Derivatives of an inverse problem against equilibria that are solved again.

#include <gtest/gtest.h>

#include "lissom/design/structure_problem.h"

namespace lissom {

/// Gradient, J v and Hessian v at the point against central differences over accepted attempts, extrapolated once: to 1e-7, 1e-6
/// and 1e-5. `step`: the longer one, in scales along the unit vector `v`.
inline void expect_exact_derivatives(StructureProblem& problem, const VecX& v, double step) {
  const VecX x = problem.x();
  const VecX gradient = problem.gradient(), product = problem.hessian_times(v), along = problem.jacobian_times(v);
  const DesignPoint point = problem.point();

  // Dense and matrix-free derivatives agree.
  EXPECT_LT((problem.gram() * v - problem.jacobian_transposed_times(along)).norm(), 1e-9 * (problem.gram() * v).norm());
  EXPECT_LT((problem.jacobian_transposed_times(problem.residual()) - gradient).norm(), 1e-9 * gradient.norm());
  // The part beyond Gauss-Newton is there to be seen.
  EXPECT_GT((product - problem.gram() * v).norm(), 1e-2 * product.norm());

  VecX residual_change[2], gradient_change[2];
  double value_change[2];
  for (int level = 0; level < 2; ++level) {
    const double length = step / (level + 1);
    VecX residuals[2], gradients[2];
    double values[2];
    for (int side = 0; side < 2; ++side) {
      const Attempt attempt = problem.attempt(x + (side == 0 ? -length : length) * v);
      ASSERT_EQ(attempt.outcome, Outcome::kSettled) << attempt.reason;
      values[side] = attempt.value;
      problem.accept();
      residuals[side] = problem.residual();
      gradients[side] = problem.gradient();
      ASSERT_TRUE(problem.restore(point));
    }
    residual_change[level] = (residuals[1] - residuals[0]) / (2 * length);
    gradient_change[level] = (gradients[1] - gradients[0]) / (2 * length);
    value_change[level] = (values[1] - values[0]) / (2 * length);
  }
  const double value_again = (4 * value_change[1] - value_change[0]) / 3;
  EXPECT_NEAR(gradient.dot(v), value_again, 1e-7 * gradient.norm());
  const VecX residual_again = (4 * residual_change[1] - residual_change[0]) / 3;
  EXPECT_LT((along - residual_again).norm(), 1e-6 * residual_again.norm());
  const VecX product_again = (4 * gradient_change[1] - gradient_change[0]) / 3;
  EXPECT_LT((product - product_again).norm(), 1e-5 * product_again.norm());
}

}  // namespace lissom
