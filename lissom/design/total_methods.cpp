#include "lissom/design/total_methods.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/design/optimizer_state.h"
#include "lissom/design/total_run.h"

namespace lissom {

namespace {

struct Runner {
  TotalMethodInfo info;
  void (*run)(TotalRun&);
};

constexpr std::array<Runner, 4> kRunners = {{
    {{TotalMethod::kLagrangeNewton, "lagrange_newton", "Newton on states, parameters and multipliers; exact"},
     run_lagrange},
    {{TotalMethod::kLagrangeGaussNewton, "lagrange_gauss_newton",
      "the same without second derivatives of forces and residuals"},
     run_lagrange},
    {{TotalMethod::kPenalty, "penalty", "unbalanced forces are dear, and ever dearer"}, run_penalty},
    {{TotalMethod::kAugmentedLagrangian, "augmented_lagrangian", "the same with multipliers"}, run_penalty},
}};

constexpr std::array<TotalVerdictInfo, 8> kVerdicts = {{
    {TotalVerdict::kConverged, "converged", "in equilibrium, and no parameter promises more"},
    {TotalVerdict::kGoodEnough, "good_enough", "in equilibrium, and the goals are met as closely as asked"},
    {TotalVerdict::kIterationLimit, "iteration_limit", "the iterations ran out"},
    {TotalVerdict::kStalled, "stalled", "no step lowers forces and goals together"},
    {TotalVerdict::kSingular, "singular", "the equations of a step have no single solution"},
    {TotalVerdict::kPenaltyLimit, "penalty_limit", "forces are left although they are as dear as allowed"},
    {TotalVerdict::kBadStart, "bad_start", "derivatives at a point are not known or not finite"},
    {TotalVerdict::kCancelled, "cancelled", "stopped"},
}};

Error out_of_range(const char* where, const char* message, const char* hint) {
  return Error{ErrorCode::kRange, where, message, hint};
}

bool positive(double value) { return value > 0 && std::isfinite(value); }

double largest_promise(const VecX& x, const VecX& gradient, const VecX& lower, const VecX& upper) {
  return first_order_promise(x, gradient, lower, upper).cwiseAbs().maxCoeff();
}

/// Solves every pose from where the method left it. The problem goes to what is found if all of it is stable.
Status settle(StructureProblem& problem, double first_gradient, const Context& context, TotalResult& result) {
  const DesignPoint before = problem.point();
  Result<Design> design = problem.space().at(result.point.p);
  if (!design) {
    result.settled = Outcome::kNoDesign;
    result.settled_reason = design.error().text();
    return {};
  }
  DesignPoint found{result.point.p, {}, before.pin_factors};
  for (std::size_t k = 0; k < problem.poses().size(); ++k) {
    const State& start = result.point.states[k];
    SolveOptions options = problem.options().solve;
    options.modes = 0;
    Result<std::unique_ptr<PoseFollower>> made =
        PoseFollower::make(problem.design(), problem.poses()[k]->pose(), options, context);
    if (!made) return made.error();
    PoseFollower& follower = *made.value();
    const PoseEnd end = follower.release(design.value(), &start);
    result.settled_factorizations += follower.factorizations();
    if (end.outcome != Outcome::kSettled) {
      result.settled = end.outcome;
      result.settled_reason = end.reason;
      return {};
    }
    const int nodes = follower.system().layout.nodes();
    const double move = (follower.state().q - start.q).head(3 * nodes).norm() / std::sqrt(nodes);
    result.settled_move = std::max(result.settled_move, move);
    found.states.push_back(follower.state());
  }
  const Status taken = problem.restore(found);
  if (!taken) {
    result.settled = Outcome::kUnstable;
    result.settled_reason = taken.error().text();
    return problem.restore(before);
  }
  result.settled = Outcome::kSettled;
  result.settled_value = problem.value();
  const double left = largest_promise(problem.x(), problem.gradient(), problem.lower(), problem.upper());
  result.settled_gradient = first_gradient > 0 ? left / first_gradient : 0;
  return {};
}

}  // namespace

const std::array<TotalMethodInfo, 4>& total_methods() {
  static constexpr std::array<TotalMethodInfo, 4> kInfos = {kRunners[0].info, kRunners[1].info, kRunners[2].info,
                                                            kRunners[3].info};
  return kInfos;
}

std::string_view total_method_name(TotalMethod method) {
  for (const Runner& entry : kRunners) {
    if (entry.info.method == method) return entry.info.name;
  }
  LISSOM_ASSERT(false);
  return {};
}

const std::array<TotalVerdictInfo, 8>& total_verdicts() { return kVerdicts; }

const TotalVerdictInfo& total_verdict_info(TotalVerdict verdict) {
  const auto* const found = std::find_if(kVerdicts.begin(), kVerdicts.end(),
                                         [&](const TotalVerdictInfo& info) { return info.verdict == verdict; });
  LISSOM_ASSERT(found != kVerdicts.end());
  return *found;
}

Status TotalOptions::validate() const {
  if (max_iterations < 1) return out_of_range("max_iterations", "at least one iteration is needed", "200 is usual");
  if (!(gradient_tolerance >= 0 && gradient_tolerance < 1)) {
    return out_of_range("gradient_tolerance", "it is a share of the first gradient", "1e-6 is usual");
  }
  if (!(value_tolerance >= 0)) return out_of_range("value_tolerance", "h is never negative", "0 switches it off");
  if (!positive(first_cap)) return out_of_range("first_cap", "steps need a positive cap", "1 is usual");
  if (!(least_step > 0 && least_step < 1)) {
    return out_of_range("least_step", "it is between 0 and 1", "1e-6 is usual");
  }
  if (!(first_penalty >= 0 && std::isfinite(first_penalty))) {
    return out_of_range("first_penalty", "a penalty is not negative", "0 chooses one");
  }
  if (!(penalty_growth > 1 && std::isfinite(penalty_growth))) {
    return out_of_range("penalty_growth", "the penalty has to grow", "10 is usual");
  }
  if (!(largest_penalty >= 1)) return out_of_range("largest_penalty", "it is over the first one", "1e14 is usual");
  return {};
}

Result<TotalResult> minimize_in_total_space(StructureProblem& problem, const TotalOptions& options,
                                            const Context& context) {
  if (const Status s = options.validate(); !s) return s.error();
  Result<std::unique_ptr<TotalSpace>> space = TotalSpace::make(problem, context);
  if (!space) return space.error();
  if (options.method == TotalMethod::kLagrangeNewton) {
    if (const Status s = space.value()->check_curvature(); !s) return s.error();
  }
  TotalResult result;
  TotalRun run(*space.value(), options, context, result);
  const auto* const method =
      std::find_if(kRunners.begin(), kRunners.end(), [&](const Runner& m) { return m.info.method == options.method; });
  LISSOM_ASSERT(method != kRunners.end());
  method->run(run);
  result.point = space.value()->point();
  if (const Status s = settle(problem, run.first_gradient(), context, result); !s) return s.error();
  return result;
}

}  // namespace lissom
