#pragma once
/// One outer iteration of a method of inverse design: a model of h at the point, a step that the model likes, attempts. Methods
/// have no memory of their own: what they know is in the OptimizerState.

#include <memory>

#include "lissom/core/context.h"
#include "lissom/design/box_qp.h"
#include "lissom/design/optimize_options.h"
#include "lissom/design/optimizer_state.h"
#include "lissom/design/reduced_problem.h"

namespace lissom {

enum class StepEnd {
  kAccepted,
  kRejected,     ///< with shorter steps left to try
  kExhausted,    ///< no shorter step is worth an attempt
  kNothingLeft,  ///< the model promises too little: converged
  kCancelled,    ///< the state is to be put back
};

/// What an iteration sees and changes: the problem, the state, the record being written.
class Iteration {
 public:
  Iteration(ReducedProblem& p, OptimizerState& s, const OptimizeOptions& o, const Context& c, DesignRecord& r)
      : problem(p), state(s), options(o), context(c), record(r) {}

  ReducedProblem& problem;
  OptimizerState& state;
  const OptimizeOptions& options;
  const Context& context;
  DesignRecord& record;

  /// The box around 0 that keeps x + d in bounds and d within the cap; 0 is in it.
  void box(double cap, VecX& lower, VecX& upper) const;

  /// Attempts x + d; the change of h, or infinity unless it settled at a finite value, which is counted in any case. The
  /// change is taken from the residuals, (r1 - r0)'(r1 + r0) / 2: near the end it is far below the rounding of h.
  double change(const VecX& d);
  /// Of the last attempt, or by the context.
  bool cancelled() const { return cancelled_ || context.cancelled(); }
  /// The last attempt becomes the point. `d` as given to `change`.
  void accept(const VecX& d);

  /// Whether a promised decrease is below what rounding lets one see in h. All that can be asked then is that h has not risen,
  /// to rounding; such steps go on as long as the gradient falls by them.
  bool below_rounding(double predicted) const;
  static bool hidden(double predicted, double value);
  bool has_not_risen(double change) const;
  /// The predicted decrease is recorded; whether it is too small to go on. `whole`: nothing but bounds has cut the step.
  enum class Cut { kWhole, kCut };
  bool promises_too_little(double predicted, Cut cut);
  /// Ends an iteration whose promise is too little: a model that promises nothing where the gradient does has failed.
  StepEnd without_promise() const;
  /// Ends an iteration none of whose steps was any good, the last one d: whether there are shorter ones.
  StepEnd after_failure(const VecX& d, double predicted) const;

 private:
  bool learns_structure() const;

  bool cancelled_ = false;
};

/// Model of h around the point of the secant methods, what the last step has taught included.
MatX secant_model(Iteration& work);
/// Forgets what steps have taught; whether there was anything.
bool forget_secants(Iteration& work);

class StepMethod {
 public:
  virtual ~StepMethod() = default;
  virtual StepEnd iterate(Iteration& work) const = 0;
};

std::unique_ptr<StepMethod> make_step_method(const OptimizeOptions& options);
std::unique_ptr<StepMethod> make_line_search();
std::unique_ptr<StepMethod> make_trust_region();
std::unique_ptr<StepMethod> make_levenberg_marquardt();
std::unique_ptr<StepMethod> make_exact_newton();
std::unique_ptr<StepMethod> make_gauss_newton_products();

/// A trust region's answer to an attempt that changed h by `change` (infinity: failed) where the model had promised
/// `predicted` > 0: accepts or rejects and sets the radius, state.cap [Nocedal & Wright 2006, 4.1].
StepEnd judge_by_radius(Iteration& work, const VecX& d, double predicted, double change);

}  // namespace lissom
