#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "lissom/design/optimizer.h"
#include "scenes/analytic_cases.h"
#include "tests/all_methods.h"

namespace lissom {
namespace {

TEST(OptimizerEndings, ValuesThatAreNoNumbersAreFailures) {
  int spoilt = 0;
  for (const OptimizeOptions& options : all_methods()) {
    AnalyticCase c = rosenbrock_bounded();
    c.problem.put_at(Vec2(-1.2, 1.44));
    // Below the valley, although r is finite there: the value is what the problem vouches for.
    c.problem.spoil = [](const VecX& x, double value) { return x[1] < x[0] * x[0] - 0.3 ? std::nan("") : value; };
    Optimizer optimizer(c.problem, options);
    EXPECT_EQ(optimizer.run({}), DesignVerdict::kConverged) << optimizer.state().message;
    EXPECT_LT((c.problem.x() - c.solution).cwiseAbs().maxCoeff(), 1e-8) << name_of(options);
    for (const DesignRecord& r : optimizer.state().records) spoilt += r.attempts[Outcome::kUnsettled];
  }
  EXPECT_GE(spoilt, 5);
}

TEST(OptimizerEndings, SaysWhyNothingIsLeftToTry) {
  struct Wall {
    Outcome outcome;
    DesignVerdict verdict;
  };
  for (const Wall wall :
       {Wall{Outcome::kJumped, DesignVerdict::kJumped}, Wall{Outcome::kUnstable, DesignVerdict::kNoEquilibrium},
        Wall{Outcome::kNoDesign, DesignVerdict::kNoEquilibrium}}) {
    for (OptimizeOptions options : all_methods()) {
      options.least_step = 1e-6;
      AnalyticCase c = rosenbrock_free();
      c.problem.fate = [&](const VecX&, const VecX& x) { return x[0] > -0.5 ? wall.outcome : Outcome::kSettled; };
      // The wall runs across the valley, and the way along it is barred as well.
      c.problem.put_at(Vec2(-0.5, 0.25));
      Optimizer optimizer(c.problem, options);
      EXPECT_EQ(optimizer.run({}), wall.verdict) << name_of(options) << ": " << optimizer.state().message;
      EXPECT_EQ(c.problem.x()[0], -0.5);
      EXPECT_LT(c.problem.asked.attempts, 120) << name_of(options);
      const auto left = largest_entries(optimizer.state().promise, 5);
      ASSERT_EQ(left.size(), 1u);
      EXPECT_EQ(left[0].parameter, 0);
      EXPECT_LT(left[0].value, 0);
      EXPECT_NE(optimizer.state().message.find("parameter 0"), std::string::npos) << optimizer.state().message;
    }
  }
}

/// Second derivatives that are no numbers leave exact Newton without a step: that is a limit, and neither convergence nor a jump.
TEST(OptimizerEndings, AModelThatPromisesNothingIsNoConvergence) {
  for (const NewtonPreconditioner like_h : {NewtonPreconditioner::kNone, NewtonPreconditioner::kGram}) {
    SmoothFunctions r = rosenbrock();
    r.curvature = [](const VecX& x, const VecX&) -> MatX { return MatX::Constant(x.size(), x.size(), std::nan("")); };
    AnalyticProblem problem(r, Vec2(-1.2, 1), Vec2(-3, -3), Vec2(3, 3));
    Optimizer optimizer(problem, {.method = DesignMethod::kNewton, .preconditioner = like_h});
    EXPECT_EQ(optimizer.run({}), DesignVerdict::kLimit) << optimizer.state().message;
    EXPECT_EQ(problem.x(), VecX(Vec2(-1.2, 1)));
    EXPECT_NE(optimizer.state().message.find("a gradient of"), std::string::npos) << optimizer.state().message;
  }
}

/// Values that rise whatever one does, against what the gradient says.
TEST(OptimizerEndings, ReachesALimitWhereNoStepLowersTheValue) {
  for (OptimizeOptions options : all_methods()) {
    options.least_step = 1e-6;
    const Vec2 start(-0.5, 0.25);
    SmoothFunctions r = rosenbrock();
    r.value = [start, f = r.value](const VecX& x) -> VecX {
      VecX v(3);
      v.head(2) = f(x);
      v[2] = 10 * std::sqrt((x - start).norm());
      return v;
    };
    r.jacobian = [f = r.jacobian](const VecX& x) {
      MatX j = MatX::Zero(3, 2);
      j.topRows(2) = f(x);
      return j;
    };
    AnalyticProblem problem(r, start, boundless(2, -1), boundless(2, 1));
    Optimizer optimizer(problem, options);
    EXPECT_EQ(optimizer.run({}), DesignVerdict::kLimit) << name_of(options) << ": " << optimizer.state().message;
    EXPECT_EQ(problem.x(), VecX(start));
    EXPECT_LT(problem.asked.attempts, 120);
  }
}

TEST(OptimizerEndings, EndsInTime) {
  AnalyticCase c = rosenbrock_free();
  OptimizeOptions options{.max_iterations = 3};
  Optimizer optimizer(c.problem, options);
  EXPECT_EQ(optimizer.run({}), DesignVerdict::kIterationLimit);
  EXPECT_FALSE(optimizer.step({}));
  options.max_iterations = 100;
  options.value_tolerance = 1e-3;
  optimizer.set_options(options);
  EXPECT_EQ(optimizer.run({}), DesignVerdict::kGoodEnough);
  EXPECT_LE(c.problem.value(), 1e-3);
  EXPECT_GT(c.problem.value(), 0);
}

TEST(OptimizerEndings, RefusesAStartWithoutNumbers) {
  SmoothFunctions r = rosenbrock();
  r.jacobian = [](const VecX&) -> MatX { return MatX::Constant(2, 2, std::nan("")); };
  AnalyticProblem problem(r, Vec2(0, 0), boundless(2, -1), boundless(2, 1));
  Optimizer optimizer(problem, {});
  EXPECT_EQ(optimizer.run({}), DesignVerdict::kBadStart);
  EXPECT_EQ(problem.asked.attempts, 0);
}

TEST(OptimizerEndings, TellsHowFarItIs) {
  AnalyticCase c = exponential_fit(0.9);
  Optimizer optimizer(c.problem, {.method = DesignMethod::kGaussNewton, .decrease_tolerance = 0});
  std::vector<double> fractions;
  int lines = 0;
  Context context;
  context.progress = [&](const Progress& p) {
    EXPECT_EQ(p.task, "design");
    fractions.push_back(p.fraction);
  };
  context.log = [&](std::string_view) { ++lines; };
  EXPECT_EQ(optimizer.run(context), DesignVerdict::kConverged);
  const int n = optimizer.state().iteration;
  ASSERT_EQ(static_cast<int>(fractions.size()), n);
  EXPECT_EQ(lines, n);
  EXPECT_NEAR(fractions[n / 2], 0.5, 0.1);  // a steady creep is foretold well
  EXPECT_GE(optimizer.seconds_left(), 0);
}

TEST(OptimizerEndings, OptionsHaveToMakeSense) {
  EXPECT_TRUE(OptimizeOptions{}.validate().ok());
  const double nan = std::nan("");
  for (const OptimizeOptions& o : {OptimizeOptions{.max_iterations = 0}, OptimizeOptions{.gradient_tolerance = nan},
                                   OptimizeOptions{.decrease_tolerance = 1}, OptimizeOptions{.value_tolerance = -1},
                                   OptimizeOptions{.first_cap = 0}, OptimizeOptions{.first_cap = 1, .least_step = 2},
                                   OptimizeOptions{.max_halvings = -1}, OptimizeOptions{.first_damping = nan},
                                   OptimizeOptions{.max_products = 0}, OptimizeOptions{.newton_forcing = 1}}) {
    const Status status = o.validate();
    ASSERT_FALSE(status.ok());
    EXPECT_FALSE(status.error().where.empty());
    EXPECT_FALSE(status.error().hint.empty());
  }
}

}  // namespace
}  // namespace lissom
