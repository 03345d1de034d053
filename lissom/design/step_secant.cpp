/// Secant methods: a quadratic model over the box, and either a line search or a box-shaped trust region
/// [mathematics 5.4, errata E18 and E21].

#include <algorithm>
#include <cmath>

#include "lissom/design/step_method.h"

namespace lissom {

namespace {

constexpr double kArmijo = 1e-4;
constexpr double kMissing = 1e-6;  // of the largest diagonal entry: curvature whose lack makes the model doubtful

/// The step that the model likes within the bounds and the cap.
struct Proposal {
  VecX d;
  double slope = 0, predicted = 0;  // g'd, decrease
  Iteration::Cut cut = Iteration::Cut::kWhole;
};

Proposal propose(Iteration& work, const MatX& model) {
  const VecX& g = work.problem.gradient();
  VecX lower, upper;
  work.box(work.state.cap, lower, upper);
  const BoxQpSolution solution = solve_box_qp(model, g, lower, upper);
  Proposal p;
  p.d = solution.x;
  p.slope = g.dot(p.d);
  p.predicted = -(p.slope + 0.5 * p.d.dot(model * p.d));
  work.record.damping = solution.damping;
  const bool cut = p.d.cwiseAbs().maxCoeff() >= work.state.cap * (1 - 1e-9);
  const bool doubtful = solution.damping > kMissing * model.diagonal().cwiseAbs().maxCoeff();
  if (cut || doubtful) p.cut = Iteration::Cut::kCut;
  return p;
}

/// Where the model promises nothing: J'J alone may.
StepEnd without_promise(Iteration& work) {
  const StepEnd end = work.without_promise();
  return end == StepEnd::kExhausted && forget_secants(work) ? StepEnd::kRejected : end;
}

class LineSearch final : public StepMethod {
 public:
  StepEnd iterate(Iteration& work) const override {
    OptimizerState& state = work.state;
    const Proposal p = propose(work, secant_model(work));
    if (work.promises_too_little(p.predicted, p.cut)) return without_promise(work);
    const double length = p.d.cwiseAbs().maxCoeff();
    const bool full = length >= state.cap * (1 - 1e-9);
    const bool blind = work.below_rounding(p.predicted);
    double a = 1;
    for (int halvings = 0;; ++halvings, a *= 0.5) {
      const VecX d = a * p.d;
      const double change = work.change(d);
      if (work.cancelled() && !std::isfinite(change)) return StepEnd::kCancelled;
      if (blind ? work.has_not_risen(change) : change <= kArmijo * a * p.slope) {
        if (a == 1 && full) state.cap *= 2;
        if (a < 1) state.cap = a * std::min(state.cap, 2 * length);
        work.accept(d);
        return StepEnd::kAccepted;
      }
      if (work.cancelled()) return StepEnd::kCancelled;
      if (blind || halvings >= work.options.max_halvings || a * length < 2 * work.options.least_step) break;
    }
    // The model may be what is wrong: the next iteration begins with J'J alone.
    state.cap = 0.5 * a * length;
    const StepEnd end = work.after_failure(a * p.d, p.predicted);
    if (end == StepEnd::kNothingLeft || !forget_secants(work)) return end;
    if (end == StepEnd::kExhausted) state.cap = std::max(state.cap, std::sqrt(work.options.least_step));
    return StepEnd::kRejected;
  }
};

class TrustRegion final : public StepMethod {
 public:
  StepEnd iterate(Iteration& work) const override {
    const Proposal p = propose(work, secant_model(work));
    if (work.promises_too_little(p.predicted, p.cut)) return without_promise(work);
    const double change = work.change(p.d);
    if (work.cancelled() && !std::isfinite(change)) return StepEnd::kCancelled;
    const StepEnd end = judge_by_radius(work, p.d, p.predicted, change);
    if (end != StepEnd::kExhausted || !forget_secants(work)) return end;
    work.state.cap = std::max(work.state.cap, std::sqrt(work.options.least_step));
    return StepEnd::kRejected;
  }
};

}  // namespace

std::unique_ptr<StepMethod> make_line_search() { return std::make_unique<LineSearch>(); }
std::unique_ptr<StepMethod> make_trust_region() { return std::make_unique<TrustRegion>(); }

}  // namespace lissom
