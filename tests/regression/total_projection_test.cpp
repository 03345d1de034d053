/// Projections onto equilibrium in total space: steps against the formulas they stand for, ends, and their service to the methods
/// of the reduced problem.

#include "lissom/design/total_projection.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <utility>

#include "lissom/design/optimizer.h"
#include "lissom/design/projected_problem.h"
#include "tests/regression/total_samples.h"

namespace lissom {
namespace {

using total::distance;
using total::leave;
using total::reduced_minimiser;
using total::space_of;

MatX dense_jacobian(const TotalSpace& space) {
  MatX j(space.states(), space.size());
  for (int i = 0; i < space.size(); ++i) j.col(i) = space.constraint_times(VecX::Unit(space.size(), i));
  return j;
}

TEST(TotalProjection, NormalFlowIsThePseudoInverse) {
  const auto problem = total::cantilever_problem(2e-3);
  const auto space = space_of(*problem);
  leave(*space, 0.3);
  const MatX j = dense_jacobian(*space);
  const VecX expected = -j.completeOrthogonalDecomposition().solve(space->constraint());
  const VecX d = projection_step(*space, {});
  EXPECT_LT((d - expected).norm(), 1e-6 * expected.norm());
  EXPECT_LT((j * d + space->constraint()).norm(), 1e-9 * space->constraint().norm());
  // Orthogonal to the null space of J, which S spans; and both parts move.
  MatX null(space->size(), space->parameters());
  null << space->sensitivity(), MatX::Identity(space->parameters(), space->parameters());
  for (int i = 0; i < null.cols(); ++i) EXPECT_LT(std::abs(null.col(i).dot(d)), 1e-9 * null.col(i).norm() * d.norm());
  EXPECT_GT(d.tail(space->parameters()).norm(), 1e-3 * d.norm());
}

TEST(TotalProjection, TargetWeightedStepIsThatOfTheFormula) {
  const auto problem = total::cantilever_problem(2e-3);
  const auto space = space_of(*problem);
  leave(*space, 0.3);
  // Stationarity of 1/2 |d|^2 + tau |r + R d|^2 + y'(J d + c), in one dense system.
  const double tau = 0.7;
  const int n = space->states(), size = space->size();
  MatX r(space->residual().size(), size);
  r << MatX(space->residual_by_state()), MatX(space->residual_by_x());
  MatX system = MatX::Zero(size + n, size + n);
  const MatX j = dense_jacobian(*space);
  system.topLeftCorner(size, size) = MatX::Identity(size, size) + 2 * tau * r.transpose() * r;
  system.topRightCorner(size, n) = j.transpose();
  system.bottomLeftCorner(n, size) = j;
  VecX right(size + n);
  right << -2 * tau * r.transpose() * space->residual(), -space->constraint();
  const VecX expected = system.fullPivLu().solve(right).head(size);
  const VecX d = projection_step(*space, {ProjectionRule::kTargetWeighted, tau});
  EXPECT_LT((d - expected).norm(), 1e-6 * expected.norm());
  EXPECT_GT((d - projection_step(*space, {})).norm(), 1e-2 * d.norm());
}

void expect_projection(const ProjectionOptions& options) {
  const auto problem = total::cantilever_problem(2e-3);
  const auto space = space_of(*problem);
  leave(*space, 0.3);
  const VecX x = space->x();
  const ProjectionEnd end = project(*space, options, {});
  ASSERT_TRUE(end.reached) << end.reason;
  EXPECT_LE(space->imbalance(), 1);
  EXPECT_EQ(space->negative(), 0);
  EXPECT_LE(end.iterations, 15);
  EXPECT_GT((space->x() - x).norm(), 1e-4);
  EXPECT_TRUE((space->x().array() >= space->lower().array()).all() &&
              (space->x().array() <= space->upper().array()).all());
  // It is where energy minimisation at these parameters stays.
  const DesignPoint found = space->point();
  const Status taken = problem->restore(found);
  ASSERT_TRUE(taken) << taken.error().text();
  const Attempt same = problem->attempt(problem->x());
  ASSERT_EQ(same.outcome, Outcome::kSettled) << same.reason;
  EXPECT_NEAR(same.value, space->value(), 1e-7 * space->value());
}

TEST(TotalProjection, NormalFlowEndsInEquilibrium) { expect_projection({}); }
TEST(TotalProjection, TargetWeightedEndsInEquilibrium) { expect_projection({ProjectionRule::kTargetWeighted, 0.1}); }

TEST(TotalProjection, BoundsHoldWithinAStep) {
  const auto problem = total::cantilever_problem(2e-3, {2.35e-3, 2.45e-3});
  const auto space = space_of(*problem);
  leave(*space, 0.3);
  const VecX d = projection_step(*space, {ProjectionRule::kTargetWeighted, 100});
  const VecX x = space->x() + d.tail(space->parameters());
  EXPECT_TRUE((x.array() >= space->lower().array() - 1e-12).all() &&
              (x.array() <= space->upper().array() + 1e-12).all());
  EXPECT_LT((x - space->lower()).cwiseMin(space->upper() - x).cwiseAbs().minCoeff(), 1e-12);
  EXPECT_LT((space->constraint_times(d) + space->constraint()).norm(), 1e-9 * space->constraint().norm());
}

TEST(TotalProjection, StatesThatAreNotStableAreNotEnds) {
  // The straight strut is in equilibrium with any radius.
  const auto problem = total::strut_problem();
  const auto space = space_of(*problem);
  DesignPoint straight = space->point();
  straight.states[0] = drawn_state(problem->design().system);
  straight.states[0].load_factor = 1;
  ASSERT_TRUE(space->stand_at(straight));
  const ProjectionEnd end = project(*space, {}, {});
  EXPECT_FALSE(end.reached);
  EXPECT_LE(space->imbalance(), 1);
  EXPECT_GT(space->negative(), 0);
  EXPECT_NE(end.reason.find("releases energy"), std::string::npos) << end.reason;
}

void expect_projected(const ProjectionOptions& options) {
  const auto reference = total::cantilever_problem(2e-3), problem = total::cantilever_problem(2e-3);
  const VecX wanted = reduced_minimiser(*reference);
  Result<std::unique_ptr<ProjectedProblem>> made = ProjectedProblem::make(*problem, options, {});
  ASSERT_TRUE(made) << made.error().text();
  ProjectedProblem& projected = *made.value();
  Optimizer optimizer(
      projected, {.max_iterations = 300, .gradient_tolerance = 1e-10, .decrease_tolerance = 0, .least_step = 1e-12});
  EXPECT_EQ(optimizer.run({}), DesignVerdict::kConverged) << optimizer.state().message;
  const ProjectionCounts& counts = projected.counts();
  EXPECT_LT(distance(projected.x(), wanted), 1e-6);
  EXPECT_NEAR(projected.value(), reference->value(), 1e-9 * reference->value());
  EXPECT_GT(counts.projected, counts.fallbacks);
  EXPECT_GT(counts.iterations, 0);
}

TEST(ProjectedProblem, NormalFlowServesAttempts) { expect_projected({}); }
TEST(ProjectedProblem, TargetWeightedServesAttempts) { expect_projected({ProjectionRule::kTargetWeighted, 0.01}); }

TEST(ProjectedProblem, AnAttemptMovesParametersAndKeepsWhatItSays) {
  const auto problem = total::cantilever_problem(2e-3);
  auto made = ProjectedProblem::make(*problem, {}, {});
  ASSERT_TRUE(made) << made.error().text();
  ProjectedProblem& projected = *made.value();
  const VecX x = projected.x() + 0.5 * total::some_vector(projected.size(), 0.8);
  const Attempt attempt = projected.attempt(x);
  ASSERT_EQ(attempt.outcome, Outcome::kSettled) << attempt.reason;
  ASSERT_EQ(projected.counts().projected, 1) << projected.counts().last_reason;
  const VecX landed = projected.attempted_x();
  EXPECT_GT(distance(landed, x), 1e-9);
  EXPECT_LT(distance(landed, x), 0.5 * distance(x, projected.x()));
  projected.accept();
  EXPECT_EQ(projected.x(), landed);
  EXPECT_DOUBLE_EQ(projected.value(), attempt.value);
}

TEST(ProjectedProblem, FallsBackToEnergyMinimisation) {
  const auto problem = total::cantilever_problem(2e-3), same = total::cantilever_problem(2e-3);
  auto made = ProjectedProblem::make(*problem, {.max_iterations = 1}, {});
  ASSERT_TRUE(made) << made.error().text();
  const VecX x = problem->x() + total::some_vector(problem->size(), 0.8);
  const Attempt attempt = made.value()->attempt(x), expected = same->attempt(x);
  ASSERT_EQ(attempt.outcome, Outcome::kSettled) << attempt.reason;
  EXPECT_EQ(made.value()->counts().fallbacks, 1);
  EXPECT_NE(made.value()->counts().last_reason.find("ran out"), std::string::npos);
  EXPECT_EQ(attempt.value, expected.value);
  made.value()->accept();
  EXPECT_LT(distance(problem->x(), x), 1e-14);
}

}  // namespace
}  // namespace lissom
