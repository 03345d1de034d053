#pragma once
/// The problems on which methods of inverse design are compared, each with its solution.

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <random>

#include "scenes/analytic_problem.h"

namespace lissom {

struct AnalyticCase {
  std::string name;
  AnalyticProblem problem;
  VecX solution;
};

/// Linear residuals in a box that holds some parameters at either bound: made so that `solution` meets the conditions of
/// optimality exactly.
inline AnalyticCase linear_in_box() {
  constexpr int kParameters = 12, kResiduals = 20;
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const auto any = [&] { return normal(random); };
  const MatX a = MatX::NullaryExpr(kResiduals, kParameters, any);
  VecX x = VecX::NullaryExpr(kParameters, any), g = VecX::Zero(kParameters);
  VecX lower = x.array() - 1, upper = x.array() + 2;
  for (int i = 0; i < 4; ++i) {
    g[i] = i % 2 == 0 ? 0.5 + i : -0.5 - i;
    (i % 2 == 0 ? lower : upper)[i] = x[i];
  }
  // Residuals r with A'r = g, and a part that no parameter can change.
  const MatX gram = a.transpose() * a;
  const VecX other = VecX::NullaryExpr(kResiduals, any), solved = gram.llt().solve(a.transpose() * other);
  const VecX r = a * gram.llt().solve(g) + other - a * solved;
  return {"linear in a box",
          AnalyticProblem(linear_functions(a, a * x - r), lower + 0.3 * (upper - lower), lower, upper), x};
}

inline SmoothFunctions rosenbrock() {
  return {[](const VecX& x) -> VecX { return Vec2(10 * (x[1] - x[0] * x[0]), 1 - x[0]); },
          [](const VecX& x) {
            MatX j(2, 2);
            j << -20 * x[0], 10, -1, 0;
            return j;
          },
          [](const VecX&, const VecX& w) {
            MatX c = MatX::Zero(2, 2);
            c(0, 0) = -20 * w[0];
            return c;
          }};
}

inline AnalyticCase rosenbrock_free() {
  return {"rosenbrock", AnalyticProblem(rosenbrock(), Vec2(-1.2, 1), boundless(2, -1), boundless(2, 1)), Vec2(1, 1)};
}

/// The valley's end cut off.
inline AnalyticCase rosenbrock_bounded() {
  return {"rosenbrock, bounded", AnalyticProblem(rosenbrock(), Vec2(-1.2, 1), Vec2(-2, -1), Vec2(0.8, 3)),
          Vec2(0.8, 0.64)};
}

/// Two exponentials through points that they miss by so much that Gauss-Newton comes nearer by `creep` per step only: at the
/// solution the misfit is orthogonal to J, and its second part -creep of J'J in one direction.
inline constexpr int kPoints = 12;
inline AnalyticCase exponential_fit(double creep = 0.9) {
  const SmoothFunctions model{[](const VecX& x) -> VecX {
                                VecX f(kPoints);
                                for (int i = 0; i < kPoints; ++i) {
                                  const double t = 0.25 * i;
                                  f[i] = x[0] * std::exp(-x[1] * t) + x[2] * std::exp(-x[3] * t);
                                }
                                return f;
                              },
                              [](const VecX& x) {
                                MatX j(kPoints, 4);
                                for (int i = 0; i < kPoints; ++i) {
                                  const double t = 0.25 * i, e = std::exp(-x[1] * t), f = std::exp(-x[3] * t);
                                  j.row(i) << e, -t * x[0] * e, f, -t * x[2] * f;
                                }
                                return j;
                              },
                              [](const VecX& x, const VecX& w) {
                                MatX c = MatX::Zero(4, 4);
                                for (int i = 0; i < kPoints; ++i) {
                                  const double t = 0.25 * i, e = std::exp(-x[1] * t), f = std::exp(-x[3] * t);
                                  c(0, 1) -= w[i] * t * e;
                                  c(1, 1) += w[i] * t * t * x[0] * e;
                                  c(2, 3) -= w[i] * t * f;
                                  c(3, 3) += w[i] * t * t * x[2] * f;
                                }
                                c(1, 0) = c(0, 1);
                                c(3, 2) = c(2, 3);
                                return c;
                              }};
  VecX x(4);
  x << 1, 0.4, -2, 2.5;
  const MatX j = model.jacobian(x), gram = j.transpose() * j;
  VecX n(kPoints);
  for (int i = 0; i < kPoints; ++i) n[i] = (i % 2 == 0 ? 1 : -1) + 0.3 * std::cos(2.0 * i);
  n -= j * gram.llt().solve(j.transpose() * n);
  n -= j * gram.llt().solve(j.transpose() * n);  // once more for the last digits
  const VecX shares =
      Eigen::GeneralizedSelfAdjointEigenSolver<MatX>(model.curvature(x, n), gram, Eigen::EigenvaluesOnly).eigenvalues();
  const VecX points = model.value(x) - n * (-creep / shares[0]);
  SmoothFunctions misfit = model;
  misfit.value = [f = model.value, points](const VecX& p) -> VecX { return f(p) - points; };
  VecX start = x;
  start.array() += VecX::LinSpaced(4, 0.1, -0.1).array();
  return {"exponential fit", AnalyticProblem(misfit, start, VecX::Constant(4, -5), VecX::Constant(4, 5)), x};
}

/// x_0^2 + x_1 and x_1 + x_2 wanted at 1 with three parameters: J has rank 2 everywhere, and a third row that repeats. Bounds
/// pick the solution: x_0 is largest.
inline AnalyticCase rank_deficient() {
  const SmoothFunctions r{[](const VecX& x) -> VecX {
                            const double a = x[0] * x[0] + x[1] - 1, b = x[1] + x[2] - 1;
                            return Vec3(a, b, a + b);
                          },
                          [](const VecX& x) {
                            MatX j(3, 3);
                            j << 2 * x[0], 1, 0, 0, 1, 1, 2 * x[0], 2, 1;
                            return j;
                          },
                          [](const VecX&, const VecX& w) {
                            MatX c = MatX::Zero(3, 3);
                            c(0, 0) = 2 * (w[0] + w[2]);
                            return c;
                          }};
  return {"rank-deficient", AnalyticProblem(r, Vec3(0.5, 0.1, 0.2), VecX::Constant(3, -3), VecX::Constant(3, 3)), {}};
}

/// y^2 - 1 and 0.75 (y - 1) of turned parameters y: h has negative curvature around the start in most directions, which J'J
/// does not know, and no stationary point but y = 1, as y (y + 1) + 0.75^2 / 2 has no root.
inline constexpr int kTurned = 8;
inline AnalyticCase indefinite() {
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  const MatX q =
      Eigen::HouseholderQR<MatX>(MatX::NullaryExpr(kTurned, kTurned, [&] { return normal(random); })).householderQ();
  const SmoothFunctions r{
      [q](const VecX& x) -> VecX {
        const VecX y = q * x;
        VecX v(2 * kTurned);
        v.head(kTurned) = y.array().square() - 1;
        v.tail(kTurned) = 0.75 * (y.array() - 1);
        return v;
      },
      [q](const VecX& x) {
        MatX j(2 * kTurned, kTurned);
        j.topRows(kTurned) = 2 * (q * x).asDiagonal() * q;
        j.bottomRows(kTurned) = 0.75 * q;
        return j;
      },
      [q](const VecX&, const VecX& w) -> MatX { return 2 * q.transpose() * w.head(kTurned).asDiagonal() * q; }};
  VecX y(kTurned);
  for (int i = 0; i < kTurned; ++i) y[i] = 0.02 * (i + 1);
  return {"indefinite", AnalyticProblem(r, q.transpose() * y, VecX::Constant(kTurned, -4), VecX::Constant(kTurned, 4)),
          q.transpose() * VecX::Ones(kTurned)};
}

/// The bounded valley with attempts that fail: far from the point no equilibrium, below the valley another branch.
inline AnalyticCase failing() {
  AnalyticCase c = rosenbrock_bounded();
  c.name = "failing attempts";
  c.problem.fate = [](const VecX& from, const VecX& x) {
    if ((x - from).norm() > 0.3) return Outcome::kUnsettled;
    return x[1] < x[0] * x[0] - 0.4 ? Outcome::kJumped : Outcome::kSettled;
  };
  return c;
}

}  // namespace lissom
