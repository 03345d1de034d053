#include "lissom/design/box_qp.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "lissom/core/assert.h"

namespace lissom {

namespace {

constexpr double kArmijo = 1e-4;
constexpr double kLeastDamping = 1e-10, kDampingGrowth = 10;  // of the largest diagonal entry

VecX clipped(const VecX& x, const VecX& lower, const VecX& upper) { return x.cwiseMax(lower).cwiseMin(upper); }

double value(const MatX& b, const VecX& g, const VecX& x) { return x.dot(0.5 * (b * x) + g); }

/// Newton step of the free parameters; raises the damping until their part of B is positive definite.
VecX newton_step(const MatX& b, const VecX& gradient, const std::vector<int>& free, double largest, double& damping) {
  const int n = static_cast<int>(free.size());
  MatX part(n, n);
  VecX right(n);
  for (int i = 0; i < n; ++i) {
    right[i] = -gradient[free[i]];
    for (int j = 0; j < n; ++j) part(i, j) = b(free[i], free[j]);
  }
  for (;;) {
    MatX damped = part;
    damped.diagonal().array() += damping;
    const Eigen::LLT<MatX> factor(damped);
    if (factor.info() == Eigen::Success) return factor.solve(right);
    damping = std::max(kDampingGrowth * damping, kLeastDamping * largest);
  }
}

}  // namespace

BoxQpSolution solve_box_qp(const MatX& b, const VecX& g, const VecX& lower, const VecX& upper, double tolerance,
                           int max_iterations) {
  const int m = static_cast<int>(g.size());
  LISSOM_ASSERT(b.rows() == m && b.cols() == m && lower.size() == m && upper.size() == m);
  LISSOM_ASSERT((lower.array() <= upper.array()).all() && b.allFinite() && g.allFinite());
  BoxQpSolution out;
  out.at_bound.assign(m, false);
  out.x = clipped(VecX::Zero(m), lower, upper);
  const double largest = std::max(b.diagonal().cwiseAbs().maxCoeff(), 1e-300);
  const double small = tolerance * std::max(g.cwiseAbs().maxCoeff(), 1e-300);
  VecX gradient(m);
  for (;; ++out.iterations) {
    gradient = b * out.x + g + out.damping * out.x;
    std::vector<int> free;
    double left = 0;  // of the gradient, in what may still move along it
    for (int i = 0; i < m; ++i) {
      const bool low = out.x[i] <= lower[i] && gradient[i] >= 0, high = out.x[i] >= upper[i] && gradient[i] <= 0;
      out.at_bound[i] = low || high;
      if (out.at_bound[i]) continue;
      free.push_back(i);
      left = std::max(left, std::abs(gradient[i]));
    }
    out.projected_gradient = left;
    if (!(left > small)) {
      out.converged = true;
      return out;
    }
    if (out.iterations >= max_iterations) return out;
    const double damping_before = out.damping;
    const VecX step = newton_step(b, gradient, free, largest, out.damping);
    if (out.damping > damping_before) gradient += (out.damping - damping_before) * out.x;
    MatX damped = b;
    damped.diagonal().array() += out.damping;
    const double before = value(damped, g, out.x);
    bool moved = false;
    for (double a = 1; a > 1e-12 && !moved; a *= 0.5) {
      VecX trial = out.x;
      for (int k = 0; k < static_cast<int>(free.size()); ++k) trial[free[k]] += a * step[k];
      trial = clipped(trial, lower, upper);
      moved = value(damped, g, trial) <= before + kArmijo * gradient.dot(trial - out.x);
      if (moved) moved = trial != out.x;
      if (moved) out.x = trial;
    }
    if (!moved) {  // rounding
      out.converged = left <= 1e3 * small;
      return out;
    }
  }
}

}  // namespace lissom
