/// Edges of membranes, and selections of their vertices.

#include "lissom/model/membrane_rim.h"

#include <gtest/gtest.h>

#include "lissom/model/model.h"

namespace lissom {
namespace {

Model with(MembraneShape shape) {
  Model model;
  Membrane membrane;
  membrane.name = "sheet";
  membrane.shape = std::move(shape);
  membrane.material = "soft knit";
  model.membranes = {membrane};
  return model;
}

Structure cut(const Model& model) {
  Result<Structure> structure = discretize(model);
  EXPECT_TRUE(structure) << (structure ? "" : structure.error().text());
  return structure ? std::move(structure).value() : Structure();
}

size_t selected(const Model& model, const Structure& structure, Selector::Kind kind, Selector::Rim rim) {
  Selector selector;
  selector.kind = kind;
  selector.name = "sheet";
  selector.rim = rim;
  const Result<std::vector<int>> nodes = select(model, structure, selector, "/here");
  return nodes ? nodes.value().size() : 0;
}

TEST(MembraneRim, AnAnnulusHasTwoLoops) {
  const Model model = with(MembraneDisc{Vec2(0.1, 0.2), 0.06, 0.03, 4, 24});
  const Structure s = cut(model);
  const std::vector<RimLoop> loops = rim_loops(s, 0);
  ASSERT_EQ(loops.size(), 2u);
  for (size_t k = 0; k < 2; ++k) {
    ASSERT_EQ(loops[k].size(), 24u);
    for (size_t i = 0; i < 24; ++i) {
      const RimEdge& edge = loops[k][i];
      EXPECT_NEAR((s.nodes[edge.node0].head<2>() - Vec2(0.1, 0.2)).norm(), k == 0 ? 0.06 : 0.03, 1e-12);
      EXPECT_EQ(edge.node1, loops[k][(i + 1) % 24].node0);
      EXPECT_EQ(s.triangles[edge.triangle].node[edge.corner], edge.node0);
      EXPECT_EQ(s.triangles[edge.triangle].node[(edge.corner + 1) % 3], edge.node1);
    }
  }
  EXPECT_EQ(selected(model, s, Selector::Kind::kMembrane, Selector::Rim::kAll), 5 * 24u);
  EXPECT_EQ(selected(model, s, Selector::Kind::kRim, Selector::Rim::kAll), 48u);
  EXPECT_EQ(selected(model, s, Selector::Kind::kRim, Selector::Rim::kOuter), 24u);
  EXPECT_EQ(selected(model, s, Selector::Kind::kRim, Selector::Rim::kInner), 24u);
}

TEST(MembraneRim, AGridHasOneLoop) {
  const Model model = with(MembraneGrid{Vec2::Zero(), Vec2(0.3, 0.1), 6, 2});
  const Structure s = cut(model);
  ASSERT_EQ(rim_loops(s, 0).size(), 1u);
  EXPECT_EQ(selected(model, s, Selector::Kind::kRim, Selector::Rim::kOuter), 16u);
  EXPECT_EQ(selected(model, s, Selector::Kind::kRim, Selector::Rim::kInner), 0u);
}

TEST(MembraneRim, AClosedSurfaceHasNone) {
  const std::vector<Vec3> points{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  const Model model = with(MembraneMesh{points, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}});
  ASSERT_TRUE(model.validate());
  EXPECT_TRUE(rim_loops(cut(model), 0).empty());
}

TEST(MembraneRim, TrianglesThatTouchAtAPointHaveOneRimEach) {
  const std::vector<Vec3> points{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, -1, 0)};
  const Model model = with(MembraneMesh{points, {{0, 1, 2}, {0, 3, 4}}});
  const Structure s = cut(model);
  size_t edges = 0;
  for (const RimLoop& loop : rim_loops(s, 0)) edges += loop.size();
  EXPECT_EQ(edges, 6u);
}

}  // namespace
}  // namespace lissom
