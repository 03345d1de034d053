/// Projects as text.

#include "lissom/model/rod_mesh_document.h"

#include <gtest/gtest.h>

#include "scenes/rod_mesh_examples.h"

namespace lissom {
namespace {

TEST(ProjectDocument, IsReadAsItWasWritten) {
  for (const scene_models::RodMeshExampleInfo& info : scene_models::rod_mesh_examples()) {
    const Result<scene_models::RodMeshExample> example = info.make();
    ASSERT_TRUE(example.ok()) << info.name;
    const std::string text = write_project(example.value().project);
    EXPECT_TRUE(is_project(text));
    const Result<RodMeshProject> read = read_project(text);
    ASSERT_TRUE(read.ok()) << info.name << ": " << read.error().text();
    EXPECT_EQ(write_project(read.value()), text);
    EXPECT_EQ(read.value().poses.size(), example.value().project.poses.size());
  }
}

TEST(ProjectDocument, HoldsEverything) {
  RodMeshProject p;
  p.title = "all";
  p.surface = {"a.obj", {}, 0.2, true, true};
  p.topology = PatternTopology{PatternTopology::Shape::kTriangles, 0.03};
  p.rods.valence = 5;
  p.rods.r_n = 2e-3;
  DeformerBrief body;
  body.name = "body";
  body.kind = DeformerBrief::Kind::kSolid;
  body.cell = 0.01;
  body.regions.push_back({Vec3(0, 0, 0), Vec3(1, 1, 1), 0.25, 0.01, 0.002, 3, 0.5});
  p.deformers = {body};
  MeshPose pose;
  pose.pose.name = "one";
  pose.pose.supports.emplace_back();
  pose.warp = {{Vec3(0, 0, 0), Vec3(1, 0, 0)}};
  pose.weight = 2;
  MeshPose other = pose;
  other.pose.name = "other";
  other.warp.clear();
  other.mesh = "b.obj";
  other.held_back = true;
  p.poses = {pose, other};
  p.design = {"newton", Vec2(1e-3, 4e-3), 0.02, 7e-4, {1, 2, 3, 4}, 0.5, 100};
  p.print = {"fdm", 2e-4, Vec3(0.2, 0.2, 0.3)};
  const Result<RodMeshProject> read = read_project(write_project(p));
  ASSERT_TRUE(read.ok()) << read.error().text();
  const RodMeshProject& q = read.value();
  EXPECT_EQ(*q.surface.size, 0.2);
  EXPECT_TRUE(q.surface.fill_holes && q.surface.keep_largest);
  EXPECT_EQ(std::get<PatternTopology>(q.topology).width, 0.03);
  EXPECT_EQ(q.rods.valence, 5);
  const DeformerRegion& region = q.deformers.at(0).regions.at(0);
  EXPECT_EQ(region.high, Vec3(1, 1, 1));
  EXPECT_EQ(region.dark, 0.25);
  EXPECT_EQ(region.depth, 0.01);
  EXPECT_EQ(region.blend, 0.002);
  EXPECT_EQ(region.density, 0.5);
  EXPECT_EQ(q.poses.at(0).warp.at(0)[1], Vec3(1, 0, 0));
  EXPECT_EQ(q.poses[0].weight, 2);
  EXPECT_EQ(q.poses.at(1).mesh, "b.obj");
  EXPECT_TRUE(q.poses[1].held_back);
  EXPECT_EQ(q.design.method, "newton");
  EXPECT_EQ(q.design.iterations, (std::array{1, 2, 3, 4}));
  EXPECT_EQ(q.design.smoothness, 0.5);
  EXPECT_EQ(q.design.clearance, 7e-4);
  EXPECT_EQ(q.print.process, "fdm");
  EXPECT_EQ(*q.print.bed, Vec3(0.2, 0.2, 0.3));
}

TEST(ProjectDocument, ShellsHaveNoDepth) {
  Result<scene_models::RodMeshExample> made = scene_models::hat_example();
  ASSERT_TRUE(made.ok());
  RodMeshProject& p = made.value().project;
  ASSERT_TRUE(p.validate().ok());
  p.deformers[1].regions.emplace_back().depth = 0.01;
  const Status s = p.validate();
  ASSERT_FALSE(s.ok());
  EXPECT_EQ(s.error().where, "/deformers/even/regions/0/depth");
  p.deformers[1].kind = DeformerBrief::Kind::kSolid;
  EXPECT_TRUE(p.validate().ok());
}

TEST(ProjectDocument, OthersAreNotProjects) {
  EXPECT_FALSE(is_project("{\"lissom\": 1}"));
  EXPECT_FALSE(is_project("nonsense"));
  EXPECT_FALSE(read_project("{\"lissom_project\": 99}").ok());
  const Result<RodMeshProject> empty = read_project("{\"lissom_project\": 1}");
  ASSERT_FALSE(empty.ok());
  EXPECT_NE(empty.error().text().find("surface"), std::string::npos);
}

}  // namespace
}  // namespace lissom
