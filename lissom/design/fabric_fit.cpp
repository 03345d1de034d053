#include "lissom/design/fabric_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "lissom/core/dual.h"
#include "lissom/core/types.h"

namespace lissom {

namespace {

constexpr int kMostIterations = 200;

template <class T>
T squared(const T& x) {
  return x * x;
}

/// Stretch along from its cubic lambda^3 - lambda = 2 f / Y, and across. `y1` and `y2` are inverse roots of the moduli.
template <class T>
struct Strip {
  T stretch, across;

  Strip(const T& y1, const T& y2, const T& mu, double angle, double force) {
    using std::sqrt;
    const double c = std::cos(angle), s = std::sin(angle);
    const T softness = squared(T(c * c) * y1 + T(s * s) * y2);
    const T load = T(2 * force) * softness;
    double root = std::max(1.0, std::cbrt(primal(load)));
    for (int i = 0; i < 60; ++i) root -= (root * root * root - root - primal(load)) / (3 * root * root - 1);
    // One step more with derivatives: the root as a function of the moduli.
    stretch = T(root) - (T(root * root * root - root) - load) / T(3 * root * root - 1);
    const T tension = T(force) / stretch;
    const T e11 = tension * (T(c * c) * y1 * y1 - T(s * s) * mu * y1 * y2);
    const T e22 = tension * (T(s * s) * y2 * y2 - T(c * c) * mu * y1 * y2);
    const T e12 = tension * T(c * s) * (T(1) + mu) * y1 * y2;
    across = sqrt(T(1) + T(2) * (T(s * s) * e11 + T(c * c) * e22 - T(2 * s * c) * e12));
  }
};

using Moduli = Eigen::Vector3d;  ///< log of the inverse roots of Y1 and Y2, mu

int measured(const FabricTest& test) {
  int count = 0;
  for (const StripPull& pull : test.pulls) count += pull.across > 0 ? 2 : 1;
  return count;
}

/// Deviations of the computed from the measured stretches, and their derivatives by (y1, y2, mu) times (y1, y2, 1).
VecX deviations(const FabricTest& test, const Moduli& p, MatX* slopes) {
  using Dual = Dual2<3>;
  const double y1 = std::exp(p[0]), y2 = std::exp(p[1]);
  VecX r(measured(test));
  if (slopes != nullptr) slopes->resize(r.size(), 3);
  int row = 0;
  const auto put = [&](const Dual& computed, double seen) {
    r[row] = computed.a - seen;
    if (slopes != nullptr) slopes->row(row) << computed.g[0] * y1, computed.g[1] * y2, computed.g[2];
    ++row;
  };
  for (const StripPull& pull : test.pulls) {
    const Strip<Dual> s(Dual::variable(y1, 0), Dual::variable(y2, 1), Dual::variable(p[2], 2), pull.angle,
                        pull.force_per_width);
    put(s.stretch, pull.stretch);
    if (pull.across > 0) put(s.across, pull.across);
  }
  return r;
}

/// Inverse roots of the moduli are linear in those that single pulls have: a start close to the end.
Moduli first_guess(const FabricTest& test) {
  MatX rows(test.pulls.size(), 2);
  VecX right(test.pulls.size());
  for (size_t i = 0; i < test.pulls.size(); ++i) {
    const StripPull& pull = test.pulls[i];
    const double c = std::cos(pull.angle), s = std::sin(pull.angle);
    const double strain = 0.5 * std::max(1e-6, pull.stretch * pull.stretch - 1);
    rows.row(static_cast<int>(i)) << c * c, s * s;
    right[static_cast<int>(i)] = std::sqrt(strain * pull.stretch / pull.force_per_width);
  }
  const Vec2 y = rows.colPivHouseholderQr().solve(right);
  const double least = 1e-3 * right.maxCoeff();
  return Moduli(std::log(std::max(least, y[0])), std::log(std::max(least, y[1])), 0.3);
}

Error undetermined(const FabricTest& test, const std::string& where) {
  const bool across =
      std::any_of(test.pulls.begin(), test.pulls.end(), [](const StripPull& p) { return p.across > 0; });
  return {ErrorCode::kConflict, where,
          across ? "these pulls do not determine both moduli and the Poisson ratio"
                 : "the pulls say nothing about the Poisson ratio, on which only the stretch across depends",
          across ? "test strips in at least two directions, say along the warp and along the weft"
                 : "add \"across\" to at least one pull"};
}

}  // namespace

double FabricFit::shear() const { return std::sqrt(stiffness_1 * stiffness_2) / (2 * (1 + poisson_ratio)); }

double FabricFit::modulus(double angle) const {
  const double c = std::cos(angle), s = std::sin(angle);
  return 1 / squared(c * c / std::sqrt(stiffness_1) + s * s / std::sqrt(stiffness_2));
}

StripState strip_state(const FabricFit& fabric, double angle, double force_per_width) {
  const Strip<double> s(1 / std::sqrt(fabric.stiffness_1), 1 / std::sqrt(fabric.stiffness_2), fabric.poisson_ratio,
                        angle, force_per_width);
  return {s.stretch, s.across};
}

Result<FabricFit> fit_fabric(const FabricTest& test, const std::string& where) {
  if (measured(test) < 3) return undetermined(test, where);
  Moduli p = first_guess(test);
  MatX slopes;
  VecX r = deviations(test, p, &slopes);
  FabricFit fit;
  double damping = 1e-6;
  for (; fit.iterations < kMostIterations; ++fit.iterations) {
    const Eigen::Matrix3d normal = slopes.transpose() * slopes;
    const Eigen::Vector3d gradient = slopes.transpose() * r;
    const Eigen::Vector3d size = normal.diagonal().cwiseSqrt();
    if (!(size.minCoeff() > 0)) return undetermined(test, where);
    const Eigen::Matrix3d scaled = size.cwiseInverse().asDiagonal() * normal * size.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(scaled);
    if (!(eigen.eigenvalues()[0] > 1e-10)) return undetermined(test, where);
    const Eigen::Matrix3d damped = scaled + damping * Eigen::Matrix3d::Identity();
    const Moduli step =
        -(size.cwiseInverse().asDiagonal() * damped.ldlt().solve(size.cwiseInverse().cwiseProduct(gradient)));
    Moduli next = p + step;
    next[2] = std::clamp(next[2], -0.999, 0.999);
    const VecX there = deviations(test, next, nullptr);
    if (there.allFinite() && there.squaredNorm() <= r.squaredNorm()) {
      p = next;
      r = deviations(test, p, &slopes);
      damping /= 10;
      if (step.cwiseAbs().maxCoeff() < 1e-12) break;
    } else {
      if (step.cwiseAbs().maxCoeff() < 1e-10) break;
      damping = std::max(10 * damping, 1e-6);
    }
  }
  if (!r.allFinite()) {
    return Error{ErrorCode::kGeometry, where, "no orthotropic fabric comes near these pulls",
                 "check the units, and that angles are counted from the warp"};
  }
  fit.stiffness_1 = std::exp(-2 * p[0]);
  fit.stiffness_2 = std::exp(-2 * p[1]);
  fit.poisson_ratio = p[2];
  fit.rms = std::sqrt(r.squaredNorm() / static_cast<double>(r.size()));
  fit.largest = r.cwiseAbs().maxCoeff();
  return fit;
}

}  // namespace lissom
