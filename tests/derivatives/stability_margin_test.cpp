/// The stability margin against differences of eigenvalues.

#include <numbers>

#include "lissom/design/objective_stability_margin.h"
#include "lissom/equilibrium/solve.h"
#include "tests/derivatives/objective_cases.h"

namespace lissom {
namespace {

using namespace objective_tests;

/// Shares of length and area for the free unknowns, with the radii of gyration that the system has.
VecX metric_of(const System& system, const Supports& supports) {
  double length = 0, area = 0;
  for (const EdgeRest& edge : system.rest.edges) length += edge.length;
  for (const TriangleRest& triangle : system.rest.triangles) area += triangle.area;
  const double rods = area > 0 ? 0.5 : 1;
  VecX metric = VecX::Zero(system.layout.size());
  for (int e = 0; e < system.edge_count(); ++e) {
    const double share = rods * system.rest.edges[e].length / length;
    for (const int node : {system.structure.edges[e].node0, system.structure.edges[e].node1}) {
      metric.segment<3>(3 * node).array() += share / 2;
    }
    metric[system.layout.roll(e)] = share * system.rest.edges[e].gyration2;
  }
  for (std::size_t t = 0; t < system.rest.triangles.size(); ++t) {
    for (const int node : system.structure.triangles[t].node) {
      metric.segment<3>(3 * node).array() += 0.5 * system.rest.triangles[t].area / area / 3;
    }
  }
  VecX free;
  supports.restrict(metric, free);
  return free;
}

/// The margin of a shape in equilibrium against differences, along unknowns, numbers and both.
void check_derivatives(Shape& shape, const Objective& margin) {
  VecX c;
  margin.values(shape.pose_shape(), c);
  SparseRows by_q, by_numbers;
  margin.jacobian(shape.pose_shape(), by_q, by_numbers);

  const VecX metric = shape.problem.mode_metric;
  const auto at = [&](const VecX& dq, const VecX& dn) {
    const ChangedTerms changed(shape.problem.potential, dn);
    const Design design{shape.design.model, system_with(shape, dn)};
    State moved;
    EXPECT_TRUE(advance(design.system, shape.state, dq, moved));
    shape.problem.mode_metric = metric_of(design.system, shape.problem.supports);
    VecX value;
    margin.values({design, design.model.poses[0], shape.problem, moved}, value);
    shape.problem.mode_metric = metric;
    return value[0];
  };
  std::mt19937 random(3);
  const RestNumbers layout(shape.design.system.structure);
  for (int k = 0; k < 4; ++k) {
    VecX dq = random_motion(shape.design.system, random, 1), dn = random_numbers(shape, random, 1);
    for (std::size_t i = 0; i < shape.design.system.connections.size(); ++i) {
      dn.segment<3>(layout.connection(static_cast<int>(i), kRestTurn)).setZero();  // hand-written Hessians have none
    }
    if (k == 0) dn.setZero();
    if (k == 1) dq.setZero();
    if (k == 2) dq.head(3 * shape.design.system.layout.nodes()).setZero();
    const double exact = (by_q * dq + by_numbers * dn)[0];
    const auto slope = [&](double h) { return (at(h * dq, h * dn) - at(-h * dq, -h * dn)) / (2 * h); };
    const double h = 4e-5, a = slope(h), b = slope(h / 2), d = slope(h / 4);
    const double ab = (4 * b - a) / 3, bd = (4 * d - b) / 3, difference = (16 * bd - ab) / 15;
    EXPECT_NEAR(exact, difference, 1e-6 * std::abs(exact)) << k << ", margin " << c[0];
  }
}

class Margin : public testing::TestWithParam<JointKind> {};

TEST_P(Margin, DerivativesMatchDifferences) {
  const auto shape = make_shape(model_of_everything(GetParam()), 0);
  ASSERT_NE(shape, nullptr);
  SolveOptions options;
  options.tolerance = 1e-11;
  const Equilibrium found = solve(shape->problem, shape->state, 1, options);
  ASSERT_EQ(found.verdict, Verdict::kStable) << found.message;
  shape->state = found.state;
  const auto margin = make_stability_margin();
  EXPECT_FALSE(margin->has_curvature());
  EXPECT_EQ(metric_of(shape->design.system, shape->problem.supports).size(), shape->problem.mode_metric.size());
  EXPECT_LT((metric_of(shape->design.system, shape->problem.supports) - shape->problem.mode_metric).norm(),
            1e-13 * shape->problem.mode_metric.norm());
  VecX c;
  margin->values(shape->pose_shape(), c);
  ASSERT_EQ(found.spins, 0);
  ASSERT_FALSE(found.modes.empty());
  EXPECT_NEAR(c[0], found.modes[0].stiffness, 1e-8 * c[0]);
  check_derivatives(*shape, *margin);
}

INSTANTIATE_TEST_SUITE_P(Joints, Margin, testing::Values(JointKind::kExplicit, JointKind::kCorotational), joint_name);

/// A bent rod whose rolls make up much of the metric: what frames that are carried along do to it counts.
TEST(StabilityMargin, RollsAreCountedFromFramesThatMove) {
  Model model;
  model.rods.push_back(rod("rod", Spline{{Vec3::Zero(), Vec3(0.05, 0.03, 0.02), Vec3(0.1, 0, 0.03)}},
                           SectionShape::kEllipse, 1e-3, 2e-3));
  model.rods[0].edges = 8;
  Pose pose;
  pose.name = "loaded";
  Support clamp;
  clamp.at.kind = Selector::Kind::kPoint;
  clamp.kind = SupportKind::kClamp;
  pose.supports.push_back(clamp);
  PointForce force;
  force.at.kind = Selector::Kind::kPoint;
  force.at.point = Vec3(0.1, 0, 0.03);
  force.force = Vec3(1, -2, 3);
  pose.forces.push_back(force);
  model.poses.push_back(pose);
  const auto shape = make_shape(model, 0);
  ASSERT_NE(shape, nullptr);
  SolveOptions options;
  options.tolerance = 1e-11;
  const Equilibrium found = solve(shape->problem, shape->state, 1, options);
  ASSERT_EQ(found.verdict, Verdict::kStable) << found.message;
  shape->state = found.state;
  for (EdgeRest& edge : shape->design.system.rest.edges) edge.gyration2 *= 1e3;
  shape->problem.mode_metric = metric_of(shape->design.system, shape->problem.supports);
  check_derivatives(*shape, *make_stability_margin());
}

/// A straight rod between two points may spin: that is no mode to be afraid of.
TEST(StabilityMargin, SpinsDoNotCount) {
  Model model;
  model.rods.push_back(rod("rod", Polyline{{Vec3::Zero(), Vec3(0.1, 0, 0)}}, SectionShape::kEllipse, 1e-3, 1.5e-3));
  model.rods[0].edges = 24;
  Pose pose;
  pose.name = "held";
  for (const double x : {0.0, 0.1}) {
    Support support;
    support.at.kind = Selector::Kind::kPoint;
    support.at.point = Vec3(x, 0, 0);
    pose.supports.push_back(support);
  }
  model.poses.push_back(pose);
  const auto shape = make_shape(model, 0);
  ASSERT_NE(shape, nullptr);
  VecX c;
  make_stability_margin()->values(shape->pose_shape(), c);
  // Softest bending of a beam on two points: (pi / L)^4 E I L, here with the section of 1 mm.
  const double e = model.material("PLA")->youngs_modulus, i = std::numbers::pi / 4 * 1.5e-3 * 1e-9;
  EXPECT_NEAR(c[0], std::pow(std::numbers::pi / 0.1, 4) * e * i * 0.1, 0.005 * c[0]);
}

}  // namespace
}  // namespace lissom
