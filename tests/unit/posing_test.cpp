/// Deformers, warps, and how a project becomes a structure.

#include <gtest/gtest.h>

#include "lissom/model/structure.h"
#include "lissom/posing/deformer.h"
#include "lissom/posing/posed_mesh.h"
#include "lissom/posing/stiffness_map.h"
#include "lissom/posing/warp.h"
#include "scenes/parts.h"
#include "tests/unit/surface_samples.h"

namespace lissom {
namespace {

using scene_models::box;

Support pin(const Selector& at) { return scene_models::hold(at, SupportKind::kPin); }

TEST(StiffnessMap, FadesOutwardsAndMultiplies) {
  DeformerRegion soft;
  soft.low = Vec3(0, 0, 0);
  soft.high = Vec3(1, 1, 1);
  soft.stiffness = 0.01;
  soft.blend = 0.5;
  DeformerRegion dark;
  dark.dark = 0.5;
  dark.stiffness = 4;
  dark.density = 3;
  const std::vector<DeformerRegion> regions{soft, dark};
  const auto factors = [&](const Vec3& x, double darkness) { return factors_at(regions, {x, darkness, 0}); };
  EXPECT_DOUBLE_EQ(factors(Vec3(0.5, 0.5, 0.5), 0).stiffness, 0.01);
  EXPECT_DOUBLE_EQ(factors(Vec3(0.5, 0.5, 0.5), 0.7).stiffness, 0.04);
  EXPECT_DOUBLE_EQ(factors(Vec3(1.25, 0.5, 0.5), 0).stiffness, 0.1);  // half of it, in the exponent
  EXPECT_DOUBLE_EQ(factors(Vec3(1.5, 0.5, 0.5), 0).stiffness, 1);
  EXPECT_DOUBLE_EQ(factors(Vec3(3, 3, 3), 1).density, 3);
}

TEST(StiffnessMap, HasACoreInsideOfASkin) {
  DeformerRegion core;
  core.depth = 0.01;
  core.blend = 0.004;
  core.stiffness = 0.01;
  const auto factors = [&](double depth) { return factors_at({core}, {Vec3::Zero(), 0, depth}); };
  EXPECT_DOUBLE_EQ(factors(0.02).stiffness, 0.01);
  EXPECT_DOUBLE_EQ(factors(0.01).stiffness, 0.01);
  EXPECT_DOUBLE_EQ(factors(0.008).stiffness, 0.1);
  EXPECT_DOUBLE_EQ(factors(0.006).stiffness, 1);
  EXPECT_DOUBLE_EQ(factors(0).stiffness, 1);
}

TEST(Warp, TakesPlacesWhereTheyGo) {
  std::vector<std::array<Vec3, 2>> pairs;
  for (const double x : {0.0, 0.1, 0.2}) {
    for (const double y : {0.0, 0.1}) pairs.push_back({Vec3(x, y, 0), Vec3(x, y, x * y)});
  }
  const Result<Warp> warp = Warp::make(pairs, "warp");
  ASSERT_TRUE(warp.ok());
  for (const auto& [from, to] : pairs) EXPECT_LT((warp.value()(from) - to).norm(), 1e-12);
}

TEST(Warp, ReproducesAffineMotions) {
  const Mat3 a = (Mat3() << 1, 0.2, 0, 0, 0.9, 0.1, 0.3, 0, 1.1).finished();
  const Vec3 b(0.1, 0.2, 0.3);
  std::vector<std::array<Vec3, 2>> pairs;
  for (const Vec3& x : samples::icosphere(0, 0.1).vertices) pairs.push_back({x, a * x + b});
  const Result<Warp> warp = Warp::make(pairs, "warp");
  ASSERT_TRUE(warp.ok());
  const Vec3 x(0.02, -0.03, 0.07);
  EXPECT_LT((warp.value()(x) - (a * x + b)).norm(), 1e-12);
  // In a plane what is off it goes along.
  std::vector<std::array<Vec3, 2>> flat;
  for (const Vec2& p : {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1), Vec2(1, 1)}) {
    flat.push_back({Vec3(p[0], p[1], 0), Vec3(2 * p[0], p[1], 0)});
  }
  const Result<Warp> stretched = Warp::make(flat, "warp");
  ASSERT_TRUE(stretched.ok());
  EXPECT_LT((stretched.value()(Vec3(0.5, 0.5, 0.1)) - Vec3(1, 0.5, 0.1)).norm(), 1e-12);
}

TEST(Warp, RefusesAPlaceThatGoesTwoWays) {
  const Result<Warp> warp = Warp::make({{Vec3(0, 0, 0), Vec3(1, 0, 0)}, {Vec3(0, 0, 0), Vec3(0, 1, 0)}}, "warp");
  ASSERT_FALSE(warp.ok());
  EXPECT_EQ(warp.error().where, "warp/1");
}

TEST(Deformer, OfAShellBendsMoreWhereItIsSoft) {
  const Surface sheet = samples::sheet(16, 8, 0.2);
  Pose pose;
  pose.name = "hanging";
  pose.supports = {pin(box(Vec3(-1, -1, -1), Vec3(0.013, 1, 1)))};
  const Selector far = box(Vec3(0.19, -1, -1), Vec3(1, 1, 1));
  pose.forces = {{far, Vec3(0, 0, -0.005), true, Scaling::kProportional}};
  DeformerBrief even;
  even.name = "even";
  even.modulus = 2e7;
  DeformerBrief soft = even;
  soft.regions.push_back({Vec3(0.1, -1, -1), Vec3(1, 1, 1), 0, 0, 0, 0.2, 1});
  double drop[2] = {0, 0};
  for (const DeformerBrief* brief : {&even, &soft}) {
    const Result<Deformer> deformer = Deformer::make(*brief, sheet, "deformer");
    ASSERT_TRUE(deformer.ok()) << deformer.error().text();
    const Result<std::vector<Vec3>> posed = deformer.value().posed(pose, "pose", {});
    ASSERT_TRUE(posed.ok()) << posed.error().text();
    ASSERT_EQ(posed.value().size(), sheet.vertices.size());
    drop[brief == &soft ? 1 : 0] = sheet.vertices.back()[2] - posed.value().back()[2];
    EXPECT_LT((posed.value().front() - sheet.vertices.front()).norm(), 1e-12);
    const Result<VecX> held = deformer.value().selected(pose.supports[0].at, "pose");
    ASSERT_TRUE(held.ok());
    EXPECT_EQ(held.value().sum(), 2 * 9);
  }
  EXPECT_GT(drop[0], 1e-3);
  EXPECT_GT(drop[1], 1.2 * drop[0]);
}

TEST(Deformer, OfABodyCarriesTheSurface) {
  const Surface ball = samples::icosphere(2, 0.05);
  DeformerBrief brief;
  brief.name = "ball";
  brief.kind = DeformerBrief::Kind::kSolid;
  brief.modulus = 1e5;
  brief.cell = 0.015;
  const Result<Deformer> deformer = Deformer::make(brief, ball, "deformer");
  ASSERT_TRUE(deformer.ok()) << deformer.error().text();
  Pose pose;
  pose.name = "flattened";
  pose.supports = {pin(box(Vec3(-1, -1, -1), Vec3(1, 1, -0.035)))};
  pose.forces = {{box(Vec3(-1, -1, 0.035), Vec3(1, 1, 1)), Vec3(0, 0, -30), true, Scaling::kProportional}};
  const Result<std::vector<Vec3>> posed = deformer.value().posed(pose, "pose", {});
  ASSERT_TRUE(posed.ok()) << posed.error().text();
  double top = -1, before = -1;
  for (const Vec3& x : posed.value()) top = std::max(top, x[2]);
  for (const Vec3& x : ball.vertices) before = std::max(before, x[2]);
  EXPECT_LT(top, before - 2e-3);
  EXPECT_GT(top, 0);
  // A skin about a soft core gives way further.
  brief.regions.push_back({{}, {}, 0, 0.015, 0, 0.1, 1});
  const Result<Deformer> skin = Deformer::make(brief, ball, "deformer");
  ASSERT_TRUE(skin.ok()) << skin.error().text();
  const Result<std::vector<Vec3>> sunk = skin.value().posed(pose, "pose", {});
  ASSERT_TRUE(sunk.ok()) << sunk.error().text();
  double lower = -1;
  for (const Vec3& x : sunk.value()) lower = std::max(lower, x[2]);
  EXPECT_LT(lower, top - 1e-3);
  brief.regions.clear();
  const Result<Deformer> open = Deformer::make(brief, samples::sheet(4, 4, 0.1), "deformer");
  ASSERT_FALSE(open.ok());
  EXPECT_EQ(open.error().where.substr(0, 8), "deformer");
}

RodMeshProject flap() {
  RodMeshProject project;
  project.topology = CellTopology{16, 1, 1};
  project.rods.edges = 5;
  MeshPose pose;
  pose.pose.name = "lifted";
  pose.pose.supports = {pin(box(Vec3(-1, -1, -1), Vec3(0.015, 1, 1))), pin(box(Vec3(0.185, -1, -1), Vec3(1, 1, 1)))};
  for (const double x : {0.0, 0.1, 0.2}) {
    for (const double y : {0.0, 0.2}) pose.warp.push_back({Vec3(x, y, 0), Vec3(x, y, x * x)});
  }
  project.poses = {pose};
  return project;
}

TEST(PosedMesh, HoldsRodsWhereTheSurfaceIsHeld) {
  ProjectFiles files;
  files.surface = samples::sheet(40, 40, 0.2);
  const RodMeshProject project = flap();
  const Result<PosedMesh> made = pose_rod_mesh(project, files, {});
  ASSERT_TRUE(made.ok()) << made.error().text();
  const Model& model = made.value().model;
  ASSERT_TRUE(model.validate().ok());
  const Structure structure = discretize(model).value();
  ASSERT_EQ(made.value().targets.at(0).size(), structure.nodes.size());
  const Warp warp = Warp::make(project.poses[0].warp, "").value();
  int held = 0;
  for (std::size_t n = 0; n < structure.nodes.size(); ++n) {
    const Vec3& x = structure.nodes[n];
    // Between vertices the surface is flat.
    EXPECT_LT((made.value().targets[0][n] - warp(x)).norm(), 5e-5);
    held += x[0] < 0.015 || x[0] > 0.185 ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(model.poses.at(0).soft_pins.size()), held, 3);
  ASSERT_TRUE(model.design.has_value());
  EXPECT_EQ(model.design->stages.size(), 3u);
  EXPECT_EQ(model.design->goals.size(), 1u);
  EXPECT_EQ(made.value().joints - static_cast<int>(structure.rods.size()) + 16, 1);
}

TEST(PosedMesh, NeedsRodsWhereItIsHeld) {
  ProjectFiles files;
  files.surface = samples::sheet(20, 20, 0.2);
  RodMeshProject project = flap();
  // In the middle of one of four cells.
  project.poses[0].pose.supports.push_back(pin(box(Vec3(0.045, 0.045, -1), Vec3(0.055, 0.055, 1))));
  project.topology = CellTopology{4, 1, 1};
  const Result<PosedMesh> made = pose_rod_mesh(project, files, {});
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().where, "/poses/0/pose/supports/2/at");
  EXPECT_FALSE(made.error().hint.empty());
}

}  // namespace
}  // namespace lissom
