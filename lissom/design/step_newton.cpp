/// Newton's method with exact Hessians as products [mathematics 5.2], and Gauss-Newton's with products of first derivatives, in
/// a box-shaped trust region: bounds of the parameters and of the region are one box, so negative curvature needs no care of its
/// own.

#include <algorithm>
#include <cmath>

#include "lissom/design/box_cg.h"
#include "lissom/design/step_method.h"

namespace lissom {

namespace {

class ByProducts final : public StepMethod {
 public:
  enum class Second { kExact, kGaussNewton };
  explicit ByProducts(Second second) : second_(second) {}

  StepEnd iterate(Iteration& work) const override {
    ReducedProblem& problem = work.problem;
    OptimizerState& state = work.state;
    const VecX& g = problem.gradient();
    VecX lower, upper;
    work.box(state.cap, lower, upper);
    double left = 0;  // of the gradient, where the box leaves room
    for (int i = 0; i < g.size(); ++i) {
      if (g[i] > 0 ? lower[i] < 0 : upper[i] > 0) left = std::max(left, std::abs(g[i]));
    }
    // The nearer the end, the more exactly: converges superlinearly, in the end quadratically, for few products before.
    const double share = std::min(work.options.newton_forcing, std::sqrt(work.record.gradient / state.first_gradient));
    const MatX none;
    const bool exact = second_ == Second::kExact;
    const MatX& like_h = exact && work.options.preconditioner == NewtonPreconditioner::kGram ? problem.gram() : none;
    const auto times = [&problem, exact](const VecX& v) -> VecX {
      return exact ? problem.hessian_times(v) : problem.jacobian_transposed_times(problem.jacobian_times(v));
    };
    const BoxCgSolution model = solve_box_cg(times, g, lower, upper, like_h, share * left, work.options.max_products);
    work.record.hessian_products = model.products;
    const bool cut = model.negative_curvature || model.x.cwiseAbs().maxCoeff() >= state.cap * (1 - 1e-9);
    if (work.promises_too_little(model.decrease, cut ? Iteration::Cut::kCut : Iteration::Cut::kWhole)) {
      return work.without_promise();
    }
    if (work.context.cancelled()) return StepEnd::kCancelled;
    const double change = work.change(model.x);
    if (work.cancelled() && !std::isfinite(change)) return StepEnd::kCancelled;
    return judge_by_radius(work, model.x, model.decrease, change);
  }

 private:
  Second second_;
};

}  // namespace

std::unique_ptr<StepMethod> make_exact_newton() { return std::make_unique<ByProducts>(ByProducts::Second::kExact); }

std::unique_ptr<StepMethod> make_gauss_newton_products() {
  return std::make_unique<ByProducts>(ByProducts::Second::kGaussNewton);
}

}  // namespace lissom
