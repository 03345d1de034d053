#pragma once
/// All that an inverse design remembers between its iterations, as plain data, and how it can end.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/core/types.h"
#include "lissom/design/reduced_problem.h"
#include "lissom/design/secant.h"

namespace lissom {

/// The fixed list of endings. Names and sentences are in design_verdicts().
enum class DesignVerdict {
  kConverged,        ///< no first-order promise is left, or none that is worth a step
  kGoodEnough,       ///< h is as low as was asked for
  kCancelled,        ///< stopped by the caller; may be continued
  kLimit,            ///< no step lowers h although a gradient is left
  kJumped,           ///< every step that is left ends on another branch
  kNoEquilibrium,    ///< every step that is left ends without a stable equilibrium
  kIterationLimit,   ///< may be continued with more
  kInfeasible,       ///< hard constraints that cannot be met
  kConstraintLimit,  ///< hard constraints not met as precisely as asked, or not yet when the rounds ran out
  kBadStart,         ///< value or gradient of the start are not finite
};

struct DesignVerdictInfo {
  DesignVerdict verdict;
  std::string_view name;      ///< "converged", as in JSON
  std::string_view sentence;  ///< for people
};
const std::array<DesignVerdictInfo, 10>& design_verdicts();
const DesignVerdictInfo& design_verdict_info(DesignVerdict verdict);

/// Attempts, by Outcome.
struct OutcomeCounts {
  std::array<int, 6> counts{};

  int& operator[](Outcome outcome) { return counts[static_cast<std::size_t>(outcome)]; }
  int operator[](Outcome outcome) const { return counts[static_cast<std::size_t>(outcome)]; }
  int total() const;
};

struct DesignRecord {
  int iteration = 0;
  bool accepted = false;
  double value = 0;          ///< h after the iteration
  double gradient = 0;       ///< largest first-order promise at the point it began at, unit of h
  double predicted = 0;      ///< decrease of h that the model of the last step tried had promised
  double step_length = 0;    ///< largest change of a parameter, in scales, of the last step tried
  int active_bounds = 0;     ///< parameters that the gradient holds at a bound, before the step
  OutcomeCounts attempts;    ///< of this iteration
  double cap = 0;            ///< cap or radius afterwards, in scales
  double damping = 0;        ///< mu of Levenberg-Marquardt afterwards; else what the model lacked in curvature
  int hessian_products = 0;  ///< of exact Newton
  DesignEffort effort;       ///< so far
  int iterations_left = -1;  ///< at the present pace; -1: cannot be said yet
};

/// May be saved and restored at any time between iterations: the rest of the run has the same bytes, if the problem is
/// brought back to `x` and gives the same bytes there.
struct OptimizerState {
  VecX x;  ///< the point that all of this is about
  int iteration = 0;
  double first_gradient = -1;              ///< largest first-order promise at the start; below 0: not known yet
  double cap = 0;                          ///< of line searches, radius of trust regions, in scales
  double damping = 0, damping_growth = 0;  ///< of Levenberg-Marquardt
  SecantMemory secant;

  /// The last accepted step, not yet learned from: J'J of the new point is computed only if there is another iteration.
  bool has_lesson = false;
  VecX step, gradient_before, pull;  ///< pull = J_{k-1}' r_k

  OutcomeCounts rejected;  ///< attempts since the last accepted step
  VecX promise;            ///< per parameter, unit of h; see first_order_promise
  DesignEffort effort;
  std::vector<DesignRecord> records;
  std::optional<DesignVerdict> verdict;  ///< none: may go on
  std::string message;                   ///< one sentence: the verdict with its reason
};

/// What h would gain to first order if a parameter moved by one scale, or as far as its bounds allow, with the sign of the
/// gradient: 0 where a bound holds it. Scales with h, unlike distances between x and the clipped x - g.
VecX first_order_promise(const VecX& x, const VecX& gradient, const VecX& lower, const VecX& upper);

struct ParameterShare {
  int parameter = -1;
  double value = 0;
};
/// The largest entries by size, at most `count`, none of them 0.
std::vector<ParameterShare> largest_entries(const VecX& values, int count);

}  // namespace lissom
