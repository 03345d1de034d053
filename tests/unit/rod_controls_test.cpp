#include "lissom/design/rod_controls.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <string>

#include "scenes/parts.h"

namespace lissom {
namespace {

/// The Sheet of the thesis' table 5.1: hexagons, three by six, ten edges to a rod.
Structure sheet_of_hexagons() {
  const Model model = scene_models::sheet("sheet", hexagon_pattern(0.02, 3, 6), 1e-3, "TPU 92A", 10);
  Result<Structure> structure = discretize(model);
  EXPECT_TRUE(structure);
  return std::move(structure).value();
}

RodControls controls_of(const Structure& structure, ControlStage stage) {
  Result<RodControls> controls = RodControls::make(structure, stage);
  EXPECT_TRUE(controls);
  return std::move(controls).value();
}

VecX any_values(int n) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(1e-3, 5e-3);
  return VecX::NullaryExpr(n, [&] { return uniform(random); });
}

TEST(RodControls, CountAsTheThesisDoes) {
  const Structure s = sheet_of_hexagons();
  ASSERT_EQ(s.rods.size(), 71u);
  ASSERT_EQ(s.nodes.size(), 693u);
  ASSERT_EQ(s.edges.size(), 710u);
  EXPECT_EQ(controls_of(s, ControlStage::kEnds).size(), 54);
  EXPECT_EQ(controls_of(s, ControlStage::kMiddle).size(), 54 + 71);
  const RodControls thirds = controls_of(s, ControlStage::kThirds);
  EXPECT_EQ(2 * thirds.size(), 392);
  EXPECT_EQ(3 * thirds.size(), 588);
  EXPECT_EQ(thirds.ends(), 54);
}

TEST(RodControls, StagesAreNested) {
  const Structure s = sheet_of_hexagons();
  const ControlStage stages[] = {ControlStage::kEnds, ControlStage::kMiddle, ControlStage::kThirds};
  for (const ControlStage coarse_stage : stages) {
    const RodControls coarse = controls_of(s, coarse_stage);
    const VecX values = any_values(coarse.size());
    for (const ControlStage fine_stage : stages) {
      if (fine_stage < coarse_stage) continue;
      const RodControls fine = controls_of(s, fine_stage);
      const VecX moved = coarse.prolongation(fine) * values;
      EXPECT_LT((fine.edge_weights(s) * moved - coarse.edge_weights(s) * values).cwiseAbs().maxCoeff(), 1e-17);
      EXPECT_LT((fine.node_weights(s) * moved - coarse.node_weights(s) * values).cwiseAbs().maxCoeff(), 1e-17);
    }
  }
}

TEST(RodControls, FollowLinesAndParabolas) {
  const Structure s = sheet_of_hexagons();
  for (const ControlStage stage : {ControlStage::kEnds, ControlStage::kMiddle, ControlStage::kThirds}) {
    const RodControls controls = controls_of(s, stage);
    VecX ones = VecX::Ones(controls.size());
    EXPECT_LT((controls.edge_weights(s) * ones - VecX::Ones(s.edges.size())).cwiseAbs().maxCoeff(), 1e-14);
    // 3 + u (1 - u) along every rod; its ends all have 3.
    if (stage == ControlStage::kEnds) continue;
    VecX values(controls.size());
    for (int c = 0; c < controls.size(); ++c) {
      const double u = controls.controls()[c].at;
      values[c] = 3 + u * (1 - u);
    }
    const VecX along = controls.edge_weights(s) * values;
    for (const StructureRod& rod : s.rods) {
      for (size_t k = 0; k < rod.edges.size(); ++k) {
        const double u = (static_cast<double>(k) + 0.5) / static_cast<double>(rod.edges.size());
        EXPECT_NEAR(along[rod.edges[k]], 3 + u * (1 - u), 1e-14);
      }
    }
  }
}

TEST(RodControls, LeaveTheirRangeByAnEighthAtMost) {
  const Structure s = sheet_of_hexagons();
  double most = 0;
  for (const ControlStage stage : {ControlStage::kEnds, ControlStage::kMiddle, ControlStage::kThirds}) {
    const MatX weights = MatX(controls_of(s, stage).edge_weights(s));
    most = std::max(most, weights.cwiseAbs().rowwise().sum().maxCoeff());
  }
  EXPECT_LE(most, 1.25);
  EXPECT_GT(most, 1.1);
}

TEST(RodControls, AreNamed) {
  const Structure s = sheet_of_hexagons();
  const RodControls thirds = controls_of(s, ControlStage::kThirds);
  EXPECT_EQ(thirds.name(thirds.ends() + 1, s), "rod \"" + s.rods[0].name + "\" at 2/3");
  EXPECT_EQ(thirds.name(0, s), "end at node " + std::to_string(s.rods[0].nodes.front()));
}

TEST(RodControls, RodsHaveToEndWhereTheyMeet) {
  Model model;
  model.rods.push_back(scene_models::round_rod("long", Polyline{{{0, 0, 0}, {0.1, 0, 0}}, false}, 1e-3, "PLA", 10));
  model.rods.push_back(
      scene_models::round_rod("short", Polyline{{{0.05, 0, 0}, {0.05, 0.1, 0}}, false}, 1e-3, "PLA", 10));
  const Result<Structure> structure = discretize(model);
  ASSERT_TRUE(structure) << structure.error().text();
  const Result<RodControls> controls = RodControls::make(structure.value(), ControlStage::kMiddle);
  ASSERT_FALSE(controls);
  EXPECT_EQ(controls.error().message, "rod \"long\" is met by another rod between its ends");
}

}  // namespace
}  // namespace lissom
