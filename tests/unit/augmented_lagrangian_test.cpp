#include "lissom/design/augmented_lagrangian.h"

#include <Eigen/LU>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "scenes/analytic_cases.h"
#include "tests/all_methods.h"

namespace lissom {
namespace {

constexpr ConstraintOptions kSharp{.tolerance = 1e-10};

/// As near to `wanted` as constraints allow.
AnalyticProblem near(const VecX& wanted, double bound = 10) {
  const int m = static_cast<int>(wanted.size());
  return {linear_functions(MatX::Identity(m, m), wanted), VecX::Constant(m, 0.3), VecX::Constant(m, -bound),
          VecX::Constant(m, bound)};
}

/// Within or on the unit circle.
SmoothFunctions circle() {
  return {[](const VecX& x) -> VecX { return VecX::Constant(1, x.squaredNorm() - 1); },
          [](const VecX& x) -> MatX { return 2 * x.transpose(); },
          [](const VecX& x, const VecX& w) -> MatX { return 2 * w[0] * MatX::Identity(x.size(), x.size()); }};
}

VecX solve(AnalyticProblem& problem, const OptimizeOptions& options, const ConstraintOptions& constraints,
           DesignVerdict wanted, ConstrainedState* end = nullptr) {
  Result<AugmentedLagrangian> outer = AugmentedLagrangian::begin(problem, options, constraints);
  EXPECT_TRUE(outer.ok());
  if (!outer.ok()) return {};
  EXPECT_EQ(outer.value().run({}), wanted)
      << design_method_name(options.method) << ": " << outer.value().state().message;
  if (end != nullptr) *end = outer.value().state();
  return problem.x();
}

TEST(AugmentedLagrangian, MeetsLinearEqualitiesExactly) {
  const VecX wanted = VecX::LinSpaced(5, -1, 2);
  MatX a(2, 5);
  a << 1, 1, 1, 1, 1, 1, -2, 0, 3, 1;
  const VecX b = Vec2(1, -0.5);
  const VecX solution = wanted - a.transpose() * (a * a.transpose()).inverse() * (a * wanted - b);
  for (const OptimizeOptions& options : all_methods(2000)) {
    AnalyticProblem problem = near(wanted);
    problem.set_constraints(linear_functions(a, b), {false, false});
    ConstrainedState end;
    const VecX x = solve(problem, options, kSharp, DesignVerdict::kConverged, &end);
    EXPECT_LT((x - solution).cwiseAbs().maxCoeff(), 1e-8) << design_method_name(options.method);
    // x - wanted + A' multipliers = 0
    EXPECT_LT((x - wanted + a.transpose() * end.multipliers).cwiseAbs().maxCoeff(), 1e-7);
    EXPECT_LE(end.round, 12);
  }
}

TEST(AugmentedLagrangian, MeetsCurvedConstraints) {
  const VecX solution = Vec2(2, 1).normalized();
  // Gauss-Newton does not know the curvature of the constraint: it creeps, until rounding of h hides its steps.
  const auto reached = [](const OptimizeOptions& o) {
    return o.method == DesignMethod::kGaussNewton || o.method == DesignMethod::kGaussNewtonProducts ? 1e-7 : 1e-8;
  };
  for (const bool inequality : {false, true}) {
    for (const OptimizeOptions& options : all_methods(2000)) {
      AnalyticProblem problem = near(Vec2(2, 1));
      problem.set_constraints(circle(), {inequality});
      const ConstraintOptions constraints{.tolerance = 0.01 * reached(options)};
      const VecX x = solve(problem, options, constraints, DesignVerdict::kConverged);
      EXPECT_LT((x - solution).cwiseAbs().maxCoeff(), reached(options)) << design_method_name(options.method);
    }
  }
}

TEST(AugmentedLagrangian, LetsInequalitiesRestThatHold) {
  for (const OptimizeOptions& options : all_methods(2000)) {
    AnalyticProblem problem = near(Vec2(0.3, 0.4));
    problem.put_at(Vec2(3, 2));
    problem.set_constraints(circle(), {true});
    ConstrainedState end;
    const VecX x = solve(problem, options, kSharp, DesignVerdict::kConverged, &end);
    EXPECT_LT((x - Vec2(0.3, 0.4)).cwiseAbs().maxCoeff(), 1e-8) << design_method_name(options.method);
    EXPECT_EQ(end.multipliers[0], 0);
  }
}

TEST(AugmentedLagrangian, WorksWithBounds) {
  for (const OptimizeOptions& options : all_methods(2000)) {
    AnalyticProblem problem = near(Vec2(2, 1), 0.8);  // the circle where x_0 = 0.8
    problem.set_constraints(circle(), {false});
    const VecX x = solve(problem, options, kSharp, DesignVerdict::kConverged);
    EXPECT_LT((x - Vec2(0.8, 0.6)).cwiseAbs().maxCoeff(), 1e-8) << design_method_name(options.method);
  }
}

TEST(AugmentedLagrangian, SaysWhatCannotBeMet) {
  MatX a(2, 2);
  a << 1, 1, 1, 1;
  for (const OptimizeOptions& options : all_methods(2000)) {
    AnalyticProblem contradiction = near(Vec2(0, 0)), too_far = near(Vec2(0, 0), 0.5);
    contradiction.set_constraints(linear_functions(a, Vec2(0, 1)), {false, false});
    ConstrainedState end;
    solve(contradiction, options, {}, DesignVerdict::kInfeasible, &end);
    EXPECT_NE(end.message.find("off by"), std::string::npos) << end.message;
    EXPECT_NEAR(end.violation, 0.5, 0.05);
    too_far.set_constraints(circle(), {false});
    solve(too_far, options, {}, DesignVerdict::kInfeasible, &end);
    EXPECT_NEAR(end.violation, 0.5, 1e-6);
  }
}

TEST(AugmentedLagrangian, DoesNotCallImpossibleWhatIsOnlyImprecise) {
  AnalyticProblem problem = near(Vec2(2, 1));
  problem.set_constraints(circle(), {false});
  OptimizeOptions options = all_methods(2000)[0];
  ConstrainedState end;
  solve(problem, options, {.tolerance = 1e-300}, DesignVerdict::kConstraintLimit, &end);
  EXPECT_LT(end.violation, 1e-7);
}

TEST(AugmentedLagrangian, RefusesMoreEqualitiesThanParameters) {
  MatX a(3, 2);
  a << 1, 0, 0, 1, 1, 1;
  AnalyticProblem problem = near(Vec2(0, 0));
  problem.set_constraints(linear_functions(a, Vec3(0, 0, 0)), {false, false, false});
  const Result<AugmentedLagrangian> outer = AugmentedLagrangian::begin(problem, {}, {});
  ASSERT_FALSE(outer.ok());
  EXPECT_EQ(outer.error().code, ErrorCode::kConflict);
  EXPECT_NE(outer.error().message.find("3 equality constraints"), std::string::npos) << outer.error().text();
  problem.set_constraints(linear_functions(a, Vec3(0, 0, 0)), {true, false, false});
  EXPECT_TRUE(AugmentedLagrangian::begin(problem, {}, {}).ok());
}

TEST(AugmentedLagrangian, RaisesThePenaltyOnlyWhenItMust) {
  AnalyticProblem problem = near(Vec2(2, 1));
  problem.set_constraints(circle(), {false});
  ConstrainedState strong, weak;
  OptimizeOptions options;
  options.gradient_tolerance = 1e-10;
  options.decrease_tolerance = 0;
  ConstraintOptions constraints = kSharp;
  constraints.first_penalty = 100;
  solve(problem, options, constraints, DesignVerdict::kConverged, &strong);
  EXPECT_EQ(strong.penalty, 100);
  problem.put_at(Vec2(0.3, 0.3));
  constraints.first_penalty = 0.01;
  solve(problem, options, constraints, DesignVerdict::kConverged, &weak);
  EXPECT_GT(weak.penalty, 0.01);
  // 2 x multiplier = wanted - x
  EXPECT_NEAR(strong.multipliers[0], 0.5 * (std::sqrt(5.0) - 1), 1e-6);
  EXPECT_NEAR(weak.multipliers[0], strong.multipliers[0], 1e-6);
}

TEST(AugmentedLagrangian, ResumesWithTheSameBytes) {
  for (OptimizeOptions options : all_methods(2000)) {
    options.gradient_tolerance = 1e-6;
    const auto make = [] {
      AnalyticProblem p = near(Vec2(2, 1));
      p.set_constraints(circle(), {true});
      return p;
    };
    AnalyticProblem whole = make(), first = make();
    auto one = AugmentedLagrangian::begin(whole, options, {});
    auto start = AugmentedLagrangian::begin(first, options, {});
    ASSERT_TRUE(one.ok() && start.ok());
    ConstrainedState saved = start.value().state();
    for (int k = 0; k < 500; ++k) {
      AnalyticProblem fresh = make();
      fresh.put_at(saved.inner.x);
      auto other = AugmentedLagrangian::resumed(fresh, options, {}, saved);
      ASSERT_TRUE(other.ok()) << other.error().text();
      const bool more = one.value().step({});
      ASSERT_EQ(other.value().step({}), more) << k;
      saved = other.value().state();
      const ConstrainedState now = one.value().state();
      ASSERT_EQ(saved.inner.x, now.inner.x) << k;
      ASSERT_EQ(saved.multipliers, now.multipliers) << k;
      ASSERT_EQ(saved.penalty, now.penalty);
      ASSERT_EQ(saved.inner.cap, now.inner.cap);
      if (!more) break;
    }
    EXPECT_EQ(saved.verdict, DesignVerdict::kConverged);
  }
}

TEST(AugmentedLagrangian, OptionsHaveToMakeSense) {
  EXPECT_TRUE(ConstraintOptions{}.validate().ok());
  for (const ConstraintOptions& o : {ConstraintOptions{.tolerance = 0}, ConstraintOptions{.max_rounds = 0},
                                     ConstraintOptions{.first_penalty = std::nan("")},
                                     ConstraintOptions{.penalty_growth = 1}, ConstraintOptions{.enough_fall = 1}}) {
    EXPECT_FALSE(o.validate().ok());
  }
}

}  // namespace
}  // namespace lissom
