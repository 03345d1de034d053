#include "lissom/design/box_qp.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace lissom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Problem {
  MatX b;
  VecX g, lower, upper;

  double value(const VecX& x) const { return 0.5 * x.dot(b * x) + g.dot(x); }
};

Problem random_problem(int m, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto any = [&] { return normal(random); };
  const MatX a = MatX::NullaryExpr(m, m, any);
  Problem p{a.transpose() * a + 1e-3 * MatX::Identity(m, m), VecX::NullaryExpr(m, any), {}, {}};
  p.lower = -VecX::NullaryExpr(m, any).cwiseAbs();
  p.upper = VecX::NullaryExpr(m, any).cwiseAbs();
  return p;
}

/// Every choice of bounds, solved in what is left: the least value that lies in the box.
VecX exhaustive(const Problem& p) {
  const int m = static_cast<int>(p.g.size());
  int choices = 1;
  for (int i = 0; i < m; ++i) choices *= 3;
  VecX best = p.lower;
  double least = kInfinity;
  for (int choice = 0; choice < choices; ++choice) {
    VecX x(m);
    std::vector<int> free;
    for (int i = 0, c = choice; i < m; ++i, c /= 3) {
      if (c % 3 == 0) free.push_back(i);
      x[i] = c % 3 == 1 ? p.lower[i] : p.upper[i];
    }
    if (!free.empty()) {
      for (const int i : free) x[i] = 0;
      const VecX fixed = p.b * x + p.g;
      MatX part(free.size(), free.size());
      VecX right(free.size());
      for (std::size_t i = 0; i < free.size(); ++i) {
        right[static_cast<int>(i)] = -fixed[free[i]];
        for (std::size_t j = 0; j < free.size(); ++j)
          part(static_cast<int>(i), static_cast<int>(j)) = p.b(free[i], free[j]);
      }
      const VecX y = part.llt().solve(right);
      for (std::size_t i = 0; i < free.size(); ++i) x[free[i]] = y[static_cast<int>(i)];
    }
    if ((x - p.lower).minCoeff() < -1e-12 || (p.upper - x).minCoeff() < -1e-12) continue;
    if (p.value(x) < least) {
      least = p.value(x);
      best = x;
    }
  }
  return best;
}

TEST(BoxQp, FindsWhatAnExhaustiveSearchFinds) {
  std::mt19937 random(1);
  int held = 0;
  for (int k = 0; k < 200; ++k) {
    const Problem p = random_problem(1 + k % 6, random);
    const BoxQpSolution s = solve_box_qp(p.b, p.g, p.lower, p.upper);
    ASSERT_TRUE(s.converged) << k;
    EXPECT_EQ(s.damping, 0);
    EXPECT_LT((s.x - exhaustive(p)).cwiseAbs().maxCoeff(), 1e-7) << k;
    for (const bool at : s.at_bound) held += at;
  }
  EXPECT_GT(held, 100);
}

TEST(BoxQp, WithoutBoundsIsNewton) {
  std::mt19937 random(2);
  Problem p = random_problem(40, random);
  p.lower.setConstant(-kInfinity);
  p.upper.setConstant(kInfinity);
  const BoxQpSolution s = solve_box_qp(p.b, p.g, p.lower, p.upper);
  EXPECT_TRUE(s.converged);
  EXPECT_EQ(s.iterations, 1);
  EXPECT_LT((p.b * s.x + p.g).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(BoxQp, LargeProblemsMeetTheConditionsOfOptimality) {
  std::mt19937 random(3);
  const Problem p = random_problem(300, random);
  const BoxQpSolution s = solve_box_qp(p.b, p.g, p.lower, p.upper);
  ASSERT_TRUE(s.converged);
  EXPECT_LT(s.iterations, 60);
  const VecX gradient = p.b * s.x + p.g;
  for (int i = 0; i < 300; ++i) {
    if (s.x[i] > p.lower[i] && s.x[i] < p.upper[i]) EXPECT_LT(std::abs(gradient[i]), 1e-8) << i;
    if (s.x[i] <= p.lower[i]) EXPECT_GE(gradient[i], -1e-8) << i;
    if (s.x[i] >= p.upper[i]) EXPECT_LE(gradient[i], 1e-8) << i;
  }
}

TEST(BoxQp, EqualBoundsHold) {
  const MatX b = MatX::Identity(2, 2);
  const VecX g = Vec2(-1, -1), lower = Vec2(0.25, -1), upper = Vec2(0.25, 0.5);
  const BoxQpSolution s = solve_box_qp(b, g, lower, upper);
  EXPECT_TRUE(s.converged);
  EXPECT_EQ(s.x, VecX(Vec2(0.25, 0.5)));
}

TEST(BoxQp, SaysHowMuchCurvatureWasMissing) {
  MatX b = MatX::Identity(2, 2);
  b(1, 1) = -1;
  const VecX g = Vec2(-1, -0.1), lower = Vec2(-2, -2), upper = Vec2(2, 2);
  const BoxQpSolution s = solve_box_qp(b, g, lower, upper);
  EXPECT_TRUE(s.converged);
  EXPECT_GE(s.damping, 1);
  EXPECT_GT(s.x[1], 0);
  EXPECT_LE(s.x.cwiseAbs().maxCoeff(), 2);
}

}  // namespace
}  // namespace lissom
