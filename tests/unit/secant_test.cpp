#include "lissom/design/secant.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>

#include "lissom/design/box_qp.h"

namespace lissom {
namespace {

/// Per parameter, after a turn, the residuals x + 1 and c x^2 + x - 1 [after Dennis & Schnabel 1983]: at the minimum x = 0 they
/// are 1 and -1, S'S = 2 and the whole second derivative 2 - 2 c, so that Gauss-Newton converges with the factor c.
struct Misfit {
  Vec3 bend{0.9, 0.5, -0.8};
  Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 2) / 3).toRotationMatrix();

  VecX residual(const VecX& p) const {
    const Vec3 x = turn * p;
    VecX r(6);
    for (int i = 0; i < 3; ++i) {
      r[2 * i] = x[i] + 1;
      r[2 * i + 1] = bend[i] * x[i] * x[i] + x[i] - 1;
    }
    return r;
  }
  MatX jacobian(const VecX& p) const {
    const Vec3 x = turn * p;
    MatX s(6, 3);
    for (int i = 0; i < 3; ++i) {
      s.row(2 * i) = turn.row(i);
      s.row(2 * i + 1) = (2 * bend[i] * x[i] + 1) * turn.row(i);
    }
    return s;
  }
};

SecantStep step_between(const Misfit& f, const VecX& from, const VecX& to) {
  const MatX before = f.jacobian(from), now = f.jacobian(to);
  const VecX r = f.residual(to);
  return {to - from, now.transpose() * r - before.transpose() * f.residual(from), (now - before).transpose() * r,
          now.transpose() * now};
}

/// Steps of the quadratic model with halving until the gradient has fallen to a millionth; their number.
int descend(SecantRule rule, VecX& p) {
  const Misfit f;
  SecantHessian hessian(rule, 3);
  const double first = (f.jacobian(p).transpose() * f.residual(p)).norm();
  for (int k = 0; k < 2000; ++k) {
    const MatX s = f.jacobian(p);
    const VecX r = f.residual(p), g = s.transpose() * r;
    if (g.norm() < 1e-6 * first) return k;
    const VecX bound = VecX::Constant(3, 1.0);
    const VecX d = solve_box_qp(hessian.at(s.transpose() * s), g, -bound, bound).x;
    double a = 1;
    while (a > 1e-10 && !(f.residual(p + a * d).squaredNorm() <= r.squaredNorm() + 2e-4 * a * g.dot(d))) a *= 0.5;
    const VecX next = p + a * d;
    hessian.learn(step_between(f, p, next));
    p = next;
  }
  return 2000;
}

TEST(Secant, RulesMeetTheirSecantEquations) {
  const Misfit f;
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, 0.1);
  for (const SecantInfo& info : secant_rules()) {
    SecantHessian hessian(info.rule, 3);
    VecX p = Vec3(0.2, 0.1, -0.1);
    int checked = 0;
    for (int k = 0; k < 12; ++k) {
      VecX next = p;
      for (int i = 0; i < 3; ++i) next[i] += normal(random);
      const SecantStep s = step_between(f, p, next);
      const int resets = hessian.resets();
      hessian.learn(s);
      p = next;
      if (hessian.resets() > resets) continue;
      const MatX b = hessian.at(s.gram);
      EXPECT_LT((b - b.transpose()).norm(), 1e-10 * b.norm()) << info.name;
      const VecX seen = info.rule == SecantRule::kGaussNewton ? s.gram * s.step
                        : info.rule == SecantRule::kBfgs      ? s.gradient_change
                                                              : VecX(s.gram * s.step + s.structured_change);
      EXPECT_LT((b * s.step - seen).norm(), 1e-9 * seen.norm()) << info.name << ' ' << k;
      if (info.rule != SecantRule::kDennisGayWelsch && info.rule != SecantRule::kGaussNewton) {
        EXPECT_EQ(Eigen::LLT<MatX>(b).info(), Eigen::Success) << info.name << ' ' << k;
      }
      ++checked;
    }
    EXPECT_GE(checked, 3) << info.name;
  }
}

/// Gauss-Newton converges only linearly where residuals stay large; secants do not.
TEST(Secant, LargeResidualsNeedTheSecondPart) {
  std::map<SecantRule, int> steps;
  std::map<SecantRule, double> least;
  for (const SecantInfo& info : secant_rules()) {
    VecX p = Vec3(0.4, 0.3, -0.2);
    steps[info.rule] = descend(info.rule, p);
    least[info.rule] = Misfit().residual(p).squaredNorm();
    EXPECT_LT(steps[info.rule], 2000) << info.name;
  }
  for (const auto& [rule, value] : least) EXPECT_NEAR(value, 6, 1e-8);
  EXPECT_GT(steps[SecantRule::kGaussNewton], 80);
  for (const SecantRule rule : {SecantRule::kBfgs, SecantRule::kStructuredBfgs, SecantRule::kDennisGayWelsch}) {
    EXPECT_LT(steps[rule], 30);
  }
}

TEST(Secant, StepsThatTellNothingAreForgotten) {
  const MatX gram = MatX::Identity(2, 2);
  for (const SecantRule rule : {SecantRule::kBfgs, SecantRule::kStructuredBfgs}) {
    SecantHessian hessian(rule, 2);
    hessian.learn({Vec2(1, 0), Vec2(-1, 0), Vec2(-2, 0), gram});  // negative curvature along the step
    EXPECT_EQ(hessian.resets(), 1);
    EXPECT_EQ(hessian.at(gram), gram);
  }
  SecantHessian hessian(SecantRule::kDennisGayWelsch, 2);
  hessian.learn({Vec2(1, 0), Vec2(std::nan(""), 0), Vec2(0, 0), gram});
  EXPECT_EQ(hessian.resets(), 1);
}

}  // namespace
}  // namespace lissom
