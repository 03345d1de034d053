#pragma once
/// Hard constraints of an inverse design by an augmented Lagrangian: rounds of unconstrained (but bounded) descent, after each
/// of which multipliers are corrected, and the penalty raised only when the violation has not fallen [Nocedal & Wright 2006,
/// 17.3]. Any method descends.

#include "lissom/design/optimizer.h"

namespace lissom {

struct ConstraintOptions {
  double tolerance = 1e-6;  ///< largest violation, over the scales of the constraints
  int max_rounds = 30;
  double first_penalty = 0;  ///< unit of h; 0: such that a violation weighs about as much as what h has besides
  double penalty_growth = 10;
  double enough_fall = 0.25;  ///< a violation that has not fallen to this share of the one before raises the penalty

  Status validate() const;
};

struct ConstrainedState {
  VecX multipliers;  ///< (constraints), unit of h
  double penalty = 0;
  double first_violation = 0;  ///< at the start, at least a tenth of the scale
  double violation = -1;       ///< after the last round, with slack that multipliers deny; below 0: no round yet
  int round = 0;
  int round_began = -1;  ///< iteration of the descent at which this round began; below 0: the first round
  int stuck = 0;         ///< rounds in a row whose violation hardly fell
  OptimizerState inner;  ///< of the last saved moment; its records run over all rounds
  std::optional<DesignVerdict> verdict;
  std::string message;
};

class AugmentedLagrangian {
 public:
  /// Begins at the point of `problem`. Error: options, or more equality constraints than parameters that can move.
  static Result<AugmentedLagrangian> begin(ReducedProblem& problem, const OptimizeOptions& options,
                                           const ConstraintOptions& constraints);
  /// Goes on from a saved state, at whose inner.x the problem has to stand.
  static Result<AugmentedLagrangian> resumed(ReducedProblem& problem, const OptimizeOptions& options,
                                             const ConstraintOptions& constraints, ConstrainedState state);

  /// One iteration of the descent, or the end of a round. False: there is a verdict, and nothing was done.
  bool step(const Context& context);
  DesignVerdict run(const Context& context);

  /// A copy to save.
  ConstrainedState state() const;
  const Optimizer& descent() const { return inner_; }

 private:
  AugmentedLagrangian(ReducedProblem& problem, const OptimizeOptions& options, const ConstraintOptions& constraints,
                      ConstrainedState state, Optimizer inner);

  static OptimizeOptions of_round(const OptimizeOptions& options, int round);
  bool last_precision() const;
  void end_round(DesignVerdict descent);
  void next_round();
  void end(DesignVerdict verdict, const std::string& message);

  ReducedProblem* problem_;
  OptimizeOptions options_;
  ConstraintOptions constraints_;
  ConstrainedState state_;  // but for `inner`
  Optimizer inner_;
};

/// How far each constraint is from being met with these multipliers: c, or max(c, -multiplier / penalty) where c <= 0 is
/// wanted, so that neither violation nor slack under a positive multiplier remains. (constraints)
VecX constraint_gaps(const ReducedProblem& problem, const VecX& multipliers, double penalty);

}  // namespace lissom
