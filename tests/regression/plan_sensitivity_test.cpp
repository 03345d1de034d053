/// Exact sensitivities of equilibria of plans against equilibria solved again.

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "lissom/design/plan_space.h"
#include "lissom/design/sensitivity.h"
#include "lissom/equilibrium/newton_workspace.h"
#include "tests/regression/plan_samples.h"

namespace lissom {
namespace {

using samples::fabric_scene;
using samples::open;
using samples::pin;
using samples::ring_with_rods;

/// Displacements without what a rigid motion explains.
VecX without_rigid_motion(const State& state, int nodes, VecX field) {
  MatX rigid = MatX::Zero(3 * nodes, 6);
  for (int i = 0; i < nodes; ++i) {
    for (int k = 0; k < 3; ++k) {
      rigid(3 * i + k, k) = 1;
      rigid.block<3, 1>(3 * i, 3 + k) = Vec3::Unit(k).cross(state.position(i));
    }
  }
  const Eigen::HouseholderQR<MatX> qr(rigid);
  return field - rigid * qr.solve(field);
}

/// A few more Newton steps: a solve ends where forces are rounding, which is not yet where soft shapes stand still.
State polished(const StaticProblem& problem, State state) {
  const Context context;
  NewtonWorkspace workspace(problem, context);
  VecX free, increment;
  State moved;
  for (int k = 0; k < 4; ++k) {
    workspace.assemble(state);
    EXPECT_TRUE(workspace.factorize(0).positive_definite);
    workspace.factor().solve(-workspace.free_gradient(), free);
    workspace.to_increment(free, increment);
    EXPECT_TRUE(advance(*problem.system, state, increment, moved));
    std::swap(state, moved);
  }
  return state;
}

/// Positions of nodes in the equilibrium of another plan on the mesh of `design`, followed from its own.
VecX followed(const LiveDesign& design, const Model& changed, double tolerance) {
  const Result<ExpandedPlan> plan = design.mesh()->moved_to(changed);
  EXPECT_TRUE(plan.ok()) << plan.error().text();
  Result<Structure> structure = discretize(changed, plan.value());
  EXPECT_TRUE(structure.ok()) << structure.error().text();
  const Result<System> system = make_system(changed, std::move(structure).value());
  const Result<StaticProblem> problem = make_static_problem(changed, system.value(), changed.poses[0], "/poses/0");
  EXPECT_TRUE(problem.ok()) << problem.error().text();
  SolveOptions options;
  options.tolerance = tolerance;
  options.modes = 0;
  LiveSolver solver(problem.value(), options);
  const Equilibrium found = solver.resettle(design.equilibrium().state);
  EXPECT_EQ(found.verdict, Verdict::kStable) << found.message;
  return polished(problem.value(), found.state).q.head(3 * system.value().layout.nodes());
}

/// dq/dp of one parameter from equilibria solved again on the same mesh: central differences, extrapolated once.
VecX resolved_sensitivity(const LiveDesign& design, const PlanSpace& space, int parameter, double step,
                          double tolerance) {
  const Model& model = design.model();
  VecX field[2][2];
  for (int level = 0; level < 2; ++level) {
    for (int side = 0; side < 2; ++side) {
      VecX p = space.values(*model.plan);
      p[parameter] += (side == 0 ? -1 : 1) * step / (level + 1);
      const Result<Model> changed = space.model_at(model, p);
      EXPECT_TRUE(changed.ok()) << changed.error().text();
      field[level][side] = followed(design, changed.value(), tolerance);
    }
  }
  return (4 * (field[1][1] - field[1][0]) / step - (field[0][1] - field[0][0]) / (2 * step)) / 3;
}

double step_of(const Parameter& parameter, double value) {
  return parameter.kind == ParameterKind::kRadius     ? 2e-3 * value
         : parameter.kind == ParameterKind::kPosition ? 1e-5
                                                      : 2e-4;
}

/// Compares S with equilibria solved again for the parameters named.
void compare_sensitivities(const Model& model, const PlanSpaceOptions& choice, const std::vector<std::string>& names,
                           bool floats) {
  constexpr double kTight = 1e-10;
  const Result<PlanSpace> space = PlanSpace::make(model, choice);
  ASSERT_TRUE(space.ok()) << space.error().text();
  const std::unique_ptr<LiveDesign> design = open(model, kTight);
  const State state = polished(design->problem(), design->equilibrium().state);
  const Context context;
  NewtonWorkspace workspace(design->problem(), context);
  workspace.assemble(state);
  ASSERT_TRUE(workspace.factorize(0).positive_definite);
  const SparseMatrix inputs = space.value().rest_inputs(model, *design->mesh(), design->system());
  const Result<Sensitivity> made =
      Sensitivity::make(model, model.poses[0], design->problem(), state, workspace.factor(), inputs);
  ASSERT_TRUE(made.ok()) << made.error().text();
  const Sensitivity& sensitivity = made.value();
  const MatX dense = sensitivity.dense();
  const int nodes = design->system().layout.nodes();
  int compared = 0;
  for (int k = 0; k < space.value().size(); ++k) {
    const Parameter& parameter = space.value().parameters()[k];
    if (std::find(names.begin(), names.end(), parameter.name) == names.end()) continue;
    SCOPED_TRACE(parameter.name);
    const double value = space.value().values(*model.plan)[k];
    VecX expected = resolved_sensitivity(*design, space.value(), k, step_of(parameter, value), kTight);
    VecX got = dense.col(k).head(3 * nodes);
    if (floats) {
      expected = without_rigid_motion(state, nodes, expected);
      got = without_rigid_motion(state, nodes, got);
    }
    ASSERT_GT(expected.norm(), 0);
    EXPECT_LT((got - expected).norm(), 1e-5 * expected.norm());
    ++compared;
  }
  EXPECT_EQ(compared, static_cast<int>(names.size()));
  // Forward and adjoint products are those of the same matrix.
  VecX v(space.value().size()), w(dense.rows());
  for (int i = 0; i < v.size(); ++i) v[i] = std::sin(i + 1.0) * space.value().parameters()[i].scale;
  for (int i = 0; i < w.size(); ++i) w[i] = std::cos(2.0 * i);
  EXPECT_LT((sensitivity.forward(v) - dense * v).norm(), 1e-9 * (dense * v).norm());
  const VecX adjoint = sensitivity.adjoint(w), product = dense.transpose() * w;
  EXPECT_LT((adjoint - product).norm(), 1e-9 * product.norm());
}

TEST(PlanSensitivity, SensitivitiesMatchEquilibriaSolvedAgain) {
  PlanSpaceOptions choice;
  choice.pre_stretch = PreStretchChoice::kPerAxis;
  compare_sensitivities(ring_with_rods(), choice,
                        {"point \"n\": r_n", "point \"middle\": r_b", "point \"middle\": x", "point \"s\": y",
                         "point \"free\": x", "pre-stretch along the warp", "pre-stretch across the warp"},
                        true);
}

TEST(PlanSensitivity, WhatIsHeldFollowsTheDrawing) {
  Model model = ring_with_rods();
  model.poses[0].gravity = Gravity{};
  for (const char* point : {"e", "n", "w"}) model.poses[0].supports.push_back(pin(point));
  compare_sensitivities(model, {}, {"point \"e\": x", "point \"n\": y", "point \"middle\": x", "pre-stretch"}, false);
}

TEST(PlanSensitivity, SensitivitiesOfTheButterfly) {
  compare_sensitivities(
      fabric_scene("butterfly"), {},
      {"point \"f2-r\": r_n", "point \"b2-r\": r_b", "point \"a-r\": x", "point \"p1-l\": y", "pre-stretch"}, true);
}

}  // namespace
}  // namespace lissom
