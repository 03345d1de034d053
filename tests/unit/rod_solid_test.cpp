// Solids of rods: closed, outwards, without self-intersections, of the right volume, whatever the rods do.

#include "lissom/fabrication/rod_solid.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

#include "lissom/fabrication/solid_check.h"
#include "scenes/scene_models.h"
#include "tests/unit/rod_nets.h"

namespace lissom {
namespace {

using testing::counted_volume;
using testing::RodNet;

constexpr double kMm = 1e-3;

Section ellipse(double r_b, double r_n) { return {SectionShape::kEllipse, r_n * kMm, r_b * kMm, 0}; }

RodSolid solid_of(const Structure& structure, double tolerance = 1e-4) {
  Result<std::vector<RodSolid>> solids = rod_solids(structure, {tolerance}, {});
  EXPECT_TRUE(solids.ok()) << solids.error().text();
  EXPECT_EQ(solids.value().size(), 1U);
  RodSolid solid = std::move(solids.value().front());
  const SolidCheck check = check_solid(solid.surface, {});
  EXPECT_TRUE(check.ok()) << check.problem;
  EXPECT_EQ(solid.attempts, 1);
  EXPECT_DOUBLE_EQ(check.volume, solid.volume);
  return solid;
}

int euler_number(const Surface& surface) {
  return static_cast<int>(surface.vertices.size()) - static_cast<int>(surface.triangles.size()) / 2;
}

TEST(RodSolid, StraightRodsHaveTheirVolume) {
  constexpr double length = 0.08;
  for (const Section& s : {ellipse(1, 1), ellipse(3, 1), Section{SectionShape::kRectangle, 1 * kMm, 2 * kMm, 0}}) {
    RodNet net;
    net.line({0, 0, 0}, Vec3(2, 1, 0.5).normalized() * length, s);
    const RodSolid solid = solid_of(net.structure);
    const double area = s.shape == SectionShape::kRectangle ? 4 * s.r_b * s.r_n : std::numbers::pi * s.r_b * s.r_n;
    EXPECT_NEAR(solid.volume / (area * length), 1, 1e-9);
    EXPECT_EQ(euler_number(solid.surface), 2);
    EXPECT_EQ(solid.joints, 0);
  }
}

TEST(RodSolid, TaperedRodsHaveTheirVolume) {
  RodNet net;
  std::vector<Vec3> points;
  for (int i = 0; i <= 10; ++i) points.emplace_back(6 * kMm * i, 0, 0);
  net.add(points, ellipse(1, 1), ellipse(5, 3));
  // Of pi (1 + 4 s)(1 + 2 s) over s from 0 to 1.
  const double exact = std::numbers::pi * (1 + 3 + 8.0 / 3) * 60 * kMm * kMm * kMm;
  EXPECT_NEAR(solid_of(net.structure).volume / exact, 1, 2e-3);
}

TEST(RodSolid, RingsWithoutJointsAreClosedTubes) {
  RodNet net;
  std::vector<Vec3> points;
  for (int i = 0; i < 20; ++i) {
    const double angle = 2 * std::numbers::pi * i / 20;
    points.emplace_back(Vec3(std::cos(angle), std::sin(angle), 0) * 20 * kMm);
  }
  net.add(points, ellipse(1.5, 1), ellipse(1.5, 1), true);
  const RodSolid solid = solid_of(net.structure);
  EXPECT_EQ(euler_number(solid.surface), 0);
  EXPECT_NEAR(solid.volume / (std::numbers::pi * 1.5 * 2 * std::numbers::pi * 20 * kMm * kMm * kMm), 1, 5e-3);
}

TEST(RodSolid, TwistedRingsCloseAfterHalfATurn) {
  RodNet net;
  std::vector<Vec3> points;
  for (int i = 0; i < 40; ++i) {
    const double angle = 2 * std::numbers::pi * i / 40;
    points.emplace_back(Vec3(std::cos(angle), std::sin(angle), 0) * 20 * kMm);
  }
  net.add(points, ellipse(2, 1), ellipse(2, 1), true);
  for (int e = 0; e < 40; ++e) {
    Frame& frame = net.structure.edges[e].drawn;
    frame = rotated(rotation_from_vector(frame.t * (std::numbers::pi * (e + 0.5) / 40)), frame);
  }
  const RodSolid solid = solid_of(net.structure);
  EXPECT_EQ(euler_number(solid.surface), 0);
  EXPECT_NEAR(solid.volume / (std::numbers::pi * 2 * 2 * std::numbers::pi * 20 * kMm * kMm * kMm), 1, 1e-2);
}

class Valence : public ::testing::TestWithParam<int> {};

TEST_P(Valence, JointsHaveTheCountedVolume) {
  const int valence = GetParam();
  RodNet net;
  for (int k = 0; k < valence; ++k) {  // a spiral on the sphere; three and fewer in a plane
    const double z = valence < 4 ? 0 : 1 - (2 * k + 1.0) / valence, angle = valence < 4 ? 2.0944 * k : 2.39996 * k;
    const Vec3 d(std::cos(angle) * std::sqrt(1 - z * z), std::sin(angle) * std::sqrt(1 - z * z), z);
    net.line({0, 0, 0}, d * 15 * kMm, ellipse(1.4, 1));
  }
  const RodSolid solid = solid_of(net.structure);
  EXPECT_EQ(solid.parts, 1);
  EXPECT_EQ(euler_number(solid.surface), 2);
  EXPECT_NEAR(solid.volume / counted_volume(net.structure, 0.15 * kMm), 1, 0.02);
}

INSTANTIATE_TEST_SUITE_P(All, Valence, ::testing::Range(1, 9));

TEST(RodSolid, SmallAnglesAreOnePiece) {
  for (const double angle : {0.05, 0.2, 0.5}) {
    RodNet net;
    net.line({0, 0, 0}, {25 * kMm, 0, 0}, ellipse(1.5, 1.5));
    net.line({0, 0, 0}, Vec3(std::cos(angle), std::sin(angle), 0) * 25 * kMm, ellipse(1.5, 1.2));
    net.line({0, 0, 0}, {-25 * kMm, 0, 0}, ellipse(2, 2));
    const RodSolid solid = solid_of(net.structure);
    EXPECT_EQ(solid.parts, 1);
    EXPECT_NEAR(solid.volume / counted_volume(net.structure, 0.15 * kMm), 1, 0.02);
  }
}

TEST(RodSolid, ShortRodsBetweenThickJoints) {
  RodNet net;
  const Vec3 a(0, 0, 0), b(2 * kMm, 0, 0);
  net.line(a, b, ellipse(3, 2));
  for (const double y : {-1.0, 1.0}) {
    net.line(a, Vec3(-12, 15 * y, 0) * kMm, ellipse(3, 2));
    net.line(b, Vec3(14, 15 * y, 3) * kMm, ellipse(4, 2));
  }
  const RodSolid solid = solid_of(net.structure);
  EXPECT_EQ(solid.parts, 1);
  EXPECT_NEAR(solid.volume / counted_volume(net.structure, 0.2 * kMm), 1, 0.02);
}

TEST(RodSolid, RodsThatOverlapWithoutAJointAreUnited) {
  RodNet net;
  net.line({-20 * kMm, 0, 0}, {20 * kMm, 0, 0}, ellipse(1.5, 1.5));
  net.line({0, -20 * kMm, 2 * kMm}, {0, 20 * kMm, 2 * kMm}, ellipse(1.5, 1.5));
  EXPECT_EQ(solid_of(net.structure).parts, 1);
  RodNet apart;
  apart.line({-20 * kMm, 0, 0}, {20 * kMm, 0, 0}, ellipse(1.5, 1.5));
  apart.line({0, -20 * kMm, 3.8 * kMm}, {0, 20 * kMm, 3.8 * kMm}, ellipse(1.5, 1.5));
  EXPECT_EQ(solid_of(apart.structure).parts, 2);
}

TEST(RodSolid, RodsInLineGetNoBulge) {
  RodNet net;
  net.line({0, 0, 0}, {20 * kMm, 0, 0}, ellipse(1.5, 1.5));
  net.line({20 * kMm, 0, 0}, {40 * kMm, 0, 0}, ellipse(1.5, 1.5));
  const RodSolid solid = solid_of(net.structure);
  double widest = 0;
  for (const Vec3& x : solid.surface.vertices) widest = std::max(widest, std::hypot(x.y(), x.z()));
  EXPECT_LT(widest, 1.6 * kMm);
  EXPECT_NEAR(solid.volume / (std::numbers::pi * 2.25 * 40 * kMm * kMm * kMm), 1, 5e-3);
}

TEST(RodSolid, KinksAreRoundJoints) {
  RodNet net;
  net.add({{0, 0, 0}, {20 * kMm, 0, 0}, {20 * kMm, 20 * kMm, 0}, {0, 20 * kMm, 0}}, ellipse(1.5, 1), ellipse(1.5, 1),
          true);
  const RodSolid solid = solid_of(net.structure);
  EXPECT_EQ(euler_number(solid.surface), 0);
  EXPECT_EQ(solid.joints, 4);
}

TEST(RodSolid, RandomNetworksInSpace) {
  std::mt19937 random(20240611);  // its numbers are the same everywhere; distributions are not
  const auto uniform = [&](double low, double high) { return low + (high - low) * double(random()) / 4294967296.0; };
  for (int trial = 0; trial < 4; ++trial) {
    RodNet net;
    std::vector<Vec3> places;
    while (places.size() < 10) {
      const Vec3 p(uniform(0, 40 * kMm), uniform(0, 40 * kMm), uniform(0, trial < 2 ? 0 : 25 * kMm));
      const bool alone =
          std::all_of(places.begin(), places.end(), [&](const Vec3& q) { return (p - q).norm() > 8 * kMm; });
      if (alone) places.push_back(p);
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (std::size_t j = i + 1; j < places.size(); ++j) {
        if ((places[i] - places[j]).norm() > 18 * kMm) continue;
        net.line(places[i], places[j], ellipse(uniform(1, 2.5), uniform(1, 2)));
      }
    }
    const RodSolid solid = solid_of(net.structure);
    EXPECT_NEAR(solid.volume / counted_volume(net.structure, 0.25 * kMm), 1, 0.02) << "trial " << trial;
  }
}

TEST(RodSolid, SheetOfHexagons) {
  const Result<Structure> structure = discretize(scene_models::hexagon_sheet());
  ASSERT_TRUE(structure.ok());
  const RodSolid solid = solid_of(structure.value());
  EXPECT_EQ(solid.parts, 1);
  EXPECT_LT(solid.surface.triangles.size(), 400'000U);
  EXPECT_GT(solid.tubes, 200);
  EXPECT_NEAR(solid.volume / counted_volume(structure.value(), 0.25 * kMm), 1, 0.02);
}

TEST(RodSolid, ToleranceDecidesTheNumberOfTriangles) {
  RodNet net;
  for (int k = 0; k < 3; ++k)
    net.line({0, 0, 0}, Vec3(std::cos(2.0944 * k), std::sin(2.0944 * k), 0) * 0.03, ellipse(2, 2));
  const RodSolid coarse = solid_of(net.structure, 2e-4), fine = solid_of(net.structure, 2e-5);
  EXPECT_GT(fine.surface.triangles.size(), 4 * coarse.surface.triangles.size());
  EXPECT_NEAR(fine.volume / coarse.volume, 1, 0.01);
}

TEST(RodSolid, SurfacesAreTheSameAtAnyNumberOfThreads) {
  RodNet net;
  for (int k = 0; k < 3; ++k)
    net.line({0, 0, 0}, Vec3(std::cos(2.1 * k), std::sin(2.1 * k), 0.1 * k) * 0.02, ellipse(2, 1));
  const RodSolid alone = solid_of(net.structure);
  ThreadPool pool(3);
  Context context;
  context.threads = &pool;
  const Result<std::vector<RodSolid>> many = rod_solids(net.structure, {}, context);
  ASSERT_TRUE(many.ok());
  EXPECT_EQ(many.value()[0].surface.triangles, alone.surface.triangles);
  EXPECT_EQ(many.value()[0].surface.vertices, alone.surface.vertices);
}

TEST(RodSolid, MaterialsAreSolidsOfTheirOwn) {
  RodNet net;
  net.line({0, 0, 0}, {20 * kMm, 0, 0}, ellipse(1.5, 1.5));
  net.line({20 * kMm, 0, 0}, {40 * kMm, 0, 0}, ellipse(1.5, 1.5));
  net.structure.rods[1].material = "PLA";
  const Result<std::vector<RodSolid>> solids = rod_solids(net.structure, {}, {});
  ASSERT_TRUE(solids.ok());
  ASSERT_EQ(solids.value().size(), 2U);
  EXPECT_EQ(solids.value()[0].material, "TPU 92A");
  EXPECT_EQ(solids.value()[1].material, "PLA");
}

TEST(RodSolid, RefusesWhatItCannotDo) {
  EXPECT_EQ(rod_solids(Structure(), {}, {}).error().code, ErrorCode::kGeometry);
  RodNet net;
  net.line({0, 0, 0}, {20 * kMm, 0, 0}, ellipse(1.5, 1.5));
  for (const double tolerance : {0.0, -1.0, 1e-9, 2.0, std::nan("")}) {
    EXPECT_EQ(rod_solids(net.structure, {tolerance}, {}).error().where, "tolerance");
  }
}

}  // namespace
}  // namespace lissom
