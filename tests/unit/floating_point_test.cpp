/// The promises of docs/decisions/0001-house.md that compiler flags can break without a word.

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "lissom/core/types.h"

namespace lissom {
namespace {

/// Keeps the compiler from computing at compile time.
double opaque(double x) {
  volatile double y = x;
  return y;
}

TEST(FloatingPoint, ProductsAreRoundedBeforeTheyAreSubtracted) {
  // A fused a*b - c*d leaves the rounding error of one product, and a straight rod would have curvature.
  for (int i = 1; i <= 100; ++i) {
    const Vec3 a(opaque(1.0 / i), opaque(0.1 * i), opaque(std::sqrt(2.0 * i)));
    const Vec3 b = a;
    const double x = a.x() * b.y() - a.y() * b.x();
    const double y = a.y() * b.z() - a.z() * b.y();
    EXPECT_EQ(x, 0.0) << i;
    EXPECT_EQ(y, 0.0) << i;
    EXPECT_EQ(a.cross(b).norm(), 0.0) << i;
  }
}

TEST(FloatingPoint, SumsKeepTheirOrder) {
  const double big = opaque(1e16), one = opaque(1.0);
  EXPECT_EQ((big + one) - big, 0.0);
  EXPECT_EQ((big - big) + one, 1.0);
}

TEST(FloatingPoint, NanAndInfinityAreSeen) {
  const double zero = opaque(0.0);
  EXPECT_TRUE(std::isnan(zero / zero));
  EXPECT_TRUE(std::isinf(1 / zero));
  EXPECT_FALSE(VecX::Constant(3, zero / zero).allFinite());
}

TEST(FloatingPoint, SmallNumbersAreNotFlushedToZero) {
  const double tiny = opaque(std::numeric_limits<double>::min());
  EXPECT_GT(tiny / 4, 0.0);
}

TEST(Layout, DoesNotDependOnTheInstructionSet) {
  EXPECT_EQ(EIGEN_DEFAULT_ALIGN_BYTES, 64);
  EXPECT_EQ(EIGEN_MAX_STATIC_ALIGN_BYTES, 16);
  EXPECT_EQ(alignof(Eigen::Vector4d), 16u);
  EXPECT_EQ(alignof(Eigen::Matrix4d), 16u);
  EXPECT_EQ(sizeof(Vec3), 3 * sizeof(double));
  EXPECT_EQ(sizeof(Mat3), 9 * sizeof(double));
}

}  // namespace
}  // namespace lissom
