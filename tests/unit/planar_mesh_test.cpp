#include "lissom/geometry/planar_mesh.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <random>

#include "lissom/geometry/b_spline.h"
#include "lissom/geometry/planar_smoothing.h"
#include "lissom/geometry/segment_pairs.h"

namespace lissom {
namespace {

constexpr double kPi = std::numbers::pi;

/// A ring of n points.
void add_ring(PlanarRegion& region, const Vec2& centre, double radius, int n, bool outline) {
  const int first = static_cast<int>(region.points.size());
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * kPi * i / n;
    region.points.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
    if (outline) region.outline.push_back(static_cast<int>(region.segments.size()));
    region.segments.push_back({first + i, first + (i + 1) % n});
  }
}

/// A disc of 1 m with a spoke of its own points.
PlanarRegion disc(int n) {
  PlanarRegion region;
  add_ring(region, Vec2::Zero(), 1, n, true);
  const int spoke = static_cast<int>(region.points.size());
  const int count = n / 6;
  for (int i = 0; i < count; ++i) {
    region.points.emplace_back(-0.8 + 1.2 * i / (count - 1), 0.1);
    if (i > 0) region.segments.push_back({spoke + i - 1, spoke + i});
  }
  region.edge_length = 2 * kPi / n;
  return region;
}

TEST(PlanarMesh, AngleLengthAndAreaAreAsAsked) {
  for (const double coarse : {1.0, 2.0, 5.0}) {
    PlanarRegion region = disc(120);
    region.edge_length *= coarse;
    const Result<PlanarMesh> made = mesh_planar_region(region, "here");
    ASSERT_TRUE(made) << made.error().text();
    const PlanarMesh& mesh = made.value();
    EXPECT_GE(mesh.smallest_angle, region.min_angle);
    for (size_t i = 0; i < region.points.size(); ++i) EXPECT_EQ(mesh.points[i], region.points[i]);
    double area = 0, length = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec2 u = mesh.points[static_cast<size_t>(b)] - mesh.points[static_cast<size_t>(a)],
                 v = mesh.points[static_cast<size_t>(c)] - mesh.points[static_cast<size_t>(a)];
      area += (u.x() * v.y() - u.y() * v.x()) / 2;
      length += (u.norm() + v.norm() + (u - v).norm()) / (3 * double(mesh.triangles.size()));
    }
    EXPECT_NEAR(area, 60 * std::sin(2 * kPi / 120), 1e-12);
    EXPECT_LT(length, 1.1 * region.edge_length);
    if (coarse == 1) EXPECT_GT(length, 0.9 * region.edge_length);
  }
}

TEST(PlanarMesh, SameInputSameMesh) {
  const PlanarMesh first = mesh_planar_region(disc(60), "here").value(),
                   second = mesh_planar_region(disc(60), "here").value();
  EXPECT_EQ(first.triangles, second.triangles);
  ASSERT_EQ(first.points.size(), second.points.size());
  for (size_t i = 0; i < first.points.size(); ++i) EXPECT_EQ(first.points[i], second.points[i]);
}

TEST(PlanarMesh, HolesReachUpToTheSegmentsAroundThem) {
  PlanarRegion region = disc(60);
  add_ring(region, Vec2(0, -0.5), 0.2, 12, false);
  region.holes = {Vec2(0.01, -0.5)};
  const PlanarMesh mesh = mesh_planar_region(region, "here").value();
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec2 middle = (mesh.points[static_cast<size_t>(a)] + mesh.points[static_cast<size_t>(b)] +
                         mesh.points[static_cast<size_t>(c)]) /
                        3;
    EXPECT_GT((middle - Vec2(0, -0.5)).norm(), 0.19);
  }
}

TEST(PlanarMesh, RefusesWhatCannotBeMeshed) {
  const auto spoiled = [](const auto& spoil) {
    PlanarRegion region = disc(60);
    spoil(region);
    const Result<PlanarMesh> mesh = mesh_planar_region(region, "here");
    return mesh ? std::string("meshed") : mesh.error().message;
  };
  EXPECT_EQ(spoiled([](PlanarRegion& r) {
              r.segments.push_back({10, 40});
            }),
            "two segments of the region cross or lie on each other");
  EXPECT_EQ(spoiled([](PlanarRegion& r) { r.points[5] = r.points[4]; }), "points 4 and 5 are at the same place");
  EXPECT_EQ(spoiled([](PlanarRegion& r) { r.outline.pop_back(); }), "the outline encloses nothing");
  EXPECT_EQ(spoiled([](PlanarRegion& r) { r.points[3].x() = std::numeric_limits<double>::quiet_NaN(); }),
            "point 3 is not a finite number");
  EXPECT_EQ(spoiled([](PlanarRegion& r) { r.edge_length = 0; }), "the edge length is 0 m");
  EXPECT_EQ(spoiled([](PlanarRegion& r) { r.edge_length = 1e-6; }), "the region would be cut into 1e+13 triangles");
  EXPECT_EQ(spoiled([](PlanarRegion& r) { r.holes = {Vec2(3, 0)}; }),
            "the hole lies outside of the outline or in another hole");
}

TEST(PlanarMesh, AngleOfATriangle) {
  EXPECT_NEAR(smallest_angle({0, 0}, {1, 0}, {0, 1}), kPi / 4, 1e-15);
  EXPECT_NEAR(smallest_angle({0, 0}, {2, 0}, {2, std::sqrt(12.0)}), kPi / 6, 1e-15);
  EXPECT_LT(smallest_angle({0, 0}, {0, 1}, {1, 0}), 0);
}

/// The signs that tell crossings are rounding where segments lie in line.
TEST(SegmentPairs, SegmentsInLineDoNotCross) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int k = 0; k < 2000; ++k) {
    const Vec2 from(uniform(random), uniform(random)), along(uniform(random), uniform(random));
    const auto at = [&](double s) -> Vec2 { return (1 - s) * from + s * (from + along); };
    EXPECT_NEAR(segment_distance(at(0.1), at(0.3), at(0.55), at(0.8)), 0.25 * along.norm(), 1e-12);
    EXPECT_EQ(segment_distance(at(0.1), at(0.9), at(0.5) + Vec2(1, -2), at(0.5) - Vec2(2, -4)), 0);
  }
}

TEST(SegmentPairs, AgreeWithAllPairs) {
  std::vector<Vec2> points;
  std::vector<std::array<int, 2>> segments;
  unsigned seed = 7;
  const auto random = [&] {
    seed = seed * 1664525u + 1013904223u;
    return double(seed >> 8) / double(1u << 24);
  };
  for (int i = 0; i < 120; ++i) {
    const Vec2 p(random(), random());
    points.push_back(p);
    points.push_back(p + 0.2 * (i % 10 == 0 ? 4 : 1) * Vec2(random() - 0.5, random() - 0.5));
    segments.push_back({2 * i, 2 * i + 1});
  }
  std::vector<std::array<int, 2>> expected;
  for (int i = 0; i < 120; ++i) {
    for (int j = i + 1; j < 120; ++j) {
      const auto at = [&](int k) { return points[static_cast<size_t>(k)]; };
      if (segment_distance(at(2 * i), at(2 * i + 1), at(2 * j), at(2 * j + 1)) <= 0.02) expected.push_back({i, j});
    }
  }
  EXPECT_GT(expected.size(), 50u);
  EXPECT_EQ(near_segments(points, segments, 0.02), expected);
  // Everything in one place, and no distance.
  const std::vector<Vec2> still(4, Vec2(0.3, 0.4));
  const std::vector<std::array<int, 2>> both{{0, 1}, {2, 3}}, one_pair{{0, 1}};
  EXPECT_EQ(near_segments(still, both, 0), one_pair);
}

TEST(BSplines, BecomeTheSameCurve) {
  const std::vector<Vec2> points{{0, 0}, {1, 2}, {3, 1}, {4, -1}, {6, 0}};
  const PlanarPath cubic = bezier_pieces({3, {0, 0, 0, 0, 1, 2, 2, 2, 2}, points, {}});
  ASSERT_EQ(cubic.size(), 2u);
  EXPECT_EQ(cubic[0].kind, PathPiece::Kind::kCubic);
  EXPECT_NEAR((cubic[0].from - points[0]).norm() + (cubic[1].to - points[4]).norm(), 0, 1e-14);
  EXPECT_NEAR((cubic[0].a - points[1]).norm(), 0, 1e-14);
  EXPECT_NEAR((cubic[0].to - (Vec2(2, 1.5) / 2 + Vec2(3.5, 0) / 2)).norm(), 0, 1e-14);  // Boehm's knot insertion
  // A quarter of a circle as a rational quadratic.
  const PlanarPath quarter = bezier_pieces({2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {1, 1}, {0, 1}}, {1, std::sqrt(0.5), 1}});
  ASSERT_EQ(quarter.size(), 8u);
  for (const PathPiece& piece : quarter) EXPECT_NEAR(piece.at(0.5).norm(), 1, 2e-5);  // Hermite pieces of 1/8
  EXPECT_TRUE(bezier_pieces({3, {0, 0, 1}, points, {}}).empty());
}

}  // namespace
}  // namespace lissom
