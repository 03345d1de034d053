#include "lissom/design/augmented_lagrangian.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace lissom {

namespace {

constexpr double kFirstFall = 0.1;   // of the violation at the start, after the first round
constexpr double kLeastFirst = 0.1;  // of its scale: a start that meets the constraints is taken to miss them by this
constexpr double kPrecision = 1e-6;  // of the violation at the start
constexpr int kStuckRounds = 4;      // with hardly any fall of the violation: it will not fall
constexpr double kHardlyFell = 0.9;  // share of the violation before
constexpr double kFirstPrecision = 1e-2, kMorePrecision = 0.1,
                 kLastPrecision = 1e-12;  // of the descents of early rounds

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

/// A violation of all constraints by their present gaps, but at least by a tenth, shall weigh ten times what h has besides.
double first_penalty(ReducedProblem& problem) {
  const VecX none = VecX::Zero(problem.constraints());
  problem.set_multipliers(none, 1);
  VecX c = problem.constraint_values();
  for (int i = 0; i < c.size(); ++i) {
    if (problem.is_inequality(i)) c[i] = std::max(c[i], 0.0);
  }
  const double half = 0.5 * c.squaredNorm(), rest = problem.value() - half;
  const double penalty = 10 * rest / std::max(half, 0.005);
  return std::isfinite(penalty) ? std::max(penalty, 1e-8) : 1;
}

}  // namespace

Status ConstraintOptions::validate() const {
  const auto bad = [](const char* where, const char* message, const char* hint) {
    return Error{ErrorCode::kRange, where, message, hint};
  };
  if (!(tolerance > 0)) return bad("tolerance", "the tolerance of constraints has to be positive", "1e-6 is usual");
  if (max_rounds < 1) return bad("max_rounds", "at least one round is needed", "30 is usual");
  if (!(first_penalty >= 0) || !std::isfinite(first_penalty)) {
    return bad("first_penalty", "the first penalty cannot be negative", "0 chooses one");
  }
  if (!(penalty_growth > 1)) return bad("penalty_growth", "the penalty has to grow", "10 is usual");
  if (!(enough_fall > 0) || !(enough_fall < 1)) {
    return bad("enough_fall", "the share has to lie between 0 and 1", "0.25 is usual");
  }
  return {};
}

VecX constraint_gaps(const ReducedProblem& problem, const VecX& multipliers, double penalty) {
  VecX gaps = problem.constraint_values();
  for (int i = 0; i < gaps.size(); ++i) {
    if (problem.is_inequality(i)) gaps[i] = std::max(gaps[i], -multipliers[i] / penalty);
  }
  return gaps;
}

AugmentedLagrangian::AugmentedLagrangian(ReducedProblem& problem, const OptimizeOptions& options,
                                         const ConstraintOptions& constraints, ConstrainedState state, Optimizer inner)
    : problem_(&problem),
      options_(options),
      constraints_(constraints),
      state_(std::move(state)),
      inner_(std::move(inner)) {}

/// Early rounds need not descend far; and how good h is cannot be said while multipliers are a part of it.
OptimizeOptions AugmentedLagrangian::of_round(const OptimizeOptions& options, int round) {
  OptimizeOptions o = options;
  o.value_tolerance = 0;
  const double precision = kFirstPrecision * std::pow(kMorePrecision, round);
  if (precision <= std::max(options.gradient_tolerance, kLastPrecision)) return o;
  o.gradient_tolerance = precision;
  o.decrease_tolerance = std::max(options.decrease_tolerance, precision * precision);
  return o;
}

bool AugmentedLagrangian::last_precision() const {
  return inner_.options().gradient_tolerance <= options_.gradient_tolerance &&
         inner_.options().decrease_tolerance <= options_.decrease_tolerance;
}

Result<AugmentedLagrangian> AugmentedLagrangian::begin(ReducedProblem& problem, const OptimizeOptions& options,
                                                       const ConstraintOptions& constraints) {
  if (const Status status = options.validate(); !status) return status.error();
  if (const Status status = constraints.validate(); !status) return status.error();
  int equalities = 0, movable = 0;
  for (int i = 0; i < problem.constraints(); ++i) equalities += !problem.is_inequality(i);
  for (int i = 0; i < problem.size(); ++i) movable += problem.lower()[i] < problem.upper()[i];
  if (equalities > movable) {
    return Error{ErrorCode::kConflict, "constraints",
                 std::to_string(equalities) + " equality constraints cannot be met by " + std::to_string(movable) +
                     " parameters that can move",
                 "drop constraints, make some of them goals, or free more parameters"};
  }
  ConstrainedState state;
  state.multipliers = VecX::Zero(problem.constraints());
  state.penalty = constraints.first_penalty > 0 ? constraints.first_penalty : first_penalty(problem);
  problem.set_multipliers(state.multipliers, state.penalty);
  const VecX gaps = constraint_gaps(problem, state.multipliers, state.penalty);
  state.first_violation = gaps.size() > 0 ? std::max(gaps.cwiseAbs().maxCoeff(), kLeastFirst) : kLeastFirst;
  Optimizer inner(problem, of_round(options, 0));
  return AugmentedLagrangian(problem, options, constraints, std::move(state), std::move(inner));
}

Result<AugmentedLagrangian> AugmentedLagrangian::resumed(ReducedProblem& problem, const OptimizeOptions& options,
                                                         const ConstraintOptions& constraints, ConstrainedState state) {
  if (const Status status = constraints.validate(); !status) return status.error();
  if (state.multipliers.size() != problem.constraints() || !state.multipliers.allFinite() || !(state.penalty > 0) ||
      state.round < 0) {
    return Error{ErrorCode::kConflict, "multipliers", "the saved state does not belong to these constraints",
                 "resume with the problem and options that were saved"};
  }
  problem.set_multipliers(state.multipliers, state.penalty);
  Result<Optimizer> inner = Optimizer::resumed(problem, of_round(options, state.round), std::move(state.inner));
  if (!inner) return inner.error();
  return AugmentedLagrangian(problem, options, constraints, std::move(state), std::move(inner).value());
}

ConstrainedState AugmentedLagrangian::state() const {
  ConstrainedState copy = state_;
  copy.inner = inner_.state();
  return copy;
}

void AugmentedLagrangian::end(DesignVerdict verdict, const std::string& message) {
  state_.verdict = verdict;
  state_.message = message;
}

bool AugmentedLagrangian::step(const Context& context) {
  if (state_.verdict && *state_.verdict != DesignVerdict::kCancelled &&
      !(*state_.verdict == DesignVerdict::kIterationLimit && inner_.state().iteration < options_.max_iterations)) {
    return false;
  }
  state_.verdict.reset();
  state_.message.clear();
  if (inner_.step(context)) return true;
  const DesignVerdict descent = *inner_.state().verdict;
  switch (descent) {
    case DesignVerdict::kCancelled:
    case DesignVerdict::kIterationLimit:
    case DesignVerdict::kBadStart:
      end(descent, inner_.state().message);
      return false;
    default:
      end_round(descent);
      return !state_.verdict;
  }
}

DesignVerdict AugmentedLagrangian::run(const Context& context) {
  while (step(context)) {
  }
  return *state_.verdict;
}

void AugmentedLagrangian::end_round(DesignVerdict descent) {
  // A point that was good enough for this round as it was says nothing about multipliers and penalty.
  if (inner_.state().iteration == state_.round_began && !last_precision() &&
      state_.round + 1 < constraints_.max_rounds) {
    return next_round();
  }
  const VecX gaps = constraint_gaps(*problem_, state_.multipliers, state_.penalty);
  const double before = state_.violation;
  int worst = -1;
  state_.violation = gaps.size() > 0 ? gaps.cwiseAbs().maxCoeff(&worst) : 0;
  if (state_.violation <= constraints_.tolerance) {
    if (options_.value_tolerance > 0 && problem_->value() <= options_.value_tolerance) {
      return end(DesignVerdict::kGoodEnough, std::string(design_verdict_info(DesignVerdict::kGoodEnough).sentence));
    }
    if (last_precision()) return end(descent, inner_.state().message);
  } else {
    const bool fell = before < 0 || state_.violation <= kHardlyFell * before;
    state_.stuck = fell ? 0 : state_.stuck + 1;
  }
  const std::string left =
      worst < 0 ? "" : "; constraint " + std::to_string(worst) + " is off by " + number(gaps[worst]) + " of its scale";
  // What is small beside the violation at the start is a matter of precision, not of constraints that contradict each other.
  const bool small = state_.violation <= kPrecision * state_.first_violation;
  const bool stuck = state_.stuck >= kStuckRounds;
  if (stuck || state_.round + 1 >= constraints_.max_rounds) {
    const DesignVerdict verdict = stuck && !small ? DesignVerdict::kInfeasible : DesignVerdict::kConstraintLimit;
    std::string message = std::string(design_verdict_info(verdict).sentence) + left;
    if (descent != DesignVerdict::kConverged) message += "; in the last round " + inner_.state().message;
    return end(verdict, message);
  }
  // The multipliers under which the point is stationary without any penalty.
  for (int i = 0; i < gaps.size(); ++i) {
    state_.multipliers[i] += state_.penalty * gaps[i];
    if (problem_->is_inequality(i)) state_.multipliers[i] = std::max(state_.multipliers[i], 0.0);
  }
  // Descents of early rounds are rough, and what they leave of a violation is no reason for more penalty while it falls as
  // their precision rises.
  const double rough = kFirstFall * std::pow(kMorePrecision, state_.round) * state_.first_violation;
  if (state_.violation > constraints_.tolerance && state_.violation > rough && before >= 0 &&
      state_.violation > constraints_.enough_fall * before) {
    state_.penalty *= constraints_.penalty_growth;
  }
  next_round();
}

void AugmentedLagrangian::next_round() {
  ++state_.round;
  state_.round_began = inner_.state().iteration;
  problem_->set_multipliers(state_.multipliers, state_.penalty);
  inner_.value_has_changed();
  inner_.set_options(of_round(options_, state_.round));
}

}  // namespace lissom
