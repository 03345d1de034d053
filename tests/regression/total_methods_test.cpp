/// Methods in total space against those of the reduced problem: the same minimisers, at the pace that theory has, and ends that
/// say what became of states that nobody kept in equilibrium.

#include "lissom/design/total_methods.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <string>

#include "tests/regression/honeycomb.h"
#include "tests/regression/total_samples.h"

namespace lissom {
namespace {

using total::distance;
using total::reduced_minimiser;

TotalResult run(StructureProblem& problem, const TotalOptions& options) {
  Result<TotalResult> result = minimize_in_total_space(problem, options, {});
  EXPECT_TRUE(result) << (result ? "" : result.error().text());
  return std::move(result).value();
}

std::string figures(const TotalResult& r) {
  std::string text = std::to_string(r.iterations) + " " + r.message + "\n";
  for (const TotalRecord& i : r.records) {
    if (r.records.size() > 40 && i.iteration % 16 != 0) continue;
    char line[240];
    std::snprintf(
        line, sizeof line,
        "%3d h %.6e forces %.2e gradient %.2e negative %d step %.2e x %.3g slope %.1e penalty %.1e damping %.1e\n",
        i.iteration, i.value, i.imbalance, i.gradient, i.negative, i.step_length, i.fraction, i.merit_slope, i.penalty,
        i.damping);
    text += line;
  }
  return text;
}

struct Asked {
  TotalMethod method;
  PenaltyNorm norm;
  const char* name;
  double close = 1e-6;  ///< scales, to the minimiser
};
constexpr Asked kAll[] = {
    {TotalMethod::kLagrangeNewton, PenaltyNorm::kEnergy, "LagrangeNewton"},
    {TotalMethod::kLagrangeGaussNewton, PenaltyNorm::kEnergy, "LagrangeGaussNewton"},
    {TotalMethod::kPenalty, PenaltyNorm::kEnergy, "PenaltyOfEnergy"},
    {TotalMethod::kPenalty, PenaltyNorm::kForce, "PenaltyOfForces", 1e-4},
    {TotalMethod::kAugmentedLagrangian, PenaltyNorm::kEnergy, "AugmentedLagrangianOfEnergy"},
    {TotalMethod::kAugmentedLagrangian, PenaltyNorm::kForce, "AugmentedLagrangianOfForces"},
};

class AllTotalMethods : public testing::TestWithParam<Asked> {
 protected:
  static TotalOptions options() {
    return {.method = GetParam().method, .max_iterations = 500, .gradient_tolerance = 1e-10, .norm = GetParam().norm};
  }

  /// Where residuals stay, the plain penalty has to rise until rounding of stiff forces, times that, is all that F shows: it
  /// ends just before what solves accept, a little off the minimiser.
  static void expect_end(const TotalResult& r) {
    const bool plain = GetParam().method == TotalMethod::kPenalty && GetParam().norm == PenaltyNorm::kForce;
    if (plain && r.verdict == TotalVerdict::kStalled) {
      EXPECT_LT(r.imbalance, 100);
    } else {
      EXPECT_EQ(r.verdict, TotalVerdict::kConverged);
    }
  }
};
INSTANTIATE_TEST_SUITE_P(Each, AllTotalMethods, testing::ValuesIn(kAll),
                         [](const auto& asked) { return std::string(asked.param.name); });

TEST_P(AllTotalMethods, ReachRadiiThatMakeTheShape) {
  const auto problem = total::cantilever_problem(0);
  const VecX wanted = total::wanted_radii().cwiseQuotient(problem->p().cwiseQuotient(problem->x()));
  ASSERT_GT(distance(wanted, problem->x()), 0.1);
  const double first = problem->value();
  const TotalResult r = run(*problem, options());
  SCOPED_TRACE(figures(r));
  EXPECT_EQ(r.verdict, TotalVerdict::kConverged);
  ASSERT_EQ(r.settled, Outcome::kSettled) << r.settled_reason;
  EXPECT_LE(r.imbalance, 1);
  EXPECT_EQ(r.negative, 0);
  EXPECT_LT(distance(problem->x(), wanted), 1e-6);
  EXPECT_LT(r.settled_value, 1e-12 * first);
  EXPECT_LT(r.settled_move, 1e-9);
}

TEST_P(AllTotalMethods, ReachTheMinimiserOfTheReducedProblem) {
  const auto reference = total::cantilever_problem(2e-3), problem = total::cantilever_problem(2e-3);
  const VecX wanted = reduced_minimiser(*reference);
  const TotalResult r = run(*problem, options());
  SCOPED_TRACE(figures(r));
  ASSERT_EQ(r.settled, Outcome::kSettled) << r.settled_reason;
  expect_end(r);
  EXPECT_LT(distance(problem->x(), wanted), GetParam().close);
  EXPECT_NEAR(r.settled_value, reference->value(), 1e-9 * reference->value());
}

TEST_P(AllTotalMethods, KeepParametersWithinBounds) {
  const Vec2 range(2.2e-3, 2.6e-3);
  const auto reference = total::cantilever_problem(0, range), problem = total::cantilever_problem(0, range);
  const VecX wanted = reduced_minimiser(*reference);
  const TotalResult r = run(*problem, options());
  SCOPED_TRACE(figures(r));
  expect_end(r);
  ASSERT_EQ(r.settled, Outcome::kSettled) << r.settled_reason;
  EXPECT_LT(distance(problem->x(), wanted), GetParam().close);
  int held = 0;
  for (int i = 0; i < problem->size(); ++i) {
    EXPECT_GE(problem->x()[i], problem->lower()[i]);
    EXPECT_LE(problem->x()[i], problem->upper()[i]);
    held += problem->x()[i] == problem->lower()[i] || problem->x()[i] == problem->upper()[i];
  }
  EXPECT_GE(held, 2);
}

/// A strut that should be straight and cannot be: in total space the straight one is an equilibrium like any other, which
/// penalties find from afar; Lagrange's steps stay near equilibria, and with them on the branch of the start.
TEST_P(AllTotalMethods, SayWhetherTheStateIsStable) {
  const auto problem = total::strut_problem();
  const double first = problem->value();
  const TotalResult r = run(*problem, options());
  SCOPED_TRACE(figures(r));
  EXPECT_EQ(r.verdict, TotalVerdict::kConverged);
  EXPECT_LE(r.imbalance, 1);
  ASSERT_EQ(r.settled, Outcome::kSettled) << r.settled_reason;
  EXPECT_EQ(r.settled_value, problem->value());
  EXPECT_GT(r.settled_value, 0.1 * first);
  const bool penalty =
      GetParam().method == TotalMethod::kPenalty || GetParam().method == TotalMethod::kAugmentedLagrangian;
  if (penalty) {
    EXPECT_LT(r.value, 1e-6 * first);
    EXPECT_GT(r.negative, 0);
    EXPECT_GT(r.settled_move, 0.1 * total::kLength);
  } else {
    EXPECT_EQ(r.negative, 0);
    EXPECT_LT(r.settled_value, first);
    EXPECT_NEAR(r.settled_value, r.value, 1e-9 * r.value);
  }
}

TEST_P(AllTotalMethods, EndWithAVerdictWhenIterationsRunOut) {
  const auto problem = total::cantilever_problem(0);
  TotalOptions o = options();
  o.max_iterations = 2;
  const TotalResult r = run(*problem, o);
  EXPECT_EQ(r.verdict, TotalVerdict::kIterationLimit);
  EXPECT_EQ(r.iterations, 2);
  EXPECT_NE(r.message.find(r.imbalance > 1 ? "are left" : "is left"), std::string::npos) << r.message;
  ASSERT_EQ(r.settled, Outcome::kSettled) << r.settled_reason;
  EXPECT_TRUE(problem->x().allFinite());
  EXPECT_GT(r.effort.factorizations, 0);
}

TEST(LagrangeNewton, ConvergesQuadratically) {
  const auto problem = total::cantilever_problem(2e-3);
  const TotalResult exact = run(*problem, {.gradient_tolerance = 1e-10});
  SCOPED_TRACE(figures(exact));
  ASSERT_EQ(exact.verdict, TotalVerdict::kConverged);
  EXPECT_LE(exact.iterations, 8);
  ASSERT_GE(exact.iterations, 4);
  // Of the last steps each is of the order of the square of the one before, in scales.
  for (int i = exact.iterations - 2; i < exact.iterations; ++i) {
    const double before = exact.records[i - 1].step_length, after = exact.records[i].step_length;
    EXPECT_LT(after, 2 * before * before) << i;
    EXPECT_EQ(exact.records[i].fraction, 1);
  }
  // Without second derivatives of forces residuals that stay make it linear, at a constant rate.
  const auto again = total::cantilever_problem(2e-3);
  const TotalResult half = run(*again, {.method = TotalMethod::kLagrangeGaussNewton, .gradient_tolerance = 1e-10});
  SCOPED_TRACE(figures(half));
  ASSERT_EQ(half.verdict, TotalVerdict::kConverged);
  EXPECT_GT(half.iterations, 2 * exact.iterations);
  const std::size_t last = half.records.size() - 1;
  EXPECT_NEAR(half.records[last].step_length / half.records[last - 1].step_length,
              half.records[last - 1].step_length / half.records[last - 2].step_length, 0.05);
}

TEST(LagrangeNewton, ServesNetworksWithJointsInSeveralPoses) {
  for (const JointKind joints : {JointKind::kExplicit, JointKind::kCorotational}) {
    const auto reference = samples::honeycomb_problem(samples::honeycomb(joints));
    const auto problem = samples::honeycomb_problem(samples::honeycomb(joints));
    ASSERT_TRUE(reference->release());
    ASSERT_TRUE(problem->release());
    const VecX wanted = reduced_minimiser(*reference);
    const TotalResult r = run(*problem, {.gradient_tolerance = 1e-10});
    SCOPED_TRACE(figures(r));
    EXPECT_EQ(r.verdict, TotalVerdict::kConverged);
    ASSERT_EQ(r.settled, Outcome::kSettled) << r.settled_reason;
    EXPECT_NEAR(r.settled_value, reference->value(), 1e-9 * reference->value());
    EXPECT_LT(distance(problem->x(), wanted), 1e-5);
  }
}

TEST(LagrangeNewton, NamesAPoseWithoutStiffness) {
  const auto problem = total::round_strut_problem();
  const VecX start = problem->x();
  const double first = problem->value();
  const TotalResult r = run(*problem, {.gradient_tolerance = 1e-10});
  SCOPED_TRACE(figures(r));
  EXPECT_EQ(r.verdict, TotalVerdict::kSingular);
  EXPECT_NE(r.message.find("pose \"loaded\": the stiffness matrix is singular"), std::string::npos) << r.message;
  EXPECT_TRUE(std::isfinite(r.value) && std::isfinite(r.imbalance) && std::isfinite(r.gradient));
  EXPECT_TRUE(r.point.p.allFinite());
  EXPECT_EQ(r.settled, Outcome::kUnstable);
  EXPECT_NE(r.settled_reason.find("no energy"), std::string::npos) << r.settled_reason;
  // What cannot be built on is not handed on.
  EXPECT_EQ(problem->x(), start);
  EXPECT_DOUBLE_EQ(problem->value(), first);
}

TEST(Penalty, ThatMayNotRiseLeavesForces) {
  const auto problem = total::cantilever_problem(2e-3);
  const TotalResult r = run(*problem, {.method = TotalMethod::kPenalty, .largest_penalty = 1});
  SCOPED_TRACE(figures(r));
  EXPECT_EQ(r.verdict, TotalVerdict::kPenaltyLimit);
  EXPECT_GT(r.imbalance, 1);
  EXPECT_NE(r.message.find("pose \""), std::string::npos) << r.message;
  ASSERT_EQ(r.settled, Outcome::kSettled) << r.settled_reason;
  EXPECT_GT(r.settled_value, r.value);
}

TEST(TotalMethods, RefuseOptionsOutOfRange) {
  const auto problem = total::cantilever_problem(0);
  const auto refused = minimize_in_total_space(*problem, {.penalty_growth = 1}, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().where, "penalty_growth");
}

TEST(TotalMethods, StopWhenTold) {
  const auto problem = total::cantilever_problem(0);
  const VecX x = problem->x();
  std::atomic<bool> cancel = true;
  Context context;
  context.cancel = &cancel;
  const auto r = minimize_in_total_space(*problem, {}, context);
  ASSERT_TRUE(r);
  EXPECT_EQ(r.value().verdict, TotalVerdict::kCancelled);
  EXPECT_EQ(problem->x(), x);
}

}  // namespace
}  // namespace lissom
