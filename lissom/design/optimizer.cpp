#include "lissom/design/optimizer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <utility>

#include "lissom/core/assert.h"

namespace lissom {

namespace {

constexpr int kGroping = 8;      // steps that rounding hides, in which the gradient has to fall
constexpr int kPace = 6;         // iterations from which the pace is taken
constexpr double kAfresh = 0.1;  // of the first cap: least cap where h has changed

DesignEffort sum(const DesignEffort& a, const DesignEffort& b, int sign) {
  return {a.attempts + sign * b.attempts, a.solves + sign * b.solves, a.factorizations + sign * b.factorizations,
          a.back_solves + sign * b.back_solves};
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

bool may_continue(const OptimizerState& state, const OptimizeOptions& options) {
  if (!state.verdict) return true;
  if (*state.verdict == DesignVerdict::kCancelled) return true;
  return *state.verdict == DesignVerdict::kIterationLimit && state.iteration < options.max_iterations;
}

Error not_of_this(const char* where, const std::string& what) {
  return Error{ErrorCode::kConflict, where, what, "resume with the problem, point and options that were saved"};
}

}  // namespace

Optimizer::Optimizer(ReducedProblem& problem, const OptimizeOptions& options)
    : problem_(&problem), options_(options), method_(make_step_method(options)) {
  LISSOM_ASSERT(options.validate().ok());
  const int m = problem.size();
  LISSOM_ASSERT(m > 0 && problem.x().size() == m && problem.lower().size() == m && problem.upper().size() == m);
  LISSOM_ASSERT((problem.lower().array() <= problem.x().array()).all());
  LISSOM_ASSERT((problem.x().array() <= problem.upper().array()).all());
  state_.x = problem.x();
  state_.cap = options.first_cap;
  if (options.method == DesignMethod::kLevenbergMarquardt) state_.damping = options.first_damping;
  state_.damping_growth = 4;
  const std::optional<SecantRule> rule = secant_rule(options.method);
  if (rule) state_.secant = SecantHessian(*rule, m).memory();
  effort_before_ = sum({}, problem.effort(), -1);
}

Result<Optimizer> Optimizer::resumed(ReducedProblem& problem, const OptimizeOptions& options, OptimizerState state) {
  if (const Status status = options.validate(); !status) return status.error();
  Optimizer optimizer(problem, options);
  const int m = problem.size();
  if (state.x.size() != m) return not_of_this("x", "the saved state has another number of parameters");
  if (state.x != problem.x()) return not_of_this("x", "the problem does not stand where the saved state was");
  if (state.secant.second.rows() != optimizer.state_.secant.second.rows() ||
      state.secant.second.cols() != state.secant.second.rows()) {
    return not_of_this("secant", "the saved state belongs to another method");
  }
  const bool lesson = state.step.size() == m && state.gradient_before.size() == m;
  if (!(state.cap > 0) || !(state.damping >= 0) || !(state.damping_growth > 0) || state.iteration < 0 ||
      !state.secant.second.allFinite() || (state.has_lesson && !lesson)) {
    return not_of_this("state", "the saved state has impossible numbers");
  }
  optimizer.state_ = std::move(state);
  optimizer.effort_before_ = sum(optimizer.state_.effort, problem.effort(), -1);
  return optimizer;
}

void Optimizer::set_options(const OptimizeOptions& options) {
  LISSOM_ASSERT(options.validate().ok() && options.method == options_.method);
  options_ = options;
  method_ = make_step_method(options);
}

void Optimizer::value_has_changed() {
  state_.has_lesson = false;
  state_.rejected = {};
  state_.cap = std::max(state_.cap, kAfresh * options_.first_cap);
  state_.verdict.reset();
  state_.message.clear();
}

void Optimizer::end(DesignVerdict verdict, const std::string& reason) {
  state_.verdict = verdict;
  state_.message = std::string(design_verdict_info(verdict).sentence);
  if (!reason.empty()) state_.message += "; " + reason;
}

/// No attempt was any good down to the shortest: says which kind of no.
void Optimizer::end_without_step() {
  const OutcomeCounts& rejected = state_.rejected;
  std::string left = "no gradient is left";
  if (const auto largest = largest_entries(state_.promise, 1); !largest.empty()) {
    left =
        "a gradient of " + number(largest[0].value) + " is left in " + problem_->parameter_name(largest[0].parameter);
  }
  // Without any attempt it is the model that has nothing to offer.
  if (rejected[Outcome::kSettled] > 0 || rejected.total() == 0) return end(DesignVerdict::kLimit, left);
  const int jumped = rejected[Outcome::kJumped], failed = rejected.total();
  if (jumped == failed) return end(DesignVerdict::kJumped, left);
  end(DesignVerdict::kNoEquilibrium,
      std::to_string(jumped) + " of " + std::to_string(failed) + " attempts snapped, " + left);
}

/// Looks at the point: false with a verdict when there is nothing to do.
bool Optimizer::look(DesignRecord& record) {
  const VecX& g = problem_->gradient();
  if (!std::isfinite(problem_->value()) || g.size() != problem_->size() || !g.allFinite()) {
    end(DesignVerdict::kBadStart);
    return false;
  }
  state_.promise = first_order_promise(problem_->x(), g, problem_->lower(), problem_->upper());
  record.gradient = state_.promise.cwiseAbs().maxCoeff();
  for (int i = 0; i < g.size(); ++i) record.active_bounds += g[i] != 0 && state_.promise[i] == 0;
  if (state_.first_gradient < 0) state_.first_gradient = record.gradient;
  if (options_.value_tolerance > 0 && problem_->value() <= options_.value_tolerance) {
    end(DesignVerdict::kGoodEnough);
    return false;
  }
  if (record.gradient <= options_.gradient_tolerance * state_.first_gradient) {
    end(DesignVerdict::kConverged);
    return false;
  }
  if (gropes(record.gradient)) {
    end(DesignVerdict::kConverged, "as far as rounding lets one see");
    return false;
  }
  return true;
}

/// Whether the last steps promised less than rounding lets one see, and the gradient has not fallen by them.
bool Optimizer::gropes(double gradient) const {
  const int n = static_cast<int>(state_.records.size());
  if (n < kGroping || gradient < state_.records[n - kGroping].gradient) return false;
  return std::all_of(state_.records.end() - kGroping, state_.records.end(),
                     [](const DesignRecord& r) { return r.accepted && Iteration::hidden(r.predicted, r.value); });
}

bool Optimizer::step(const Context& context) {
  if (!may_continue(state_, options_)) return false;
  LISSOM_ASSERT(state_.x == problem_->x());
  state_.verdict.reset();
  state_.message.clear();
  if (context.cancelled()) {
    end(DesignVerdict::kCancelled);
    return false;
  }
  const auto begin = std::chrono::steady_clock::now();
  DesignRecord record;
  record.iteration = state_.iteration;
  if (!look(record)) return false;
  if (state_.iteration >= options_.max_iterations) {
    end(DesignVerdict::kIterationLimit);
    return false;
  }
  OptimizerState before = state_;  // what a cancelled iteration began with, so that it can be done again
  Iteration work(*problem_, state_, options_, context, record);
  const StepEnd ending = method_->iterate(work);
  if (ending == StepEnd::kCancelled) {
    state_ = std::move(before);
    end(DesignVerdict::kCancelled);
    return false;
  }
  finish_record(record);
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  ++timed_;
  if (ending == StepEnd::kNothingLeft) end(DesignVerdict::kConverged);
  if (ending == StepEnd::kExhausted) end_without_step();
  tell(context);
  return true;
}

void Optimizer::finish_record(DesignRecord& record) {
  record.value = problem_->value();
  record.cap = state_.cap;
  if (options_.method == DesignMethod::kLevenbergMarquardt) record.damping = state_.damping;
  record.effort = state_.effort = sum(effort_before_, problem_->effort(), 1);
  state_.records.push_back(record);
  ++state_.iteration;
  state_.records.back().iterations_left = iterations_left();
}

DesignVerdict Optimizer::run(const Context& context) {
  while (step(context)) {
  }
  return *state_.verdict;
}

/// From how the promises fell lately; they fall by about the same share per iteration, or faster.
int Optimizer::iterations_left() const {
  const int n = static_cast<int>(state_.records.size());
  if (n < 3 || !(options_.gradient_tolerance > 0)) return -1;
  const int most = std::max(options_.max_iterations - state_.iteration, 0);
  const DesignRecord &now = state_.records[n - 1], &past = state_.records[std::max(0, n - kPace)];
  const double fall = std::log(past.gradient / now.gradient) / (now.iteration - past.iteration);
  const double wanted = std::log(now.gradient / (options_.gradient_tolerance * state_.first_gradient));
  if (!(fall > 0) || !(wanted / fall < most)) return most;
  return static_cast<int>(std::ceil(std::max(wanted / fall, 0.0)));
}

double Optimizer::seconds_left() const {
  if (timed_ == 0 || state_.records.empty() || state_.records.back().iterations_left < 0) return -1;
  return state_.records.back().iterations_left * seconds_ / timed_;
}

void Optimizer::tell(const Context& context) const {
  if (!context.progress && !context.log) return;
  const DesignRecord& r = state_.records.back();
  std::string detail = "h " + number(r.value) + (r.accepted ? ", step " : ", rejected step ") + number(r.step_length);
  if (r.active_bounds > 0) detail += ", " + std::to_string(r.active_bounds) + " parameters at their bounds";
  if (const double seconds = seconds_left(); seconds >= 0) detail += ", about " + number(seconds) + " s left";
  const double fraction =
      r.iterations_left < 0 ? -1 : double(state_.iteration) / (state_.iteration + r.iterations_left);
  context.report({.task = "design", .fraction = fraction, .iteration = state_.iteration, .detail = detail});
  if (context.log) context.log(detail);
}

}  // namespace lissom
