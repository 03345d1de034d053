/// Inverse problems of structures: derivatives over several poses against equilibria solved again, and points that are taken up
/// again to the last bit.

#include "lissom/design/structure_problem.h"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <utility>

#include "tests/regression/honeycomb.h"

namespace lissom {
namespace {

using samples::honeycomb;
using samples::honeycomb_problem;

/// Moves the point to uneven parameters.
void go_uneven(StructureProblem& problem) {
  VecX x = problem.x();
  for (int i = 0; i < x.size(); ++i) x[i] += 0.3 * std::sin(1.0 + 2.3 * i);
  const Attempt attempt = problem.attempt(x);
  ASSERT_EQ(attempt.outcome, Outcome::kSettled) << attempt.reason;
  problem.accept();
}

VecX direction(int size) {
  VecX v(size);
  for (int i = 0; i < size; ++i) v[i] = std::cos(0.7 + 1.9 * i);
  return v / v.norm();
}

void expect_derivatives(JointKind joints) {
  const std::unique_ptr<StructureProblem> problem = honeycomb_problem(honeycomb(joints));
  const Status released = problem->release();
  ASSERT_TRUE(released) << released.error().text();
  go_uneven(*problem);
  const VecX x = problem->x(), v = direction(problem->size());
  const VecX gradient = problem->gradient(), product = problem->hessian_times(v), along = problem->jacobian_times(v);
  const DesignPoint point = problem->point();

  // Dense and matrix-free derivatives agree.
  EXPECT_LT((problem->gram() * v - problem->jacobian_transposed_times(along)).norm(),
            1e-9 * (problem->gram() * v).norm());
  EXPECT_LT((problem->jacobian_transposed_times(problem->residual()) - gradient).norm(), 1e-9 * gradient.norm());

  // Against equilibria solved again: central differences, extrapolated once.
  VecX residual_change[2], gradient_change[2];
  double value_change[2];
  for (int level = 0; level < 2; ++level) {
    const double step = 4e-2 / (level + 1);
    VecX residuals[2], gradients[2];
    double values[2];
    for (int side = 0; side < 2; ++side) {
      const Attempt attempt = problem->attempt(x + (side == 0 ? -step : step) * v);
      ASSERT_EQ(attempt.outcome, Outcome::kSettled) << attempt.reason;
      values[side] = attempt.value;
      problem->accept();
      residuals[side] = problem->residual();
      gradients[side] = problem->gradient();
      ASSERT_TRUE(problem->restore(point));
    }
    residual_change[level] = (residuals[1] - residuals[0]) / (2 * step);
    gradient_change[level] = (gradients[1] - gradients[0]) / (2 * step);
    value_change[level] = (values[1] - values[0]) / (2 * step);
  }
  const double value_again = (4 * value_change[1] - value_change[0]) / 3;
  EXPECT_NEAR(gradient.dot(v), value_again, 1e-7 * gradient.norm());
  const VecX residual_again = (4 * residual_change[1] - residual_change[0]) / 3;
  EXPECT_LT((along - residual_again).norm(), 1e-6 * residual_again.norm());
  const VecX product_again = (4 * gradient_change[1] - gradient_change[0]) / 3;
  EXPECT_LT((product - product_again).norm(), 1e-5 * product_again.norm());
  // The part beyond Gauss-Newton is there to be seen.
  EXPECT_GT((product - problem->gram() * v).norm(), 1e-2 * product.norm());
}

TEST(StructureProblem, DerivativesWithExplicitJoints) { expect_derivatives(JointKind::kExplicit); }
TEST(StructureProblem, DerivativesWithCorotationalJoints) { expect_derivatives(JointKind::kCorotational); }

/// A fixed walk over the parameters.
std::vector<double> walk(StructureProblem& problem, int from, int to) {
  std::vector<double> values;
  for (int k = from; k < to; ++k) {
    VecX x = problem.x();
    for (int i = 0; i < x.size(); ++i) x[i] += 0.1 * std::sin(1.0 + 1.3 * i + 2.1 * k);
    // An attempt that is not accepted leaves no trace.
    EXPECT_EQ(problem.attempt(x + 0.05 * direction(problem.size())).outcome, Outcome::kSettled);
    const VecX tried = problem.jacobian_transposed_times(problem.attempted_residual());
    EXPECT_EQ(problem.attempt(x).outcome, Outcome::kSettled);
    problem.accept();
    values.push_back(problem.value());
    values.push_back(problem.gradient().sum());
    values.push_back(tried.sum());
  }
  return values;
}

TEST(StructureProblem, GoesOnFromASavedPointToTheLastBit) {
  const Model model = honeycomb(JointKind::kExplicit);
  const std::unique_ptr<StructureProblem> whole = honeycomb_problem(model);
  ASSERT_TRUE(whole->release());
  walk(*whole, 0, 2);
  const DesignPoint point = whole->point();
  const std::vector<double> expected = walk(*whole, 2, 4);
  const std::unique_ptr<StructureProblem> resumed = honeycomb_problem(model);
  const Status restored = resumed->restore(point);
  ASSERT_TRUE(restored) << restored.error().text();
  EXPECT_EQ(walk(*resumed, 2, 4), expected);
  ThreadPool threads(3);
  const std::unique_ptr<StructureProblem> threaded = honeycomb_problem(model, &threads);
  ASSERT_TRUE(threaded->restore(point));
  EXPECT_EQ(walk(*threaded, 2, 4), expected);
}

TEST(StructureProblem, StartsThatCannotBeAreNamed) {
  Model model = honeycomb(JointKind::kExplicit);
  Selector all;
  all.kind = Selector::Kind::kAll;
  model.poses[1].forces.push_back({all, Vec3(0, 0, -1e7), false, Scaling::kProportional});
  const std::unique_ptr<StructureProblem> problem = honeycomb_problem(model);
  const Status released = problem->release();
  ASSERT_FALSE(released);
  EXPECT_EQ(released.error().where, "/poses/1");
  EXPECT_NE(released.error().message.find("pose \"pulled\""), std::string::npos) << released.error().message;
}

}  // namespace
}  // namespace lissom
