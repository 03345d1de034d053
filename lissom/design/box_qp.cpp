#include "lissom/design/box_qp.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lissom/core/assert.h"
#include "lissom/design/box_interior.h"
#include "lissom/design/free_factor.h"

namespace lissom {

namespace {

constexpr double kArmijo = 1e-4;
constexpr int kBeforeInterior = 12;  // steps by which easy problems have ended

VecX clipped(const VecX& x, const VecX& lower, const VecX& upper) { return x.cwiseMax(lower).cwiseMin(upper); }

/// Begins at what interior points have found: what is pushed harder than it is away from its bound is at it.
VecX from_interior(const MatX& b, double damping, const VecX& g, const VecX& lower, const VecX& upper,
                   int& factorizations) {
  const BoxInterior interior = solve_box_interior(b, damping, g, lower, upper);
  factorizations += interior.factorizations;
  VecX x = interior.x;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (!(upper[i] - lower[i] < std::numeric_limits<double>::infinity())) continue;
    // In units of the box and of the gradient, so that both compare.
    const double width = std::max(upper[i] - lower[i], 1e-300), size = std::max(std::abs(g[i]), g.cwiseAbs().mean());
    if (interior.push_lower[i] / size > (x[i] - lower[i]) / width) x[i] = lower[i];
    if (interior.push_upper[i] / size > (upper[i] - x[i]) / width) x[i] = upper[i];
  }
  return clipped(x, lower, upper);
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
  FreeFactor factor;
  int interior = 0;  // factorisations of interior points
  std::vector<int> free;
  VecX image = b * out.x, gradient(m);
  for (;; ++out.iterations) {
    gradient = image + g + out.damping * out.x;
    free.clear();
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
    if (out.iterations == kBeforeInterior) {
      const VecX x = from_interior(b, factor.damping(), g, lower, upper, interior);
      out.factorizations = interior + factor.factorizations();
      const auto value = [&](const VecX& at, const VecX& image_at) {
        return at.dot(0.5 * (image_at + out.damping * at) + g);
      };
      const VecX image_x = b * x;
      if (value(x, image_x) < value(out.x, image)) {
        out.x = x;
        image = image_x;
        continue;
      }
    }
    factor.prepare(b, free, largest);
    out.factorizations = interior + factor.factorizations();
    gradient += (factor.damping() - out.damping) * out.x;
    out.damping = factor.damping();
    const VecX step = factor.solve(-gradient);
    bool moved = false;
    for (double a = 1; a > 1e-12 && !moved; a *= 0.5) {
      const VecX trial = clipped(out.x + a * step, lower, upper), move = trial - out.x;
      const VecX moved_image = b * move;
      // The change of the damped model, without the cancellation in the difference of two values.
      const double slope = gradient.dot(move), change = slope + 0.5 * move.dot(moved_image + out.damping * move);
      moved = change <= kArmijo * slope && trial != out.x;
      if (!moved) continue;
      out.x = trial;
      image += moved_image;
    }
    if (!moved) {  // rounding
      out.converged = left <= 1e3 * small;
      return out;
    }
  }
}

}  // namespace lissom
