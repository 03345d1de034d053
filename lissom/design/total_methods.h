#pragma once
/// Methods of inverse design in total space, to compare those of the reduced problem with: states and parameters move together,
/// and states come into equilibrium only as the method converges [mathematics 5.5, errata E22, E23]. Each begins at the point
/// of a StructureProblem. In the end the state is settled by energy minimisation, because what satisfies the equations of
/// equilibrium need not be stable, and what is nearly in equilibrium has no h to compare.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/design/total_space.h"

namespace lissom {

enum class TotalMethod {
  kLagrangeNewton,       ///< Newton on the conditions of optimality, exact Hessian of the Lagrangian (4.11)
  kLagrangeGaussNewton,  ///< the same with the Hessian of h alone, without second derivatives of residuals
  kPenalty,              ///< h + mu/2 |c|^2, mu rising (4.13)
  kAugmentedLagrangian,  ///< h + lambda'c + mu/2 |c|^2 (4.15, corrected)
};

/// What |c| of the penalties is.
enum class PenaltyNorm {
  kForce,  ///< that of TotalSpace::constraint, as in the thesis: stiff directions count by the square of their stiffness
  kEnergy,  ///< c'H^-1 c with H of the start: the energy that unbalanced forces would set free there
};

struct TotalOptions {
  TotalMethod method = TotalMethod::kLagrangeNewton;
  int max_iterations = 200;
  /// Converged when in equilibrium (as precisely as solves of the problem) and when no parameter promises more than this share
  /// of what the best one promised at the start: the measure of OptimizeOptions, of S'h_q + h_p at the state at hand.
  double gradient_tolerance = 1e-6;
  /// Good enough when in equilibrium and h is not above; 0: never.
  double value_tolerance = 0;
  /// Largest change of a parameter in the first step, in scales; then it adapts.
  double first_cap = 1;
  /// Least fraction of a step that is tried by the Lagrange methods.
  double least_step = 1e-6;
  PenaltyNorm norm = PenaltyNorm::kEnergy;
  /// mu; 0: such that leaving equilibrium costs ten times what it gains. Multiplied by the growth: every time by kPenalty, by
  /// kAugmentedLagrangian where |c| has not fallen to a quarter.
  double first_penalty = 0;
  double penalty_growth = 10;
  double largest_penalty = 1e14;  ///< over the first one

  Status validate() const;
};

/// How a method ends. Names and sentences are in total_verdicts().
enum class TotalVerdict {
  kConverged,
  kGoodEnough,
  kIterationLimit,
  kStalled,       ///< no step lowers the merit function
  kSingular,      ///< a stiffness matrix, or the system of a step, is singular
  kPenaltyLimit,  ///< the penalty is as high as allowed, and forces are left
  kBadStart,
  kCancelled,
};

struct TotalVerdictInfo {
  TotalVerdict verdict;
  std::string_view name;      ///< "converged", as in tables
  std::string_view sentence;  ///< for people
};
const std::array<TotalVerdictInfo, 8>& total_verdicts();
const TotalVerdictInfo& total_verdict_info(TotalVerdict verdict);

/// One iteration: the point that it begins at, and the step from there.
struct TotalRecord {
  int iteration = 0;
  double value = 0;        ///< h
  double imbalance = 0;    ///< TotalSpace::imbalance: in equilibrium up to 1
  double gradient = 0;     ///< largest first-order promise, unit of h
  int negative = 0;        ///< negative eigenvalues of stiffness
  double merit_slope = 0;  ///< of the merit function along the step; of penalties the decrease that the model promises
  double step_length = 0;  ///< largest change of a parameter in the step, in scales
  double fraction = 0;     ///< of the step that was taken; 0: none
  double penalty = 0;      ///< weight of |c| in the merit function
  double damping = 0;      ///< of penalties
  TotalEffort effort;      ///< so far
  double seconds = 0;      ///< so far
};

struct TotalResult {
  TotalVerdict verdict = TotalVerdict::kBadStart;
  std::string message;  ///< one sentence: the verdict, and what is worst
  int iterations = 0;
  TotalEffort effort;  ///< without settling
  double seconds = 0;  ///< without settling
  std::vector<TotalRecord> records;

  // The point as the method left it.
  DesignPoint point;
  double value = 0;      ///< h
  double imbalance = 0;  ///< up to 1: in equilibrium
  double gradient = 0;   ///< largest first-order promise, over that at the start
  int negative = 0;      ///< negative eigenvalues of stiffness; above 0: not a stable state

  // The same parameters in equilibrium, by energy minimisation from there.
  Outcome settled = Outcome::kUnsettled;
  std::string settled_reason;   ///< unless kSettled
  double settled_value = 0;     ///< h, kSettled only
  double settled_gradient = 0;  ///< as above, kSettled only
  double settled_move = 0;      ///< m, root mean square over nodes, the worst pose
  int settled_factorizations = 0;
};

struct TotalMethodInfo {
  TotalMethod method;
  std::string_view name, meaning;
};
/// All methods, for tables and help.
const std::array<TotalMethodInfo, 4>& total_methods();
std::string_view total_method_name(TotalMethod method);

/// Runs a method from the point of `problem`, which has to have one. In the end the problem stands at the settled point, or
/// where it stood before if there is none. Errors are those of options, TotalSpace::make and, for kLagrangeNewton,
/// TotalSpace::check_curvature; everything else is a verdict.
Result<TotalResult> minimize_in_total_space(StructureProblem& problem, const TotalOptions& options,
                                            const Context& context);

}  // namespace lissom
