#include "lissom/design/bound_map.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace lissom {
namespace {

BoundMap sample() {
  const double inf = std::numeric_limits<double>::infinity();
  return BoundMap(Vec3(1e-3, -2, -inf), Vec3(5e-3, 4, inf));
}

TEST(BoundMap, GoesThereAndBack) {
  const BoundMap map = sample();
  for (const double share : {0.001, 0.2, 0.5, 0.9, 0.999}) {
    const VecX p = Vec3(1e-3 + share * 4e-3, -2 + share * 6, 100 * share);
    EXPECT_LT((map.parameters(map.unbounded(p)) - p).cwiseAbs().maxCoeff(), 1e-12) << share;
  }
}

TEST(BoundMap, NeverLeavesTheBounds) {
  const BoundMap map = sample();
  for (const double u : {-1e9, -1.0, 0.0, 1.0, 1e9}) {
    const VecX p = map.parameters(Vec3(u, u, u));
    EXPECT_GE(p[0], 1e-3);
    EXPECT_LE(p[0], 5e-3);
    EXPECT_GE(p[1], -2);
    EXPECT_LE(p[1], 4);
    EXPECT_EQ(p[2], u);
  }
}

TEST(BoundMap, DerivativesMatchDifferences) {
  const BoundMap map = sample();
  const VecX u = Vec3(0.7e-3, -1.3, 5), scale = Vec3(1e-3, 1, 1);
  const VecX slope = map.slope(u), curvature = map.curvature(u);
  const double h = 1e-4;
  const VecX up = map.parameters(u + h * scale), at = map.parameters(u), down = map.parameters(u - h * scale);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR((up[i] - down[i]) / (2 * h * scale[i]), slope[i], 1e-7) << i;
    EXPECT_NEAR((up[i] - 2 * at[i] + down[i]) / (h * h * scale[i]), curvature[i] * scale[i], 1e-5) << i;
  }
  EXPECT_EQ(map.slope(VecX::Zero(3)), VecX::Ones(3));
}

TEST(BoundMap, KeepsAwayFromTheBounds) {
  const VecX p = sample().inside(Vec3(0, 4, 7));
  EXPECT_NEAR(p[0], 1.004e-3, 1e-15);
  EXPECT_NEAR(p[1], 3.994, 1e-12);
  EXPECT_EQ(p[2], 7);
}

}  // namespace
}  // namespace lissom
