/// Inverse problems of structures: derivatives over several poses against equilibria solved again, and points that are taken up
/// again to the last bit.

#include "lissom/design/structure_problem.h"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <utility>

#include "tests/regression/exact_derivatives.h"
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
  expect_exact_derivatives(*problem, direction(problem->size()), 4e-2);
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
