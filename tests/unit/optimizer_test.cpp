#include "lissom/design/optimizer.h"

#include <atomic>
#include <cstdio>
#include <cstring>
#include <gtest/gtest.h>
#include <vector>

#include "scenes/analytic_cases.h"
#include "tests/all_methods.h"

namespace lissom {
namespace {

using Make = AnalyticCase (*)();
AnalyticCase creeping() { return exponential_fit(0.9); }
constexpr Make kCases[] = {linear_in_box, rosenbrock_free, rosenbrock_bounded, creeping, rank_deficient,
                           indefinite,    failing};

/// Bytes of all that a run may depend on.
std::string bytes(const OptimizerState& s) {
  std::string all;
  const auto put = [&](const void* data, std::size_t n) { all.append(static_cast<const char*>(data), n); };
  const auto put_vector = [&](const auto& v) { put(v.data(), v.size() * sizeof(double)); };
  put_vector(s.x);
  put_vector(s.secant.second);
  put_vector(s.promise);
  if (s.has_lesson) {
    put_vector(s.step);
    put_vector(s.gradient_before);
    put_vector(s.pull);
  }
  for (const double v : {s.first_gradient, s.cap, s.damping, s.damping_growth}) put(&v, sizeof v);
  for (const DesignRecord& r : s.records) {
    for (const double v : {r.value, r.gradient, r.predicted, r.step_length, r.cap, r.damping}) put(&v, sizeof v);
    put(r.attempts.counts.data(), sizeof r.attempts.counts);
  }
  put(&s.iteration, sizeof s.iteration);
  return all;
}

TEST(Optimizer, EveryMethodReachesEverySolution) {
  std::printf("%-20s %-34s %5s %8s %9s %5s %8s\n", "problem", "method", "iter.", "attempts", "gradients", "J'J",
              "products");
  for (const Make make : kCases) {
    for (const OptimizeOptions& options : all_methods()) {
      AnalyticCase c = make();
      const std::string what = c.name + ", " + name_of(options);
      Optimizer optimizer(c.problem, options);
      const DesignVerdict verdict = optimizer.run({});
      EXPECT_EQ(verdict, DesignVerdict::kConverged) << what << ": " << optimizer.state().message;
      if (c.solution.size() > 0) {
        EXPECT_LT((c.problem.x() - c.solution).cwiseAbs().maxCoeff(), 1e-8) << what;
      } else {
        EXPECT_LT(c.problem.value(), 1e-20) << what;
        EXPECT_LT(c.problem.x().norm(), 2.5) << what << ": ran along what nothing depends on";
      }
      double before = std::numeric_limits<double>::infinity();
      int attempts = 0;
      for (const DesignRecord& r : optimizer.state().records) {
        EXPECT_LE(r.value, before * (1 + 1e-14)) << what << ' ' << r.iteration;
        before = r.value;
        attempts += r.attempts.total();
      }
      EXPECT_EQ(attempts, c.problem.asked.attempts) << what;
      EXPECT_EQ(optimizer.state().effort.attempts, attempts) << what;
      EXPECT_LE(c.problem.asked.gradients, optimizer.state().iteration + 1) << what;
      EXPECT_LE(c.problem.asked.grams, optimizer.state().iteration) << what << ": J'J where nobody looks at it";
      const AskedFor& a = c.problem.asked;
      std::printf("%-20s %-34s %5d %8d %9d %5d %8d\n", c.name.c_str(), name_of(options).c_str(),
                  optimizer.state().iteration, a.attempts, a.gradients, a.grams, a.products);
    }
  }
}

int iterations(Make make, DesignMethod method, StepControl control = StepControl::kLineSearch) {
  AnalyticCase c = make();
  Optimizer optimizer(c.problem, {.method = method,
                                  .control = control,
                                  .max_iterations = 600,
                                  .gradient_tolerance = 1e-9,
                                  .decrease_tolerance = 0});
  EXPECT_EQ(optimizer.run({}), DesignVerdict::kConverged) << optimizer.state().message;
  return optimizer.state().iteration;
}

TEST(Optimizer, IterationsAreWhatTheoryPromises) {
  EXPECT_EQ(iterations(linear_in_box, DesignMethod::kGaussNewton), 1);
  EXPECT_LE(iterations(linear_in_box, DesignMethod::kNewton), 3);
  EXPECT_GT(iterations(creeping, DesignMethod::kGaussNewton), 60);
  EXPECT_GT(iterations(creeping, DesignMethod::kLevenbergMarquardt), 60);
  EXPECT_LE(iterations(creeping, DesignMethod::kBfgs), 40);
  EXPECT_LE(iterations(creeping, DesignMethod::kStructuredBfgs), 15);
  EXPECT_LE(iterations(creeping, DesignMethod::kDennisGayWelsch), 35);
  EXPECT_LE(iterations(creeping, DesignMethod::kNewton), 10);
  for (const StepControl control : {StepControl::kLineSearch, StepControl::kTrustRegion}) {
    EXPECT_LE(iterations(rosenbrock_free, DesignMethod::kStructuredBfgs, control), 30);
    EXPECT_LE(iterations(rosenbrock_free, DesignMethod::kBfgs, control), 50);
  }
  EXPECT_LE(iterations(rosenbrock_free, DesignMethod::kNewton), 30);
}

TEST(Optimizer, ExactNewtonIsQuadraticAtTheEnd) {
  AnalyticCase c = creeping();
  Optimizer optimizer(
      c.problem,
      {.method = DesignMethod::kNewton, .gradient_tolerance = 1e-13, .decrease_tolerance = 0, .newton_forcing = 1e-8});
  std::vector<double> errors{(c.problem.x() - c.solution).norm()};
  while (optimizer.step({})) errors.push_back((c.problem.x() - c.solution).norm());
  int checked = 0;
  for (std::size_t k = 1; k < errors.size(); ++k) {
    if (errors[k - 1] > 0.05 || errors[k] < 1e-11) continue;
    EXPECT_LT(errors[k], 1000 * errors[k - 1] * errors[k - 1]) << k;  // creep makes the constant large
    ++checked;
  }
  EXPECT_GE(checked, 2);
  EXPECT_LT(errors.back(), 1e-10);
}

TEST(Optimizer, NewtonIsServedByEitherPreconditioner) {
  int products[2] = {0, 0};
  for (const NewtonPreconditioner p : {NewtonPreconditioner::kNone, NewtonPreconditioner::kGram}) {
    AnalyticCase c = creeping();
    Optimizer optimizer(
        c.problem,
        {.method = DesignMethod::kNewton, .preconditioner = p, .gradient_tolerance = 1e-10, .decrease_tolerance = 0});
    EXPECT_EQ(optimizer.run({}), DesignVerdict::kConverged);
    EXPECT_LT((c.problem.x() - c.solution).cwiseAbs().maxCoeff(), 1e-8);
    products[static_cast<int>(p)] = c.problem.asked.products;
    EXPECT_EQ(c.problem.asked.grams == 0, p == NewtonPreconditioner::kNone);
  }
  EXPECT_LE(products[1], products[0]);
}

TEST(Optimizer, ResumesWithTheSameBytesAfterEveryIteration) {
  for (const Make make : {failing, creeping, indefinite}) {
    for (OptimizeOptions options : all_methods()) {
      options.gradient_tolerance = 1e-8;
      options.max_iterations = 25;
      AnalyticCase whole = make(), torn = make();
      Optimizer one(whole.problem, options);
      OptimizerState saved = Optimizer(torn.problem, options).state();
      for (int k = 0;; ++k) {
        // A new problem each time, brought to where the saved state was.
        AnalyticCase fresh = make();
        fresh.problem.put_at(saved.x);
        Result<Optimizer> other = Optimizer::resumed(fresh.problem, options, saved);
        ASSERT_TRUE(other.ok()) << other.error().text();
        const bool more = one.step({});
        ASSERT_EQ(other.value().step({}), more);
        saved = other.value().state();
        ASSERT_EQ(bytes(saved), bytes(one.state())) << whole.name << ", " << name_of(options) << ' ' << k;
        ASSERT_EQ(saved.effort.attempts, one.state().effort.attempts);
        if (!more) break;
      }
      EXPECT_EQ(saved.verdict, one.state().verdict);
      EXPECT_EQ(saved.message, one.state().message);
    }
  }
}

TEST(Optimizer, RefusesStatesOfOthers) {
  AnalyticCase c = rosenbrock_free();
  const OptimizeOptions options;
  Optimizer optimizer(c.problem, options);
  const OptimizerState start = optimizer.state();
  optimizer.step({});
  EXPECT_FALSE(Optimizer::resumed(c.problem, options, start).ok());
  OptimizerState state = optimizer.state();
  EXPECT_TRUE(Optimizer::resumed(c.problem, options, state).ok());
  EXPECT_FALSE(Optimizer::resumed(c.problem, {.method = DesignMethod::kNewton}, state).ok());
  EXPECT_FALSE(Optimizer::resumed(c.problem, {.max_iterations = 0}, state).ok());
  state.cap = std::nan("");
  EXPECT_FALSE(Optimizer::resumed(c.problem, options, state).ok());
}

/// Stopped in the middle of iterations again and again, a run takes the way it would have taken.
TEST(Optimizer, StopsAtOnceAndGoesOn) {
  for (const OptimizeOptions& options : all_methods()) {
    AnalyticCase whole = failing(), torn = failing();
    Optimizer one(whole.problem, options), other(torn.problem, options);
    one.run({});
    std::atomic<bool> cancel = false;
    const auto fate = torn.problem.fate;
    int calm = 0;  // attempts that are left alone before the next stop
    torn.problem.fate = [&](const VecX& from, const VecX& x) {
      if (--calm >= 0) return fate(from, x);
      cancel = true;
      return Outcome::kCancelled;
    };
    Context context;
    context.cancel = &cancel;
    int stops = 0;
    double before = torn.problem.value();
    while (other.run(context) == DesignVerdict::kCancelled) {
      cancel = false;
      ASSERT_LE(torn.problem.value(), before);
      ASSERT_EQ(torn.problem.x(), other.state().x);
      before = torn.problem.value();
      ASSERT_LT(++stops, 2000);
      calm = stops % 13;  // a whole iteration fits in now and then: the attempts of one that was stopped are made again
    }
    EXPECT_GT(stops, 5) << name_of(options);
    EXPECT_EQ(bytes(one.state()), bytes(other.state())) << name_of(options);
  }
}

TEST(Optimizer, CancelledBeforeItBeginsDoesNothing) {
  AnalyticCase c = rosenbrock_free();
  const std::atomic<bool> cancel = true;
  Optimizer optimizer(c.problem, {});
  Context context;
  context.cancel = &cancel;
  EXPECT_EQ(optimizer.run(context), DesignVerdict::kCancelled);
  EXPECT_EQ(c.problem.asked.attempts, 0);
  EXPECT_EQ(c.problem.asked.gradients, 0);
}

}  // namespace
}  // namespace lissom
