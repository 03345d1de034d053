/// Room between rods, as a wish about radii and rest shapes.

#include "lissom/design/clearance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <utility>
#include <vector>

#include "lissom/design/network_radii.h"
#include "lissom/design/rest_shape.h"
#include "lissom/fabrication/near_rods.h"
#include "scenes/parts.h"

namespace lissom {
namespace {

constexpr int kEdges = 6;
constexpr double kRadius = 1.5e-3;  // m

/// Lines in the x-y plane, points in mm, as rods with a radius of 1.5 mm; normals along z.
std::shared_ptr<const Design> drawn(const std::vector<Vec2>& points, const std::vector<std::array<int, 2>>& lines) {
  ObjLines drawing;
  for (const Vec2& x : points) drawing.points.emplace_back(1e-3 * x[0], 1e-3 * x[1], 0);
  drawing.segments = lines;
  Model model = scene_models::sheet("lines", drawing, kRadius, "TPU 92A", kEdges);
  Result<System> system = make_system(model);
  EXPECT_TRUE(system) << system.error().text();
  return std::make_shared<const Design>(Design{std::move(model), std::move(system).value()});
}

std::shared_ptr<const Design> parallel() { return drawn({{0, 0}, {30, 0}, {0, 8}, {30, 8}}, {{0, 1}, {2, 3}}); }

/// m, on the first edge.
Vec3 place(const Structure& structure, const EdgePair& pair) {
  const StructureEdge& edge = structure.edges[static_cast<std::size_t>(pair.edge0)];
  const Vec3 &x0 = structure.nodes[static_cast<std::size_t>(edge.node0)],
             &x1 = structure.nodes[static_cast<std::size_t>(edge.node1)];
  return x0 + pair.at0 * (x1 - x0);
}

TEST(Clearance, EveryEdgeHasItsNeighbourOnTheOtherRod) {
  const std::vector<EdgePair> pairs = edges_side_by_side(parallel()->system.structure, 0.01, kRadius);
  ASSERT_EQ(pairs.size(), 2u * kEdges);
  for (const EdgePair& pair : pairs) {
    EXPECT_NEAR(pair.distance, 8e-3, 1e-12);
    EXPECT_NEAR(std::abs(pair.direction.y()), 1, 1e-12);
  }
  EXPECT_TRUE(edges_side_by_side(parallel()->system.structure, 7.9e-3, kRadius).empty());
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
  const Result<LinearSpace> space = rest_shape_space(base, {ControlStage::kThirds, 1e-3, RestShapeGauge::kFree});
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
  for (const double least : {1e-3, 1.3e-3}) {
    const std::vector<EdgePair> pairs = edges_side_by_side(structure, 5e-3, least);
    ASSERT_FALSE(pairs.empty());
    for (const EdgePair& pair : pairs) {
      EXPECT_NE(structure.edges[static_cast<std::size_t>(pair.edge0)].rod, 2);
      EXPECT_GT(3e-3 + 2 * place(structure, pair).x(), kJointDetour * 2 * least);
    }
  }
}

/// Rods that part at the ends of another one are watched where they are not much farther along than across, too: the rest
/// shape may bring them together.
TEST(Clearance, RodsThatPartAreWatchedFromTheJoint) {
  const std::shared_ptr<const Design> base = drawn({{0, 0}, {-10, 20}, {6, 0}, {16, 20}}, {{0, 1}, {2, 3}, {0, 2}});
  const Structure& structure = base->system.structure;
  double nearest = 1;
  for (const EdgePair& pair : edges_side_by_side(structure, 0.02, 1e-3)) {
    nearest = std::min(nearest, std::abs(place(structure, pair).y()));
  }
  EXPECT_LT(nearest, 1e-6);  // 6 mm along the rods are more than 3.6 mm
}

/// A rest shape that arches a short rod brings the ends of its neighbours together: no joint for the check of prints, for the way
/// along the arch is long.
TEST(Clearance, MissesWhatPrintsAreRefusedFor) {
  const std::shared_ptr<const Design> base = drawn({{0, 0}, {-4, 20}, {6, 0}, {10, 20}}, {{0, 1}, {2, 3}, {0, 2}});
  const Result<LinearSpace> space = rest_shape_space(base, {ControlStage::kThirds, 3.5e-3, RestShapeGauge::kFree});
  ASSERT_TRUE(space);
  VecX p = space.value().start();
  const ParameterGoal wish = make_clearance(*base, space.value(), 6e-4);
  EXPECT_TRUE(wish_residual(wish, p).isZero(0));
  const std::span<const Parameter> parameters = space.value().parameters();
  for (Eigen::Index i = 0; i < p.size(); ++i) {
    const Parameter& parameter = parameters[static_cast<std::size_t>(i)];
    const Vec3& x = *parameter.at;
    if (x.y() > 1e-6) continue;
    const bool end = x.x() < 1e-6 || x.x() > 5.9e-3;
    if (parameter.axis == 0 && end) p[i] = x.x() < 3e-3 ? 1.5e-3 : -1.5e-3;
    if (parameter.axis == 1 && !end) p[i] = -3e-3;
  }
  const Result<Design> changed = space.value().at(p);
  ASSERT_TRUE(changed);
  const std::vector<NearRods> near = near_rods(rod_pieces(changed.value().system.structure, 1e-4), 5e-4);
  const auto neighbours =
      std::find_if(near.begin(), near.end(), [](const NearRods& n) { return n.rod0 == 0 && n.rod1 == 1; });
  ASSERT_NE(neighbours, near.end());
  EXPECT_LT(neighbours->gap, 1e-4);
  // 3 mm between the axes and two radii of 1.5 mm: all of the gap is missing.
  EXPECT_GT(wish_residual(wish, p).cwiseAbs().maxCoeff(), 0.9);
}

}  // namespace
}  // namespace lissom
