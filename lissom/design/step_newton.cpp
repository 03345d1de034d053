/// Newton's method with exact Hessians as products [mathematics 5.2], and Gauss-Newton's with products of first derivatives, in
/// a box-shaped trust region: bounds of the parameters and of the region are one box, so negative curvature needs no care of its
/// own.

#include <algorithm>
#include <cmath>
#include <random>

#include "lissom/design/box_cg.h"
#include "lissom/design/one_sided_cg.h"
#include "lissom/design/step_method.h"

namespace lissom {

namespace {

constexpr int kProbes = 12;          // of the sizes of columns
constexpr double kLeastSize = 1e-3;  // of the largest: columns below are not told apart

/// Norms of the columns of J, about, at least a share of the largest: the mean of (J'w)_i^2 over signs w at random, always the
/// same ones [Hutchinson 1990].
VecX column_sizes(ReducedProblem& problem) {
  std::mt19937 random(1);
  VecX squares = VecX::Zero(problem.size()), w(problem.residual().size());
  for (int k = 0; k < kProbes; ++k) {
    for (double& sign : w) sign = (random() & 1u) != 0 ? 1 : -1;
    squares += problem.jacobian_transposed_times(w).cwiseAbs2();
  }
  const VecX size = (squares / kProbes).cwiseSqrt();
  const double largest = size.maxCoeff();
  return largest > 0 ? VecX(size.cwiseMax(kLeastSize * largest)) : VecX::Ones(size.size());
}

/// Of the gradient, where the box leaves room.
double largest_with_room(const VecX& g, const VecX& lower, const VecX& upper) {
  double largest = 0;
  for (int i = 0; i < g.size(); ++i) {
    if (g[i] > 0 ? lower[i] < 0 : upper[i] > 0) largest = std::max(largest, std::abs(g[i]));
  }
  return largest;
}

class ByProducts final : public StepMethod {
 public:
  enum class Second { kExact, kGaussNewton };
  explicit ByProducts(Second second) : second_(second) {}

  StepEnd iterate(Iteration& work) const override {
    OptimizerState& state = work.state;
    VecX lower, upper;
    work.box(state.cap, lower, upper);
    // The nearer the end, the more exactly: converges superlinearly, in the end quadratically, for few products before.
    const double share = std::min(work.options.newton_forcing, std::sqrt(work.record.gradient / state.first_gradient));
    const BoxCgSolution model = second_ == Second::kExact ? exact_model(work, lower, upper, share)
                                                          : gauss_newton_model(work, lower, upper, share);
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
  /// `share`: of the gradient, to which its models are solved.
  static BoxCgSolution exact_model(Iteration& work, const VecX& lower, const VecX& upper, double share) {
    ReducedProblem& problem = work.problem;
    const double tolerance = share * largest_with_room(problem.gradient(), lower, upper);
    const MatX none;
    const bool gram = work.options.preconditioner == NewtonPreconditioner::kGram;
    const auto times = [&problem](const VecX& v) -> VecX { return problem.hessian_times(v); };
    return solve_box_cg(times, problem.gradient(), lower, upper, gram ? problem.gram() : none, tolerance,
                        work.options.max_products);
  }

  /// In parameters over whose scale all residuals change by about 1: radii and places of a rest shape may differ by decades.
  static BoxCgSolution gauss_newton_model(Iteration& work, const VecX& lower, const VecX& upper, double share) {
    ReducedProblem& problem = work.problem;
    const VecX size = column_sizes(problem), s = size.cwiseInverse();
    const auto times = [&](const VecX& v) -> VecX {
      return s.cwiseProduct(problem.jacobian_transposed_times(problem.jacobian_times(s.cwiseProduct(v))));
    };
    const VecX g = s.cwiseProduct(problem.gradient());
    const VecX low = size.cwiseProduct(lower), high = size.cwiseProduct(upper);
    const double tolerance = share * largest_with_room(g, low, high);
    OneSided sided = problem.one_sided();
    if (sided.value.size() > 0) sided.rows = sided.rows * s.asDiagonal();
    BoxCgSolution model = solve_one_sided_cg(times, g, sided, low, high, tolerance, work.options.max_products);
    for (Eigen::Index i = 0; i < s.size(); ++i) {
      const double x = model.x[i];
      model.x[i] = x == low[i] ? lower[i] : x == high[i] ? upper[i] : std::clamp(s[i] * x, lower[i], upper[i]);
    }
    return model;
  }

  Second second_;
};

}  // namespace

std::unique_ptr<StepMethod> make_exact_newton() { return std::make_unique<ByProducts>(ByProducts::Second::kExact); }

std::unique_ptr<StepMethod> make_gauss_newton_products() {
  return std::make_unique<ByProducts>(ByProducts::Second::kGaussNewton);
}

}  // namespace lissom
