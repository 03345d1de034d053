/// Paths on surfaces, duals, drawings and patterns, and how short lines are merged.

#include "lissom/geometry/surface_network.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

#include "lissom/geometry/drawn_network.h"
#include "lissom/geometry/dual_network.h"
#include "lissom/geometry/line_patterns.h"
#include "lissom/geometry/surface_locate.h"
#include "lissom/geometry/surface_refine.h"
#include "tests/unit/surface_samples.h"

namespace lissom {
namespace {

std::vector<int> all_triangles(const Surface& surface) {
  std::vector<int> all(surface.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

Surface flat(int cells, double size) {
  Surface sheet = samples::sheet(cells, cells, size);
  for (Vec3& x : sheet.vertices) x[2] = 0;
  return sheet;
}

TEST(ShortestPath, IsStraightInAPlane) {
  const Surface sheet = flat(12, 0.2);
  const SurfacePlace from = nearest_place(sheet, Vec3(0.013, 0.021, 0)), to = nearest_place(sheet, Vec3(0.19, 0.11, 0));
  const std::optional<SurfacePath> path = shortest_path(sheet, all_triangles(sheet), from, to);
  ASSERT_TRUE(path.has_value());
  const Vec3 a = position(sheet, from), b = position(sheet, to);
  EXPECT_NEAR(path_length(sheet, *path), (b - a).norm(), 1e-12);
  const std::vector<SurfacePlace> places = sample_path(sheet, *path, 10);
  ASSERT_EQ(places.size(), 11u);
  for (int k = 0; k <= 10; ++k) {
    EXPECT_LT((position(sheet, places[static_cast<std::size_t>(k)]) - (a + (b - a) * k / 10)).norm(), 1e-12);
  }
}

TEST(ShortestPath, FollowsAGreatCircle) {
  const Surface sphere = samples::icosphere(4, 0.1);
  const SurfacePlace from = nearest_place(sphere, Vec3(0.1, 0, 0)), to = nearest_place(sphere, Vec3(0, 0.06, 0.08));
  const std::optional<SurfacePath> path = shortest_path(sphere, all_triangles(sphere), from, to);
  ASSERT_TRUE(path.has_value());
  EXPECT_NEAR(path_length(sphere, *path), 0.1 * std::numbers::pi / 2, 3e-4);
  const SurfacePath back = reversed(*path);
  EXPECT_DOUBLE_EQ(path_length(sphere, back), path_length(sphere, *path));
  EXPECT_EQ(back.front().triangle, path->back().triangle);
}

TEST(ShortestPath, IsStraightFromAndToBoundariesAndVertices) {
  const Surface sheet = flat(12, 0.2);
  const std::vector<Vec3> ends{{0, 0.07, 0}, {0.2, 0.123, 0}, {0.111, 0, 0},
                               {0, 0, 0},    {0.05, 0.1, 0},  {0.0321, 0.177, 0}};
  for (const Vec3& a : ends) {
    for (const Vec3& b : ends) {
      if (a == b) continue;
      const SurfacePlace from = nearest_place(sheet, a), to = nearest_place(sheet, b);
      const std::optional<SurfacePath> path = shortest_path(sheet, all_triangles(sheet), from, to);
      ASSERT_TRUE(path.has_value());
      EXPECT_NEAR(path_length(sheet, *path), (a - b).norm(), 1e-7);
    }
  }
}

TEST(ShortestPath, NeedsAPatchThatConnects) {
  const Surface sphere = samples::icosphere(2, 0.1);
  const SurfacePlace from{0, Vec3::Constant(1.0 / 3)}, to{100, Vec3::Constant(1.0 / 3)};
  const std::vector<int> patch{0, 100};
  EXPECT_FALSE(shortest_path(sphere, patch, from, to).has_value());
}

TEST(DualNetwork, HasAJointInEveryTriangle) {
  const Surface sphere = samples::icosphere(4, 0.1);
  Result<SurfaceNetwork> dual = dual_network(sphere, {80}, "surface");
  ASSERT_TRUE(dual.ok());
  ASSERT_TRUE(find_paths(sphere, dual.value(), "surface").ok());
  ASSERT_TRUE(check_network(sphere, dual.value(), "surface").ok());
  EXPECT_EQ(dual.value().joints.size(), 80u);
  EXPECT_EQ(dual.value().lines.size(), 120u);
  for (const int valence : dual.value().valences()) EXPECT_EQ(valence, 3);
}

TEST(DualNetwork, EndsAtTheBoundary) {
  const Surface sheet = samples::sheet(24, 24, 0.2);
  Result<SurfaceNetwork> dual = dual_network(sheet, {60}, "surface");
  ASSERT_TRUE(dual.ok());
  ASSERT_TRUE(find_paths(sheet, dual.value(), "surface").ok());
  ASSERT_TRUE(check_network(sheet, dual.value(), "surface").ok());
  const int joints = static_cast<int>(dual.value().joints.size()), lines = static_cast<int>(dual.value().lines.size());
  // One face for every vertex that is left, a disc.
  int inside = 0;
  for (const SurfaceJoint& joint : dual.value().joints) inside += joint.kind == SurfaceJoint::Kind::kInside ? 1 : 0;
  EXPECT_NEAR(inside, 60, 1);
  EXPECT_GT(lines - joints, 20);
}

TEST(DualNetwork, SaysHowFarASurfaceCanBeDecimated) {
  const Result<SurfaceNetwork> few = dual_network(samples::icosphere(2, 0.1), {3}, "surface");
  ASSERT_FALSE(few.ok());
  EXPECT_EQ(few.error().where, "surface/triangles");
}

TEST(DrawnNetwork, JoinsWhatIsDrawn) {
  const Surface sheet = flat(20, 0.2);
  ObjLines cross;
  cross.points = {{0.02, 0.1, 0.01}, {0.06, 0.11, 0}, {0.1, 0.1, 0}, {0.18, 0.1, 0}, {0.1, 0.02, 0}, {0.1, 0.18, 0}};
  cross.segments = {{0, 1}, {1, 2}, {2, 3}, {4, 2}, {2, 5}};
  const Result<SurfaceNetwork> network = drawn_network(sheet, cross, 0.7, "lines");
  ASSERT_TRUE(network.ok());
  ASSERT_EQ(network.value().joints.size(), 5u);
  ASSERT_EQ(network.value().lines.size(), 4u);
  const std::vector<int> valences = network.value().valences();
  EXPECT_EQ(*std::max_element(valences.begin(), valences.end()), 4);
  const double bent = 2 * Vec2(0.04, 0.01).norm();  // 28 degrees are no corner
  EXPECT_NEAR(path_length(sheet, network.value().lines[0].path), bent, 1e-7);
  const Result<SurfaceNetwork> kinked = drawn_network(sheet, cross, 0.3, "lines");
  ASSERT_TRUE(kinked.ok());
  EXPECT_EQ(kinked.value().joints.size(), 6u);
}

TEST(DrawnNetwork, GivesARingThreeJoints) {
  const Surface sheet = flat(20, 0.2);
  ObjLines ring;
  for (int k = 0; k < 12; ++k) {
    const double angle = k * std::numbers::pi / 6;
    ring.points.emplace_back(0.1 + 0.05 * std::cos(angle), 0.1 + 0.05 * std::sin(angle), 0);
    ring.segments.push_back({k, (k + 1) % 12});
  }
  const Result<SurfaceNetwork> network = drawn_network(sheet, ring, 0.7, "lines");
  ASSERT_TRUE(network.ok());
  EXPECT_EQ(network.value().joints.size(), 3u);
  EXPECT_EQ(network.value().lines.size(), 3u);
  EXPECT_FALSE(drawn_network(sheet, {}, 0.7, "lines").ok());
}

TEST(Patterns, FillASheetWithWholeCells) {
  const Surface sheet = flat(20, 0.2);
  const Result<ObjLines> quads = pattern_on_sheet(sheet, PatternCell::kSquare, 0.02, "sheet");
  ASSERT_TRUE(quads.ok());
  // Whole squares only: points, sides and cells of a block of a by b.
  const int points = static_cast<int>(quads.value().points.size()),
            lines = static_cast<int>(quads.value().segments.size());
  EXPECT_GE(lines - points + 1, 81);
  EXPECT_LE(lines - points + 1, 100);
  const Result<ObjLines> hexagons = pattern_on_sheet(sheet, PatternCell::kHexagon, 0.015, "sheet");
  ASSERT_TRUE(hexagons.ok());
  for (const std::array<int, 2>& s : hexagons.value().segments) {
    const auto at = [&](int p) { return hexagons.value().points[static_cast<std::size_t>(p)]; };
    EXPECT_NEAR((at(s[0]) - at(s[1])).norm(), 0.015, 1e-9);
  }
  EXPECT_FALSE(pattern_on_sheet(sheet, PatternCell::kHexagon, 0.3, "sheet").ok());
  EXPECT_FALSE(pattern_on_sheet(samples::icosphere(2, 0.1), PatternCell::kSquare, 0.02, "sheet").ok());
}

TEST(Patterns, HaveTheSizesOfTheThesis) {
  // Table 5.1: 3 x 6 hexagons have 54 joints and 71 rods.
  const ObjLines lines = hexagon_pattern(0.02, 3, 6);
  EXPECT_EQ(lines.points.size(), 54u);
  EXPECT_EQ(lines.segments.size(), 71u);
  EXPECT_EQ(triangle_pattern(0.02, 3, 2).segments.size(), 9u + 14u);
  EXPECT_EQ(square_pattern(0.02, 3, 2).segments.size(), 17u);
}

/// A ladder on a plane whose middle rung is short.
SurfaceNetwork ladder(const Surface& sheet, double gap) {
  ObjLines lines;
  lines.points = {{0.02, 0.1, 0},       {0.1, 0.1, 0},  {0.1, 0.1 + gap, 0},
                  {0.18, 0.1 + gap, 0}, {0.1, 0.02, 0}, {0.1, 0.18, 0}};
  lines.segments = {{0, 1}, {1, 2}, {2, 3}, {4, 1}, {2, 5}};
  return drawn_network(sheet, lines, 2, "lines").value();
}

TEST(ShortLines, AreMergedIntoAJoint) {
  const Surface sheet = flat(20, 0.2);
  SurfaceNetwork network = ladder(sheet, 0.004);
  ASSERT_TRUE(merge_short_lines(sheet, network, {}, "lines").ok());
  EXPECT_EQ(network.lines.size(), 4u);
  EXPECT_EQ(network.joints.size(), 5u);
  EXPECT_EQ(network.notes.size(), 1u);
  ASSERT_TRUE(check_network(sheet, network, "lines").ok());
  const std::vector<int> valences = network.valences();
  const auto middle = std::max_element(valences.begin(), valences.end()) - valences.begin();
  EXPECT_EQ(valences[static_cast<std::size_t>(middle)], 4);
  const Vec3 x = position(sheet, network.joints[static_cast<std::size_t>(middle)].place);
  EXPECT_LT((x - Vec3(0.1, 0.102, 0)).norm(), 1e-7);
}

TEST(ShortLines, StayWhereTooManyWouldMeet) {
  const Surface sheet = flat(20, 0.2);
  SurfaceNetwork network = ladder(sheet, 0.004);
  ASSERT_TRUE(merge_short_lines(sheet, network, {.shortest = 0.25, .valence = 3}, "lines").ok());
  EXPECT_EQ(network.lines.size(), 5u);
  SurfaceNetwork long_one = ladder(sheet, 0.04);
  ASSERT_TRUE(merge_short_lines(sheet, long_one, {}, "lines").ok());
  EXPECT_EQ(long_one.lines.size(), 5u);
  EXPECT_FALSE(merge_short_lines(sheet, long_one, {.shortest = 1.5}, "lines").ok());
}

TEST(Networks, HaveToBeConnected) {
  const Surface sheet = flat(20, 0.2);
  ObjLines apart;
  apart.points = {{0.02, 0.02, 0}, {0.06, 0.02, 0}, {0.1, 0.1, 0}, {0.15, 0.1, 0}};
  apart.segments = {{0, 1}, {2, 3}};
  const SurfaceNetwork network = drawn_network(sheet, apart, 0.7, "lines").value();
  const Status status = check_network(sheet, network, "lines");
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kGeometry);
  EXPECT_FALSE(status.error().hint.empty());
}

}  // namespace
}  // namespace lissom
