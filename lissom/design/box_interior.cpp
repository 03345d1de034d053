#include "lissom/design/box_interior.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace lissom {

namespace {

constexpr int kMostIterations = 60;
constexpr double kInside = 0.1;      // of the width of a box, from its sides, to begin with
constexpr double kFraction = 0.995;  // of the way to the boundary
constexpr double kStalled = 0.9;     // a step that leaves more than this share of both measures

/// One side of the box: distances s > 0 to it and what it pushes with, z > 0, where it is finite.
struct Side {
  double sign = 1;  // d s / d x
  std::vector<bool> finite;
  VecX s, z;

  Side(double direction, const VecX& x, const VecX& bound) : sign(direction), s(x.size()), z(VecX::Zero(x.size())) {
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      finite.push_back(std::isfinite(bound[i]));
      s[i] = finite.back() ? sign * (x[i] - bound[i]) : 1;
    }
  }
  void start(double mu) {
    for (Eigen::Index i = 0; i < s.size(); ++i) z[i] = finite[static_cast<std::size_t>(i)] ? mu / s[i] : 0;
  }
  VecX change(const VecX& dx) const { return sign * dx; }
  /// dz of a step dx towards s z = wanted.
  VecX push(const VecX& dx, const VecX& wanted) const {
    VecX dz = VecX::Zero(s.size());
    for (Eigen::Index i = 0; i < s.size(); ++i) {
      if (finite[static_cast<std::size_t>(i)]) dz[i] = (wanted[i] - z[i] * sign * dx[i]) / s[i] - z[i];
    }
    return dz;
  }
  /// How far a step may go, at most 1.
  double reach(const VecX& dx, const VecX& dz) const {
    double reach = 1;
    for (Eigen::Index i = 0; i < s.size(); ++i) {
      if (!finite[static_cast<std::size_t>(i)]) continue;
      if (sign * dx[i] < 0) reach = std::min(reach, kFraction * s[i] / (-sign * dx[i]));
      if (dz[i] < 0) reach = std::min(reach, kFraction * z[i] / -dz[i]);
    }
    return reach;
  }
  double gap() const { return s.dot(z); }
};

struct Step {
  VecX dx, dz_lower, dz_upper;
};

}  // namespace

BoxInterior solve_box_interior(const MatX& b, double damping, const VecX& g, const VecX& lower, const VecX& upper,
                               double tolerance) {
  const Eigen::Index m = g.size();
  BoxInterior out;
  out.x = VecX::Zero(m);
  std::vector<bool> fixed;
  double pairs = 0;
  for (Eigen::Index i = 0; i < m; ++i) {
    const double width = upper[i] - lower[i];
    fixed.push_back(!(width > 0));
    const double inset = std::isfinite(width) ? kInside * width : 1;
    out.x[i] = fixed.back() ? lower[i] : std::clamp(0.0, lower[i] + inset, upper[i] - inset);
    if (!fixed.back()) pairs += std::isfinite(lower[i]) + std::isfinite(upper[i]);
  }
  // Equal bounds are no sides: nothing moves between them.
  VecX low = lower, high = upper;
  for (Eigen::Index i = 0; i < m; ++i) {
    if (!fixed[static_cast<std::size_t>(i)]) continue;
    low[i] = -std::numeric_limits<double>::infinity();
    high[i] = std::numeric_limits<double>::infinity();
  }
  Side down(1, out.x, low), up(-1, out.x, high);
  const double size = std::max(g.cwiseAbs().maxCoeff(), 1e-300);
  const double mu_first = pairs > 0 ? size * (down.s.cwiseMin(up.s)).minCoeff() : 0;
  down.start(mu_first);
  up.start(mu_first);
  const auto clear_fixed = [&fixed](VecX& v) {
    for (std::size_t i = 0; i < fixed.size(); ++i) {
      if (fixed[i]) v[static_cast<Eigen::Index>(i)] = 0;
    }
  };
  MatX matrix;
  Eigen::LLT<MatX, Eigen::Lower> llt;
  double first = -1, last = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    VecX residual = b * out.x + damping * out.x + g - down.z + up.z;
    clear_fixed(residual);
    const double mu = pairs > 0 ? (down.gap() + up.gap()) / pairs : 0;
    const double measure = residual.cwiseAbs().maxCoeff() / size + (pairs > 0 ? mu / mu_first : 0);
    if (first < 0) first = measure;
    if (measure <= tolerance * first || (iteration > 3 && measure > kStalled * last)) break;
    last = measure;
    matrix = b;
    matrix.diagonal().array() += damping;
    matrix.diagonal() += down.z.cwiseQuotient(down.s) + up.z.cwiseQuotient(up.s);
    for (Eigen::Index i = 0; i < m; ++i) {
      if (!fixed[static_cast<std::size_t>(i)]) continue;
      matrix.row(i).setZero();
      matrix.col(i).setZero();
      matrix(i, i) = 1;
    }
    llt.compute(matrix);
    ++out.factorizations;
    if (llt.info() != Eigen::Success) break;
    // A step towards s z = wanted, of both sides.
    const auto step_to = [&](const VecX& wanted_lower, const VecX& wanted_upper) {
      VecX right = -residual + wanted_lower.cwiseQuotient(down.s) - down.z - wanted_upper.cwiseQuotient(up.s) + up.z;
      clear_fixed(right);
      Step step;
      step.dx = llt.solve(right);
      step.dz_lower = down.push(step.dx, wanted_lower);
      step.dz_upper = up.push(step.dx, wanted_upper);
      return step;
    };
    const auto reach = [&](const Step& step) {
      return std::min(down.reach(step.dx, step.dz_lower), up.reach(step.dx, step.dz_upper));
    };
    const VecX nothing = VecX::Zero(m);
    Step step = step_to(nothing, nothing);
    double a = reach(step);
    if (pairs > 0) {
      const double ahead = ((down.s + a * down.change(step.dx)).dot(down.z + a * step.dz_lower) +
                            (up.s + a * up.change(step.dx)).dot(up.z + a * step.dz_upper)) /
                           pairs;
      const double target = mu * std::pow(std::max(ahead, 0.0) / mu, 3);
      const VecX second_lower = down.change(step.dx).cwiseProduct(step.dz_lower);
      const VecX second_upper = up.change(step.dx).cwiseProduct(step.dz_upper);
      VecX wanted_lower = target - second_lower.array(), wanted_upper = target - second_upper.array();
      for (Eigen::Index i = 0; i < m; ++i) {
        if (!down.finite[static_cast<std::size_t>(i)]) wanted_lower[i] = 0;
        if (!up.finite[static_cast<std::size_t>(i)]) wanted_upper[i] = 0;
      }
      step = step_to(wanted_lower, wanted_upper);
      a = reach(step);
    }
    out.x += a * step.dx;
    down.z += a * step.dz_lower;
    up.z += a * step.dz_upper;
    for (Eigen::Index i = 0; i < m; ++i) {
      if (down.finite[static_cast<std::size_t>(i)]) down.s[i] = std::max(down.s[i] + a * step.dx[i], 1e-300);
      if (up.finite[static_cast<std::size_t>(i)]) up.s[i] = std::max(up.s[i] - a * step.dx[i], 1e-300);
    }
  }
  out.push_lower = down.z;
  out.push_upper = up.z;
  return out;
}

}  // namespace lissom
