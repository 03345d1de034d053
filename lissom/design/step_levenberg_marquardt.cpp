/// Levenberg-Marquardt within bounds: (J'J + mu diag(J'J)) d = -g, mu by how well the undamped model foretold h
/// [mathematics 5.3].

#include <algorithm>
#include <cmath>

#include "lissom/design/step_method.h"

namespace lissom {

namespace {

constexpr double kLeastRatio = 1e-4, kPoor = 0.25, kGood = 0.75;
constexpr double kGrowth = 4, kFall = 3, kLeastDamping = 1e-15;

class LevenbergMarquardt final : public StepMethod {
 public:
  StepEnd iterate(Iteration& work) const override {
    ReducedProblem& problem = work.problem;
    OptimizerState& state = work.state;
    const MatX& gram = problem.gram();
    const VecX& g = problem.gradient();
    // A parameter that nothing depends on has none of its own.
    const double least = std::max(work.options.least_damped * gram.diagonal().maxCoeff(), 1e-300);
    const VecX diagonal = gram.diagonal().cwiseMax(least);
    MatX damped = gram;
    damped.diagonal() += state.damping * diagonal;
    VecX lower, upper;
    work.box(state.cap, lower, upper);
    const VecX d = solve_box_qp(damped, g, lower, upper).x;
    const double predicted = -(g.dot(d) + 0.5 * d.dot(gram * d));
    const bool whole = state.damping < 1 && d.cwiseAbs().maxCoeff() < state.cap;
    if (work.promises_too_little(predicted, whole ? Iteration::Cut::kWhole : Iteration::Cut::kCut)) {
      return work.without_promise();
    }
    const double change = work.change(d);
    if (work.cancelled() && !std::isfinite(change)) return StepEnd::kCancelled;
    return judge(work, d, predicted, change);
  }

 private:
  static StepEnd judge(Iteration& work, const VecX& d, double predicted, double change) {
    OptimizerState& state = work.state;
    const bool blind = work.below_rounding(predicted);
    const double ratio = !blind ? -change / predicted : work.has_not_risen(change) ? kGood : -1;
    if (ratio > kLeastRatio) {
      if (ratio > kGood) state.damping = std::max(state.damping / kFall, kLeastDamping);
      if (ratio < kPoor) state.damping *= kGrowth;
      state.damping_growth = kGrowth;
      if (d.cwiseAbs().maxCoeff() >= 0.99 * state.cap) state.cap *= 2;
      work.accept(d);
      return StepEnd::kAccepted;
    }
    // Rejections in a row raise mu faster and faster [Nielsen 1999]. Where attempts fail, h says nothing about how much too
    // long they were, and mu too little about how long the next one will be.
    state.damping *= state.damping_growth;
    state.damping_growth *= 2;
    if (!std::isfinite(change)) state.cap = 0.5 * d.cwiseAbs().maxCoeff();
    return work.after_failure(d, predicted);
  }
};

}  // namespace

std::unique_ptr<StepMethod> make_levenberg_marquardt() { return std::make_unique<LevenbergMarquardt>(); }

}  // namespace lissom
