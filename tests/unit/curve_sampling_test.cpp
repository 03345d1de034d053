#include "lissom/geometry/curve_sampling.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "lissom/geometry/point_grid.h"

namespace lissom {
namespace {

constexpr double kPi = std::numbers::pi;
using Points = std::vector<Vec3>;

TEST(Polyline, EdgesGoToThePiecesByLengthAndPointsAreNodes) {
  const Points points{{0, 0, 0}, {1, 0, 0}, {1, 3, 0}};
  const CurveSamples s = sample_polyline(points, false, 8, "c").value();
  ASSERT_EQ(s.points.size(), 9u);
  EXPECT_EQ(s.points[2], points[1]);  // 2 edges on the piece of length 1, 6 on that of length 3
  EXPECT_EQ(s.points[8], points[2]);
  EXPECT_NEAR((s.points[4] - s.points[3]).norm(), 0.5, 1e-15);
  EXPECT_TRUE(s.tangents.empty());
  EXPECT_EQ(sample_polyline(points, false, 2, "c").value().points, points);
  EXPECT_EQ(sample_polyline(points, false, 1, "c").error().code, ErrorCode::kGeometry);
}

TEST(Polyline, ClosedOnesDoNotRepeatTheFirstNode) {
  const Points points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const CurveSamples s = sample_polyline(points, true, 8, "c").value();
  EXPECT_EQ(s.points.size(), 8u);
  EXPECT_EQ(s.edges(), 8);
  EXPECT_EQ(s.points[6], points[3]);
  EXPECT_EQ(s.points[7], Vec3(0, 0.5, 0));
  EXPECT_NEAR(measure_polyline(points, true, "c").value().length, 4, 1e-15);
}

TEST(Spline, ReproducesStraightLinesAndParabolas) {
  const CurveSamples line = sample_spline(Points{{0, 0, 0}, {1, 2, 3}}, false, 4, "c").value();
  EXPECT_LT((line.points[1] - Vec3(0.25, 0.5, 0.75)).norm(), 1e-15);
  // Three points: exact for quadratic data.
  const CurveSamples parabola = sample_spline(Points{{0, 0, 0}, {1, 1, 0}, {2, 4, 0}}, false, 10, "c").value();
  for (const Vec3& p : parabola.points) EXPECT_NEAR(p.y(), p.x() * p.x(), 1e-14);
  EXPECT_LT((parabola.tangents[0] - Vec3::UnitX()).norm(), 1e-14);
  EXPECT_LT((parabola.tangents[10] - Vec3(1, 4, 0).normalized()).norm(), 1e-14);
  EXPECT_EQ(parabola.points[5], Vec3(1, 1, 0));
  EXPECT_EQ(parabola.points[10], Vec3(2, 4, 0));
  // Length of y = x^2 on [0, 2].
  const double exact = 2 * std::sqrt(17.0) / 2 + std::asinh(4.0) / 4;
  EXPECT_NEAR(measure_spline(Points{{0, 0, 0}, {1, 1, 0}, {2, 4, 0}}, false, "c").value().length, exact, 1e-6);
}

TEST(Spline, ClosedOnesArePeriodic) {
  Points square{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  const CurveSamples s = sample_spline(square, true, 16, "c").value();
  ASSERT_EQ(s.points.size(), 16u);
  for (size_t i = 0; i < 16; ++i) {
    const Vec3& p = s.points[i];
    EXPECT_LT((s.points[(i + 4) % 16] - Vec3(-p.y(), p.x(), 0)).norm(), 1e-15);
  }
  EXPECT_LT((s.tangents[0] - Vec3::UnitY()).norm(), 1e-15);
}

TEST(Turn, HelixHasItsPitchLengthAndTangent) {
  const TurnedPoint coil{Vec3(0, 0, 5), Vec3(0.01, 0, 5), Vec3(0, 0, 2), 10 * kPi, 0.02, false};
  const CurveSamples s = sample_turn(coil, 300, "c").value();
  EXPECT_LT((s.points[60] - Vec3(0.01, 0, 5.004)).norm(), 1e-15);
  EXPECT_NEAR(measure_turn(coil, "c").value().length, std::hypot(0.1 * kPi, 0.02), 1e-14);
  EXPECT_NEAR(s.tangents[0].z(), 0.004 / std::hypot(0.02 * kPi, 0.004), 1e-14);
  EXPECT_GT(s.tangents[0].y(), 0);
  const TurnedPoint left{Vec3::Zero(), Vec3(0.01, 0, 0), Vec3::UnitZ(), -2 * kPi, 0.004, false};
  EXPECT_LT(sample_turn(left, 40, "c").value().tangents[0].y(), 0);
}

TEST(Turn, ArcAboutAnObliqueAxisKeepsItsRadius) {
  const TurnedPoint arc{Vec3(1, 2, 3), Vec3(2, 2, 4), Vec3(1, 1, 1), kPi / 3, 0, false};
  const CurveSamples s = sample_turn(arc, 12, "c").value();
  const Vec3 axis = arc.axis.normalized();
  for (size_t i = 0; i < s.points.size(); ++i) {
    const Vec3 arm = s.points[i] - arc.centre, out = arm - axis * axis.dot(arm);
    EXPECT_NEAR(out.norm(), (Vec3(1, 0, 1) - axis * axis.dot(Vec3(1, 0, 1))).norm(), 1e-14);
    EXPECT_NEAR(s.tangents[i].dot(out), 0, 1e-14);
  }
  EXPECT_NEAR(measure_turn(arc, "c").value().turning, kPi / 3, 1e-14);
}

TEST(CurveSampling, ImpossibleCurvesAreRefusedWithTheirPlace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Vec3 o = Vec3::Zero(), x = Vec3::UnitX(), z = Vec3::UnitZ();
  const auto expect_refused = [](const auto& result, ErrorCode code) {
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, code) << result.error().text();
    EXPECT_EQ(result.error().where, "c");
    EXPECT_FALSE(result.error().hint.empty());
  };
  expect_refused(sample_polyline(Points{o}, false, 3, "c"), ErrorCode::kGeometry);
  expect_refused(sample_polyline(Points{}, false, 3, "c"), ErrorCode::kGeometry);
  expect_refused(sample_polyline(Points{o, x}, true, 3, "c"), ErrorCode::kGeometry);
  expect_refused(sample_polyline(Points{o, o}, false, 3, "c"), ErrorCode::kGeometry);
  expect_refused(sample_polyline(Points{o, x, x, z}, false, 9, "c"), ErrorCode::kGeometry);
  expect_refused(sample_polyline(Points{o, x, z, o}, true, 9, "c"), ErrorCode::kGeometry);
  expect_refused(sample_polyline(Points{o, Vec3(nan, 0, 0)}, false, 3, "c"), ErrorCode::kRange);
  expect_refused(sample_spline(Points{o, x, x}, false, 3, "c"), ErrorCode::kGeometry);
  expect_refused(sample_spline(Points{o, x, z}, true, 2, "c"), ErrorCode::kGeometry);
  expect_refused(sample_turn({o, x, o, 1, 0, false}, 3, "c"), ErrorCode::kGeometry);
  expect_refused(sample_turn({o, z, z, 1, 0, false}, 3, "c"), ErrorCode::kGeometry);
  expect_refused(sample_turn({o, x, z, 0, 0, false}, 3, "c"), ErrorCode::kGeometry);
  expect_refused(sample_turn({o, x, z, nan, 0, false}, 3, "c"), ErrorCode::kRange);
  expect_refused(sample_turn({o, x, z, 1, 0, true}, 3, "c"), ErrorCode::kConflict);
  expect_refused(sample_turn({o, x, z, 2 * kPi, 0, true}, 2, "c"), ErrorCode::kGeometry);
}

TEST(PointGrid, FindsTheFirstPointWithinTheDistanceAcrossCells) {
  PointGrid grid(0.01, 0.1, 1000);
  int merged = 0;
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(grid.insert(Vec3(0.1 * (i % 10), 0.1 * (i / 10 % 10), 0.1 * (i / 100))), i);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = grid.points()[static_cast<size_t>(i)] + 0.0099 * Vec3(std::cos(i), std::sin(i), 0);
    merged += grid.insert(p) == i;
  }
  EXPECT_EQ(merged, 1000);
  EXPECT_EQ(grid.insert(Vec3(0.0101, 0, 0)), 1000);
}

}  // namespace
}  // namespace lissom
