/// Room between rods, as a wish about radii and rest shapes.

#include "lissom/design/clearance.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <utility>
#include <vector>

#include "lissom/design/network_radii.h"
#include "lissom/design/rest_shape.h"
#include "scenes/parts.h"

namespace lissom {
namespace {

constexpr int kEdges = 6;

/// Lines in the x-y plane, points in mm, as rods with a radius of 1.5 mm; normals along z.
std::shared_ptr<const Design> drawn(const std::vector<Vec2>& points, const std::vector<std::array<int, 2>>& lines) {
  ObjLines drawing;
  for (const Vec2& x : points) drawing.points.emplace_back(1e-3 * x[0], 1e-3 * x[1], 0);
  drawing.segments = lines;
  Model model = scene_models::sheet("lines", drawing, 1.5e-3, "TPU 92A", kEdges);
  Result<System> system = make_system(model);
  EXPECT_TRUE(system) << system.error().text();
  return std::make_shared<const Design>(Design{std::move(model), std::move(system).value()});
}

std::shared_ptr<const Design> parallel() { return drawn({{0, 0}, {30, 0}, {0, 8}, {30, 8}}, {{0, 1}, {2, 3}}); }

TEST(Clearance, EveryEdgeHasItsNeighbourOnTheOtherRod) {
  const std::vector<EdgePair> pairs = edges_side_by_side(parallel()->system.structure, 0.01);
  ASSERT_EQ(pairs.size(), 2u * kEdges);
  for (const EdgePair& pair : pairs) {
    EXPECT_NEAR(pair.distance, 8e-3, 1e-12);
    EXPECT_NEAR(std::abs(pair.direction.y()), 1, 1e-12);
  }
  EXPECT_TRUE(edges_side_by_side(parallel()->system.structure, 7.9e-3).empty());
}

TEST(Clearance, WhatIsMissingCountsAndNothingElse) {
  const std::shared_ptr<const Design> base = parallel();
  const Result<LinearSpace> space = radii_space(base, ControlStage::kEnds, {1e-3, 5e-3});
  ASSERT_TRUE(space);
  const ParameterGoal wish = make_clearance(*base, space.value(), 1e-3);
  ASSERT_EQ(wish.rows.rows(), 2 * kEdges);
  const Eigen::Index controls = space.value().size() / 2;
  const auto radii = [&](double r_n, double r_b) {
    VecX p(2 * controls);
    p << VecX::Constant(controls, r_n), VecX::Constant(controls, r_b);
    return p;
  };
  // 8 mm between the axes: with 3.5 mm in the plane the gap is 1 mm; across the plane there is room for anything.
  EXPECT_TRUE(wish_residual(wish, radii(5e-3, 3.5e-3 - 1e-9)).isZero(0));
  EXPECT_EQ(wish_jacobian(wish, radii(5e-3, 3e-3)).nonZeros(), 0);
  const VecX missing = wish_residual(wish, radii(1e-3, 3.8e-3));
  for (const double r : missing) EXPECT_NEAR(std::abs(r), 0.6, 1e-9);  // 0.6 of 1 mm
  const VecX step = VecX::LinSpaced(2 * controls, 1e-5, 3e-5), at = radii(2e-3, 4e-3);
  const VecX change = wish_residual(wish, at + step) - wish_residual(wish, at - step);
  EXPECT_LT((change - 2 * wish_jacobian(wish, at) * step).norm(), 1e-9 * change.norm());
}

TEST(Clearance, PlacesMakeRoomToo) {
  const std::shared_ptr<const Design> base = parallel();
  const Result<LinearSpace> space = rest_shape_space(base, {ControlStage::kEnds, 4e-3, RestShapeGauge::kFree});
  ASSERT_TRUE(space);
  const ParameterGoal wish = make_clearance(*base, space.value(), 6e-3);  // 5 mm are there
  VecX p = space.value().start();
  EXPECT_NEAR(wish_residual(wish, p).cwiseAbs().maxCoeff(), 1.0 / 6, 1e-9);
  const std::span<const Parameter> parameters = space.value().parameters();
  for (Eigen::Index i = 0; i < p.size(); ++i) {
    const Parameter& parameter = parameters[static_cast<std::size_t>(i)];
    if (parameter.axis == 1 && parameter.at->y() > 4e-3) p[i] = 1.001e-3;
  }
  EXPECT_TRUE(wish_residual(wish, p).isZero(0));
}

/// Two rods 3 mm apart that a short one joins: beside it they belong to one joint, farther on they are neighbours.
TEST(Clearance, RodsOfOneJointAreNoNeighboursThere) {
  const std::shared_ptr<const Design> base = drawn({{0, 0}, {30, 0}, {0, 3}, {30, 3}}, {{0, 1}, {2, 3}, {0, 2}});
  const Structure& structure = base->system.structure;
  const std::vector<EdgePair> pairs = edges_side_by_side(structure, 5e-3);
  ASSERT_FALSE(pairs.empty());
  for (const EdgePair& pair : pairs) {
    EXPECT_NE(structure.edges[static_cast<std::size_t>(pair.edge0)].rod, 2);
    const StructureEdge& edge = structure.edges[static_cast<std::size_t>(pair.edge0)];
    const double x = structure.nodes[static_cast<std::size_t>(edge.node0)].x() * (1 - pair.at0) +
                     structure.nodes[static_cast<std::size_t>(edge.node1)].x() * pair.at0;
    EXPECT_GT(3e-3 + 2 * x, 1.5 * 3e-3);
  }
}

}  // namespace
}  // namespace lissom
