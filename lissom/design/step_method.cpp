#include "lissom/design/step_method.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lissom/core/assert.h"

namespace lissom {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kHidden = 64 * kEpsilon;  // of h: promises that rounding hides
constexpr double kNoPromise = 1e-8;        // of h: what is left of a gradient that no step is made of
constexpr double kSame = 4 * kEpsilon;     // of h: changes that may be none

}  // namespace

void Iteration::box(double cap, VecX& lower, VecX& upper) const {
  lower = (problem.lower() - problem.x()).cwiseMin(0).cwiseMax(-cap);
  upper = (problem.upper() - problem.x()).cwiseMax(0).cwiseMin(cap);
}

double Iteration::change(const VecX& d) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const VecX &x = problem.x(), &lower = problem.lower(), &upper = problem.upper();
  // A step that ends at a bound ends there exactly, whatever x + d is rounded to.
  VecX trial = (x + d).cwiseMax(lower).cwiseMin(upper);
  for (int i = 0; i < trial.size(); ++i) {
    if (d[i] <= lower[i] - x[i] && d[i] < 0) trial[i] = lower[i];
    if (d[i] >= upper[i] - x[i] && d[i] > 0) trial[i] = upper[i];
  }
  record.step_length = d.cwiseAbs().maxCoeff();
  const Attempt attempt = problem.attempt(trial);
  Outcome outcome = attempt.outcome;
  double change = kInfinity;
  if (outcome == Outcome::kSettled) {
    const VecX &before = problem.residual(), &after = problem.attempted_residual();
    LISSOM_ASSERT(before.size() == after.size());
    change = 0.5 * (after - before).dot(after + before);
    if (!std::isfinite(attempt.value) || !std::isfinite(change)) {
      outcome = Outcome::kUnsettled;
      change = kInfinity;
    }
  }
  cancelled_ = outcome == Outcome::kCancelled;
  ++record.attempts[outcome];
  ++state.rejected[outcome];  // until it is accepted
  return change;
}

bool Iteration::learns_structure() const {
  return options.method == DesignMethod::kStructuredBfgs || options.method == DesignMethod::kDennisGayWelsch;
}

void Iteration::accept(const VecX& d) {
  const std::optional<SecantRule> rule = secant_rule(options.method);
  if (rule && *rule != SecantRule::kGaussNewton) {
    state.has_lesson = true;
    state.gradient_before = problem.gradient();
    if (learns_structure()) state.pull = problem.jacobian_transposed_times(problem.attempted_residual());
    const VecX from = problem.x();
    problem.accept();
    state.step = problem.x() - from;  // as rounded
  } else {
    problem.accept();
    state.step = d;
  }
  state.x = problem.x();
  state.rejected = {};
  record.accepted = true;
}

bool Iteration::hidden(double predicted, double value) { return predicted <= kHidden * std::abs(value); }

bool Iteration::below_rounding(double predicted) const { return hidden(predicted, problem.value()); }

bool Iteration::has_not_risen(double change) const { return change <= kSame * std::abs(problem.value()); }

bool Iteration::promises_too_little(double predicted, Cut cut) {
  record.predicted = predicted;
  return !(predicted > 0) ||
         (cut == Cut::kWhole && predicted <= options.decrease_tolerance * std::abs(problem.value()));
}

StepEnd Iteration::without_promise() const {
  const bool gained = record.predicted > 0 || record.gradient <= kNoPromise * std::abs(problem.value());
  return gained ? StepEnd::kNothingLeft : StepEnd::kExhausted;
}

StepEnd Iteration::after_failure(const VecX& d, double predicted) const {
  if (below_rounding(predicted)) return StepEnd::kNothingLeft;
  return d.cwiseAbs().maxCoeff() < 2 * options.least_step ? StepEnd::kExhausted : StepEnd::kRejected;
}

MatX secant_model(Iteration& work) {
  ReducedProblem& problem = work.problem;
  OptimizerState& state = work.state;
  SecantHessian hessian(*secant_rule(work.options.method), std::move(state.secant));
  if (state.has_lesson) {
    state.has_lesson = false;
    const VecX& gradient = problem.gradient();
    SecantStep lesson{state.step, gradient - state.gradient_before, {}, {}};
    if (state.pull.size() > 0) {
      lesson.structured_change = gradient - state.pull;
      lesson.gram = problem.gram();
    }
    hessian.learn(lesson);
  }
  MatX model = hessian.needs_gram() ? hessian.at(problem.gram()) : hessian.at({});
  state.secant = std::move(hessian).take_memory();
  return model;
}

bool forget_secants(Iteration& work) {
  SecantHessian hessian(*secant_rule(work.options.method), std::move(work.state.secant));
  const bool any = hessian.has_memory();
  hessian.forget();
  work.state.secant = std::move(hessian).take_memory();
  return any;
}

StepEnd judge_by_radius(Iteration& work, const VecX& d, double predicted, double change) {
  constexpr double kLeastRatio = 1e-4, kPoor = 0.25, kGood = 0.75;
  OptimizerState& state = work.state;
  const double length = d.cwiseAbs().maxCoeff();
  if (work.below_rounding(predicted)) {  // the ratio is noise
    if (!work.has_not_risen(change)) return StepEnd::kNothingLeft;
    work.accept(d);
    return StepEnd::kAccepted;
  }
  const double ratio = -change / predicted;
  if (ratio < kPoor) {
    state.cap = (ratio > kLeastRatio ? 0.5 : 0.25) * length;
  } else if (ratio > kGood && length >= 0.99 * state.cap) {
    state.cap *= 2;
  }
  if (!(ratio > kLeastRatio)) return work.after_failure(d, predicted);
  work.accept(d);
  return StepEnd::kAccepted;
}

std::unique_ptr<StepMethod> make_step_method(const OptimizeOptions& options) {
  switch (options.method) {
    case DesignMethod::kLevenbergMarquardt:
      return make_levenberg_marquardt();
    case DesignMethod::kNewton:
      return make_exact_newton();
    case DesignMethod::kGaussNewtonProducts:
      return make_gauss_newton_products();
    case DesignMethod::kGaussNewton:
    case DesignMethod::kBfgs:
    case DesignMethod::kStructuredBfgs:
    case DesignMethod::kDennisGayWelsch:
      break;
  }
  return options.control == StepControl::kLineSearch ? make_line_search() : make_trust_region();
}

}  // namespace lissom
