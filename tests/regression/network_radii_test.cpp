/// Radii of a rod network: where they go, and how its equilibrium answers, against equilibria solved again.

#include "lissom/design/network_radii.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <utility>

#include "lissom/design/sensitivity.h"
#include "lissom/equilibrium/newton_workspace.h"
#include "lissom/equilibrium/solve.h"
#include "scenes/parts.h"

namespace lissom {
namespace {

constexpr double kLeast = 1e-3, kMost = 5e-3;  // m

Model sheet(JointKind joints) {
  const ObjLines lines = hexagon_pattern(0.02, 2, 3);
  Model model = scene_models::sheet("sheet", lines, 1.5e-3, "TPU 92A", 6);
  model.joint_kind = joints;
  model.poses.push_back(scene_models::hanging_pose(lines, 1e-6));
  return model;
}

/// Radii that differ from place to place.
VecX uneven(const NetworkRadii& space) {
  VecX p(space.size());
  for (int i = 0; i < p.size(); ++i) p[i] = 1.6e-3 + 0.4e-3 * std::sin(1.0 + 2.3 * i);
  return p;
}

struct Solved {
  System system;
  std::unique_ptr<StaticProblem> problem;
  State state;
};

/// The equilibrium, from `start` or else from the drawn shape, polished beyond what a solve asks for.
std::unique_ptr<Solved> solved(const Model& model, const State* start) {
  auto out = std::make_unique<Solved>();
  Result<System> system = make_system(model);
  EXPECT_TRUE(system) << system.error().text();
  out->system = std::move(system).value();
  Result<StaticProblem> problem = make_static_problem(model, out->system, model.poses[0], "/poses/0");
  EXPECT_TRUE(problem);
  out->problem = std::make_unique<StaticProblem>(std::move(problem).value());
  SolveOptions options;
  options.modes = 0;
  const Equilibrium e =
      solve(*out->problem, start != nullptr ? *start : start_state(*out->problem, model.poses[0]), 1, options);
  EXPECT_EQ(e.verdict, Verdict::kStable) << e.message;
  out->state = e.state;
  const Context context;
  NewtonWorkspace workspace(*out->problem, context);
  VecX free, increment;
  State moved;
  for (int k = 0; k < 3; ++k) {
    workspace.assemble(out->state);
    EXPECT_TRUE(workspace.factorize(0).positive_definite);
    workspace.factor().solve(-workspace.free_gradient(), free);
    workspace.to_increment(free, increment);
    EXPECT_TRUE(advance(out->system, out->state, increment, moved));
    std::swap(out->state, moved);
  }
  return out;
}

NetworkRadii space_of(const Model& model, ControlStage stage) {
  Result<NetworkRadii> space = NetworkRadii::make(model, discretize(model).value(), stage, {kLeast, kMost});
  EXPECT_TRUE(space);
  return std::move(space).value();
}

TEST(NetworkRadii, ReachTheEdges) {
  const Model model = sheet(JointKind::kExplicit);
  const NetworkRadii space = space_of(model, ControlStage::kThirds);
  const VecX p = uneven(space);
  const Structure changed = discretize(space.model_at(model, p).value()).value();
  const MatX extents = space.edge_extents(p);
  for (int e = 0; e < extents.rows(); ++e) {
    EXPECT_NEAR(changed.edges[e].section.r_n, extents(e, 0), 1e-17) << e;
    EXPECT_NEAR(changed.edges[e].section.r_b, extents(e, 1), 1e-17) << e;
  }
  const NetworkRadii ends = space_of(model, ControlStage::kEnds);
  const VecX coarse = uneven(ends);
  EXPECT_LT((space.edge_extents(ends.prolonged(coarse, space)) - ends.edge_extents(coarse)).cwiseAbs().maxCoeff(),
            1e-17);
  EXPECT_EQ(space.edge_extents(space.constant(2e-3, 3e-3)).col(1).minCoeff(), 3e-3);
}

void expect_sensitivities(JointKind joints) {
  const Model model = sheet(joints);
  const NetworkRadii space = space_of(model, ControlStage::kThirds);
  const VecX p = uneven(space);
  const Model designed = space.model_at(model, p).value();
  const std::unique_ptr<Solved> at = solved(designed, nullptr);
  const Context context;
  NewtonWorkspace workspace(*at->problem, context);
  workspace.assemble(at->state);
  ASSERT_TRUE(workspace.factorize(0).positive_definite);
  const Result<Sensitivity> sensitivity =
      Sensitivity::make(designed, designed.poses[0], *at->problem, at->state, workspace.factor(),
                        space.rest_inputs(at->system.structure));
  ASSERT_TRUE(sensitivity) << sensitivity.error().text();
  const int positions = 3 * at->system.layout.nodes();
  for (const int parameter : {0, space.controls().ends() + 3, space.size() / 2 + 1, space.size() - 1}) {
    // Central differences, extrapolated once.
    VecX field[2];
    for (int level = 0; level < 2; ++level) {
      const double step = 2e-5 / (level + 1);
      VecX sides[2];
      for (int side = 0; side < 2; ++side) {
        VecX moved = p;
        moved[parameter] += side == 0 ? -step : step;
        sides[side] = solved(space.model_at(model, moved).value(), &at->state)->state.q.head(positions);
      }
      field[level] = (sides[1] - sides[0]) / (2 * step);
    }
    const VecX again = (4 * field[1] - field[0]) / 3;
    const VecX exact = sensitivity.value().forward(VecX::Unit(space.size(), parameter)).head(positions);
    EXPECT_LT((exact - again).norm(), 1e-7 * again.norm()) << space.parameters()[parameter].name;
    const VecX weights = again / again.norm();
    VecX all = VecX::Zero(at->system.layout.size());
    all.head(positions) = weights;
    EXPECT_NEAR(sensitivity.value().adjoint(all)[parameter], exact.dot(weights), 1e-9 * exact.norm());
  }
}

TEST(NetworkRadii, SensitivitiesWithExplicitJoints) { expect_sensitivities(JointKind::kExplicit); }
TEST(NetworkRadii, SensitivitiesWithCorotationalJoints) { expect_sensitivities(JointKind::kCorotational); }

TEST(NetworkRadii, WrongRangesAreNamed) {
  const Model model = sheet(JointKind::kExplicit);
  const Structure structure = discretize(model).value();
  const auto refused = [&](const Vec2& range, ControlStage stage) {
    const Result<NetworkRadii> space = NetworkRadii::make(model, structure, stage, range);
    EXPECT_FALSE(space);
    return space ? std::string() : space.error().message;
  };
  EXPECT_EQ(refused({2e-3, 1e-3}, ControlStage::kEnds), "the range of radii is from 2 to 1 mm");
  EXPECT_EQ(refused({0.5e-3, 5e-3}, ControlStage::kThirds),
            "radii between controls of 0.5 and 5 mm can fall to -0.063 mm");
  EXPECT_EQ(refused({0, NAN}, ControlStage::kEnds), "the range of radii is from 0 to nan mm");

  const NetworkRadii space = space_of(model, ControlStage::kEnds);
  VecX p = space.constant(2e-3, 2e-3);
  p[1] = 6e-3;
  const Result<Model> outside = space.model_at(model, p);
  ASSERT_FALSE(outside);
  EXPECT_EQ(outside.error().message, space.parameters()[1].name + " is 6 mm, outside of 1 to 5 mm");
  p[1] = NAN;
  EXPECT_FALSE(space.model_at(model, p));

  Model tubes = model;
  tubes.rods[2].section.shape = SectionShape::kTube;
  tubes.rods[2].section.wall = 0.2e-3;
  const Result<NetworkRadii> no =
      NetworkRadii::make(tubes, discretize(tubes).value(), ControlStage::kEnds, {kLeast, kMost});
  ASSERT_FALSE(no);
  EXPECT_EQ(no.error().message, "rod \"" + tubes.rods[2].name + "\" is a tube");
}

}  // namespace
}  // namespace lissom
