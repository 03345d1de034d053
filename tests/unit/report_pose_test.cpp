#include "lissom/session/report_pose.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "scenes/scene_models.h"

namespace lissom {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

System hexagons() { return make_system(scene_models::hexagon_sheet()).value(); }

/// All nodes of the hexagon sheet where they are drawn, moved by `shift`.
std::vector<Vec3> drawn(const System& system, const Vec3& shift) {
  std::vector<Vec3> wanted;
  for (const Vec3& p : system.structure.nodes) wanted.push_back(p + shift);
  return wanted;
}

size_t edges(const Drawing& drawing) { return static_cast<size_t>(drawing.edge_count()); }

TEST(ReportPose, DeviationIsTheDistanceFromTheTarget) {
  const System system = hexagons();
  const State state = drawn_state(system);
  const std::vector<Vec3> wanted = drawn(system, {0, 0.003, 0.004});
  const DesignReport::Pose pose = report_pose("hung", system, state, system, state, wanted);
  EXPECT_EQ(pose.name, "hung");
  EXPECT_EQ(pose.targets.size(), system.structure.nodes.size());
  EXPECT_EQ(edges(pose.target), system.structure.edges.size());
  EXPECT_TRUE(pose.dots.empty());
  const Field* deviation = pose.after.field(kDeviation);
  ASSERT_NE(deviation, nullptr);
  ASSERT_FALSE(deviation->values.empty());
  for (const double d : deviation->values) EXPECT_NEAR(d, 0.005, 1e-15);
  for (const Drawing* drawing : {&pose.target, &pose.before, &pose.after}) EXPECT_TRUE(check_drawing(*drawing).ok());
}

TEST(ReportPose, OnlyPiecesWithTargetsAtBothEndsAreDrawnAndLonelyTargetsAreDots) {
  const System system = hexagons();
  const State state = drawn_state(system);
  std::vector<Vec3> wanted(system.structure.nodes.size(), Vec3::Constant(kNone));
  const StructureRod& rod = system.structure.rods[0];
  ASSERT_GE(rod.nodes.size(), 4u);
  const std::vector<Vec3> whole = drawn(system, {0, 0, 0.01});
  wanted[rod.nodes[0]] = whole[rod.nodes[0]];
  wanted[rod.nodes[1]] = whole[rod.nodes[1]];
  wanted[rod.nodes[3]] = whole[rod.nodes[3]];
  const DesignReport::Pose pose = report_pose("p", system, state, system, state, wanted);
  EXPECT_EQ(pose.targets.size(), 3u);
  EXPECT_EQ(edges(pose.target), 1u);
  ASSERT_EQ(pose.dots.size(), 1u);
  EXPECT_EQ(pose.dots[0], whole[rod.nodes[3]]);
  size_t without = 0;
  for (const double d : pose.after.field(kDeviation)->values) without += std::isnan(d);
  EXPECT_GT(without, 0u);
}

TEST(ReportPose, WithoutTargetsThereIsNoDeviation) {
  const System system = hexagons();
  const State state = drawn_state(system);
  const std::vector<Vec3> wanted(system.structure.nodes.size(), Vec3::Constant(kNone));
  const DesignReport::Pose pose = report_pose("p", system, state, system, state, wanted);
  EXPECT_TRUE(pose.targets.empty());
  EXPECT_EQ(pose.after.field(kDeviation), nullptr);
}

/// Points of a plate in the xy plane whose targets are `shift` away.
DesignReport::Pose plate(const Vec3& shift) {
  DesignReport::Pose pose;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      const Vec3 p(0.1 * i, 0.1 * j, 0);
      pose.targets.push_back({p + shift, p, p});
    }
  }
  return pose;
}

/// Share of the length of `shift` that is seen.
double seen(const Viewpoint& view, const Vec3& shift) {
  const Vec3 towards(std::cos(view.elevation) * std::cos(view.azimuth),
                     std::cos(view.elevation) * std::sin(view.azimuth), std::sin(view.elevation));
  return (shift - shift.dot(towards) * towards).norm() / shift.norm();
}

TEST(ViewOfDeviations, ShowsThemAndTheShape) {
  for (const Vec3& shift : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 1, 1), Vec3(-1, 2, 0.5)}) {
    const Viewpoint view = view_of_deviations(plate(0.01 * shift));
    EXPECT_GT(seen(view, shift), 0.8) << shift.transpose();
    EXPECT_GT(view.elevation, 0.3);  // the plate is not seen edge-on
  }
}

TEST(ViewOfDeviations, IsTheUsualOneWhereThereIsNothingToSee) {
  EXPECT_EQ(view_of_deviations({}).azimuth, Viewpoint::iso().azimuth);
  EXPECT_EQ(view_of_deviations(plate(Vec3::Zero())).elevation, Viewpoint::iso().elevation);
}

}  // namespace
}  // namespace lissom
