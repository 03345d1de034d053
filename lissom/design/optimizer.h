#pragma once
/// Inverse design: lowers h of a reduced problem step by step, by any of the methods, stoppable and resumable between steps. The
/// point of the problem is always the best so far. [mathematics 5.4]

#include <memory>

#include "lissom/core/context.h"
#include "lissom/core/result.h"
#include "lissom/design/optimize_options.h"
#include "lissom/design/optimizer_state.h"
#include "lissom/design/reduced_problem.h"
#include "lissom/design/step_method.h"

namespace lissom {

class Optimizer {
 public:
  /// Begins at the point of `problem`, which has to outlive this, with bounds around it. `options` are to be valid.
  Optimizer(ReducedProblem& problem, const OptimizeOptions& options);
  /// Goes on from a saved state, at whose x `problem` has to stand. A verdict that can be continued is taken back. Error: a
  /// state that is not one of this problem, method or point.
  static Result<Optimizer> resumed(ReducedProblem& problem, const OptimizeOptions& options, OptimizerState state);

  /// One outer iteration, accepted or not. False: there is a verdict, and nothing was done. After kCancelled and
  /// kIterationLimit with more iterations allowed, the next call goes on.
  bool step(const Context& context);
  /// Steps until there is a verdict.
  DesignVerdict run(const Context& context);

  const OptimizerState& state() const { return state_; }
  const OptimizeOptions& options() const { return options_; }
  void set_options(const OptimizeOptions& options);
  /// To be called when h itself has changed under the point, as by multipliers: what steps have taught is kept, as most of h
  /// is what it was, but the last one is not learned from.
  void value_has_changed();

  /// s, at the present pace; negative: cannot be said yet. Of the clock, so not a part of the state.
  double seconds_left() const;

 private:
  bool look(DesignRecord& record);
  bool gropes(double gradient) const;
  void end(DesignVerdict verdict, const std::string& reason = {});
  void end_without_step();
  void finish_record(DesignRecord& record);
  int iterations_left() const;
  void tell(const Context& context) const;

  ReducedProblem* problem_;
  OptimizeOptions options_;
  std::unique_ptr<StepMethod> method_;
  OptimizerState state_;
  DesignEffort effort_before_;  // of the state, less what the problem had done when this began
  double seconds_ = 0;          // in iterations of this run
  int timed_ = 0;
};

}  // namespace lissom
