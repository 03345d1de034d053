/// Least squares over a box with residuals that count on one side only.

#include "lissom/design/one_sided_cg.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace lissom {
namespace {

struct Case {
  MatX j;
  VecX r;
  OneSided sided;
  VecX lower, upper;

  /// Half the sum of squares.
  double value(const VecX& x) const {
    return 0.5 * (r + j * x).squaredNorm() + 0.5 * (sided.value + sided.rows * x).cwiseMax(0).squaredNorm();
  }
  VecX gradient(const VecX& x) const {
    return j.transpose() * (r + j * x) + sided.rows.transpose() * (sided.value + sided.rows * x).cwiseMax(0);
  }
  /// What no bound holds.
  double left(const VecX& x) const {
    const VecX g = gradient(x);
    double most = 0;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const bool held = (x[i] <= lower[i] && g[i] > 0) || (x[i] >= upper[i] && g[i] < 0);
      if (!held) most = std::max(most, std::abs(g[i]));
    }
    return most;
  }
  BoxCgSolution solved() const {
    const VecX on = sided.value.unaryExpr([](double v) { return v > 0 ? 1.0 : 0.0; });
    const SparseMatrix& a = sided.rows;
    const auto times = [&](const VecX& v) -> VecX {
      return j.transpose() * (j * v) + a.transpose() * on.cwiseProduct(a * v);
    };
    return solve_one_sided_cg(times, gradient(VecX::Zero(j.cols())), sided, lower, upper, 1e-9, 2000);
  }
};

Case random_case(unsigned seed) {
  constexpr int m = 8, residuals = 20, sides = 30;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto draw = [&](int rows, int columns) {
    return MatX::NullaryExpr(rows, columns, [&] { return normal(random); });
  };
  Case made;
  made.j = draw(residuals, m);
  made.r = 3 * draw(residuals, 1);
  made.sided.rows = MatX(2 * draw(sides, m)).sparseView();
  made.sided.value = draw(sides, 1);
  made.lower = VecX::Constant(m, -0.4);
  made.upper = VecX::Constant(m, 0.3);
  return made;
}

TEST(OneSidedCg, FindsTheMinimumOfTheWhole) {
  int begun_to_count = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const Case one = random_case(seed);
    const BoxCgSolution found = one.solved();
    EXPECT_LE((found.x - one.upper).maxCoeff(), 0);
    EXPECT_GE((found.x - one.lower).minCoeff(), 0);
    EXPECT_LT(one.left(found.x), 1e-7) << "seed " << seed;
    const VecX start = VecX::Zero(found.x.size());
    EXPECT_NEAR(found.decrease, one.value(start) - one.value(found.x), 1e-9 * one.value(start)) << "seed " << seed;
    const VecX there = one.sided.value + one.sided.rows * found.x;
    for (Eigen::Index i = 0; i < there.size(); ++i) begun_to_count += one.sided.value[i] <= 0 && there[i] > 0;
  }
  EXPECT_GT(begun_to_count, 20);
}

/// One parameter: (x - 2)^2 / 2, from x = 1 on 9 (x - 1)^2 / 2 as well: the minimum is at 1.1.
TEST(OneSidedCg, SeesWhatAStepBringsToCount) {
  Case one;
  one.j = MatX::Ones(1, 1);
  one.r = VecX::Constant(1, -2);
  one.sided.rows = MatX(MatX::Constant(1, 1, 3)).sparseView();
  one.sided.value = VecX::Constant(1, -3);
  one.lower = VecX::Constant(1, -10);
  one.upper = VecX::Constant(1, 10);
  const BoxCgSolution found = one.solved();
  EXPECT_NEAR(found.x[0], 1.1, 1e-9);
  EXPECT_NEAR(found.decrease, 2 - (0.5 * 0.9 * 0.9 + 0.5 * 0.3 * 0.3), 1e-9);
}

}  // namespace
}  // namespace lissom
