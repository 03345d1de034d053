/// Quadratic models whose curvatures span many decades, in boxes most of whose sides are met: what the sheets of table 5.1 ask of
/// the solvers of subproblems.

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "lissom/design/box_cg.h"
#include "lissom/design/box_interior.h"
#include "lissom/design/box_qp.h"

namespace lissom {
namespace {

struct Crowd {
  MatX b;
  VecX g, lower, upper;

  double value(const VecX& x) const { return x.dot(0.5 * (b * x) + g); }
};

/// Eigenvalues from 1 down to 10^-decades; a third of the parameters begins at a bound.
Crowd crowd(int m, double decades, double width, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto any = [&] { return normal(random); };
  const MatX q = Eigen::HouseholderQR<MatX>(MatX::NullaryExpr(m, m, any)).householderQ();
  const VecX eigenvalues = VecX::LinSpaced(m, 0, -decades).unaryExpr([](double e) { return std::pow(10.0, e); });
  Crowd c{q * eigenvalues.asDiagonal() * q.transpose(), {}, {}, {}};
  c.b = 0.5 * (c.b + MatX(c.b.transpose()));
  c.g = c.b * VecX::NullaryExpr(m, any);
  c.lower = VecX::Constant(m, -width);
  c.upper = VecX::Constant(m, width);
  for (int i = 0; i < m; i += 3) (i % 2 == 0 ? c.lower : c.upper)[i] = 0;
  return c;
}

TEST(BoxCrowded, IsSolvedToTheEnd) {
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    const Crowd c = crowd(120, 9, 0.3, seed);
    const BoxQpSolution s = solve_box_qp(c.b, c.g, c.lower, c.upper);
    EXPECT_TRUE(s.converged);
    EXPECT_LT(s.factorizations, 80);
    EXPECT_LE(s.projected_gradient, 1e-10 * c.g.cwiseAbs().maxCoeff());
    EXPECT_TRUE(((s.x - c.lower).array() >= 0).all() && ((c.upper - s.x).array() >= 0).all());
    EXPECT_GT(std::count(s.at_bound.begin(), s.at_bound.end(), true), 20);
    const VecX gradient = c.b * s.x + c.g;
    for (int i = 0; i < 120; ++i) {
      if (!s.at_bound[static_cast<std::size_t>(i)]) continue;
      EXPECT_TRUE(s.x[i] == c.lower[i] ? gradient[i] >= 0 : s.x[i] == c.upper[i] && gradient[i] <= 0) << i;
    }
  }
}

TEST(BoxCrowded, InteriorPointsComeNear) {
  for (const unsigned seed : {1u, 2u}) {
    Crowd c = crowd(60, 6, 0.5, seed);
    c.upper[7] = c.lower[7];                               // equal
    c.upper[8] = std::numeric_limits<double>::infinity();  // none
    const BoxInterior s = solve_box_interior(c.b, 0, c.g, c.lower, c.upper);
    const BoxQpSolution exact = solve_box_qp(c.b, c.g, c.lower, c.upper);
    EXPECT_LT(c.value(s.x) - c.value(exact.x), 1e-6 * std::abs(c.value(exact.x)));
    EXPECT_LT(s.factorizations, 40);
    EXPECT_EQ(s.x[7], c.lower[7]);
    EXPECT_GE(s.push_lower.minCoeff(), 0);
    EXPECT_EQ(s.push_upper[8], 0);
  }
}

/// However few products there are: where the gradient leaves something to be gained, some of it is gained.
TEST(BoxCrowded, ConjugateGradientsAlwaysGain) {
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
    const Crowd c = crowd(120, 7, 0.05, seed);
    const auto times = [&c](const VecX& v) -> VecX { return c.b * v; };
    const double best = -c.value(solve_box_qp(c.b, c.g, c.lower, c.upper).x);
    double before = 0;
    for (const int products : {3, 10, 40, 200, 4000}) {
      const BoxCgSolution s = solve_box_cg(times, c.g, c.lower, c.upper, {}, 1e-12, products);
      EXPECT_NEAR(s.decrease, -c.value(s.x), 1e-9 * best);
      EXPECT_GT(s.decrease, 0) << products;
      EXPECT_GE(s.decrease, 0.99 * before) << products;
      EXPECT_LE(s.decrease, best * (1 + 1e-9));
      before = s.decrease;
    }
    EXPECT_GT(before, 0.98 * best);
  }
}

}  // namespace
}  // namespace lissom
