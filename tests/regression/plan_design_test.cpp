/// Plans under edit: sensitivities of their equilibria, moves on one mesh, remeshing with the shape carried over.

#include <Eigen/QR>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <numbers>
#include <utility>

#include "lissom/core/file_io.h"
#include "lissom/design/carry_over.h"
#include "lissom/design/live_design.h"
#include "lissom/design/plan_space.h"
#include "lissom/design/sensitivity.h"
#include "lissom/equilibrium/newton_workspace.h"
#include "lissom/model/document.h"

namespace lissom {
namespace {

constexpr double kPi = std::numbers::pi;

/// A ring on fabric with a spline across, one straight rod, and a short free one.
Model ring_with_rods(double edge_length = 5e-3) {
  Model model;
  Plan& plan = model.plan.emplace();
  plan.material = "PLA";
  plan.edge_length = edge_length;
  plan.fabric.material = "soft knit";
  plan.fabric.pre_stretch = {1.35, 1.3};
  const auto point = [&](const char* name, double radius, double degrees, double r_n, double r_b) {
    const double angle = degrees * kPi / 180;
    plan.points.push_back({name, Vec2(radius * std::cos(angle), radius * std::sin(angle)), r_n, r_b, false});
    return static_cast<int>(plan.points.size()) - 1;
  };
  std::vector<int> ring;
  for (const auto& [name, angle] : {std::pair("e", 0), std::pair("n", 85), std::pair("w", 170), std::pair("s", 260)}) {
    ring.push_back(point(name, 0.05, angle, 3e-4, 4.5e-4));
  }
  const int middle = point("middle", 0.012, 30, 2.5e-4, 4e-4), free = point("free", 0.03, 210, 3e-4, 3e-4);
  plan.rods.push_back({"ring", ring, PlanCurve::kSpline, PlanRole::kRod, true});
  plan.rods.push_back({"across", {ring[0], middle, ring[2]}, PlanCurve::kSpline, PlanRole::kRod, false});
  plan.rods.push_back({"stub", {middle, free}, PlanCurve::kStraight, PlanRole::kRod, false});
  Pose pose;
  pose.name = "released";
  model.poses.push_back(pose);
  return model;
}

Model fabric_scene(const std::string& name) {
  const Result<std::string> text = read_file("scenes/data/fabric/" + name + ".lissom");
  EXPECT_TRUE(text.ok()) << text.error().text();
  Result<Model> model = read_document(text.value());
  EXPECT_TRUE(model.ok()) << model.error().text();
  return std::move(model).value();
}

Support pin(const char* point) {
  Support support;
  support.kind = SupportKind::kPin;
  support.at.kind = Selector::Kind::kPlanPoint;
  support.at.name = point;
  return support;
}

std::unique_ptr<LiveDesign> open(const Model& model, double tolerance = 1e-6) {
  LiveDesign::Options options;
  options.solve.tolerance = tolerance;
  options.solve.modes = 0;
  Result<std::unique_ptr<LiveDesign>> made = LiveDesign::make(model, 0, options);
  EXPECT_TRUE(made.ok()) << made.error().text();
  EXPECT_EQ(made.value()->equilibrium().verdict, Verdict::kStable) << made.value()->equilibrium().message;
  return std::move(made).value();
}

double height(const LiveDesign& design) {
  double low = INFINITY, high = -INFINITY;
  for (int i = 0; i < design.system().layout.nodes(); ++i) {
    const double z = design.equilibrium().state.position(i).z();
    low = std::min(low, z);
    high = std::max(high, z);
  }
  return high - low;
}

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
  const Result<ExpandedPlan> plan = design.mesh().moved_to(changed);
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
  const SparseMatrix inputs = space.value().rest_inputs(model, design->mesh(), design->system());
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

TEST(PlanDesign, SensitivitiesMatchEquilibriaSolvedAgain) {
  PlanSpaceOptions choice;
  choice.pre_stretch = PreStretchChoice::kPerAxis;
  compare_sensitivities(ring_with_rods(), choice,
                        {"point \"n\": r_n", "point \"middle\": r_b", "point \"middle\": x", "point \"s\": y",
                         "point \"free\": x", "pre-stretch along the warp", "pre-stretch across the warp"},
                        true);
}

TEST(PlanDesign, WhatIsHeldFollowsTheDrawing) {
  Model model = ring_with_rods();
  model.poses[0].gravity = Gravity{};
  for (const char* point : {"e", "n", "w"}) model.poses[0].supports.push_back(pin(point));
  compare_sensitivities(model, {}, {"point \"e\": x", "point \"n\": y", "point \"middle\": x", "pre-stretch"}, false);
}

TEST(PlanDesign, SensitivitiesOfTheButterfly) {
  const Result<std::string> text = read_file("scenes/data/fabric/butterfly.lissom");
  ASSERT_TRUE(text.ok()) << text.error().text();
  const Result<Model> model = read_document(text.value());
  ASSERT_TRUE(model.ok()) << model.error().text();
  compare_sensitivities(
      model.value(), {},
      {"point \"f2-r\": r_n", "point \"b2-r\": r_b", "point \"a-r\": x", "point \"p1-l\": y", "pre-stretch"}, true);
}

TEST(PlanDesign, ParametersHaveNamesAndBounds) {
  const Model model = ring_with_rods();
  PlanSpaceOptions choice;
  choice.points = {"middle"};
  const Result<PlanSpace> made = PlanSpace::make(model, choice);
  ASSERT_TRUE(made.ok()) << made.error().text();
  const PlanSpace& space = made.value();
  ASSERT_EQ(space.size(), 5);
  const char* names[] = {"point \"middle\": r_n", "point \"middle\": r_b", "point \"middle\": x", "point \"middle\": y",
                         "pre-stretch"};
  VecX p = space.values(*model.plan);
  for (int k = 0; k < space.size(); ++k) {
    EXPECT_EQ(space.parameters()[k].name, names[k]);
    EXPECT_LE(space.parameters()[k].lower, p[k]);
    EXPECT_GE(space.parameters()[k].upper, p[k]);
    EXPECT_GT(space.parameters()[k].scale, 0);
  }
  p[4] = 1.45;
  const Result<Model> changed = space.model_at(model, p);
  ASSERT_TRUE(changed.ok());
  EXPECT_DOUBLE_EQ(changed.value().plan->fabric.pre_stretch[0], 1.45);
  EXPECT_DOUBLE_EQ(changed.value().plan->fabric.pre_stretch[1], 1.3 * 1.45 / 1.35);
  p[0] = -1e-4;
  const Result<Model> refused = space.model_at(model, p);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().text().find("point \"middle\": r_n"), std::string::npos);
  choice.points = {"midle"};
  EXPECT_NE(PlanSpace::make(model, choice).error().text().find("middle"), std::string::npos);
  choice.points = {};
  choice.radius_range = {2e-3, 1e-3};
  EXPECT_FALSE(PlanSpace::make(model, choice).ok());
}

/// A control point dragged a long way: the mesh is made anew when it must be, and the shape does not jump there.
TEST(PlanDesign, ADraggedPointIsFollowedAcrossRemeshing) {
  Model crossed = fabric_scene("disc-crossed");
  crossed.plan->edge_length = 3e-3;
  const std::unique_ptr<LiveDesign> design = open(crossed);
  const Vec2 step(-0.75e-3, 0.4e-3);
  int remeshed = 0;
  double before = height(*design);
  for (int k = 0; k < 60; ++k) {
    Model model = design->model();
    model.plan->points.back().at += step;
    const Result<DesignChange> change = design->change(model);
    ASSERT_TRUE(change.ok()) << k << ": " << change.error().text();
    ASSERT_EQ(design->equilibrium().verdict, Verdict::kStable) << k << ": " << design->equilibrium().message;
    EXPECT_FALSE(change.value().following.jumped) << k;
    if (change.value().remeshed) {
      ++remeshed;
      EXPECT_FALSE(change.value().reason.empty());
      EXPECT_NEAR(height(*design), before, 0.02 * before) << k;
    } else {
      EXPECT_LE(design->equilibrium().factorizations, 2) << k;
    }
    before = height(*design);
  }
  EXPECT_GE(remeshed, 1);
  EXPECT_LE(remeshed, 12);
  const std::unique_ptr<LiveDesign> fresh = open(design->model());
  EXPECT_NEAR(fresh->equilibrium().energy, design->equilibrium().energy, 0.01 * fresh->equilibrium().energy);
}

TEST(PlanDesign, RodsMayComeAndGo) {
  const std::unique_ptr<LiveDesign> design = open(ring_with_rods());
  Model model = design->model();
  Plan& plan = *model.plan;
  plan.rods.push_back({"chord", {1, 4, 3}, PlanCurve::kSpline, PlanRole::kRod, false});
  Result<DesignChange> change = design->change(model);
  ASSERT_TRUE(change.ok()) << change.error().text();
  EXPECT_TRUE(change.value().remeshed);
  EXPECT_EQ(design->equilibrium().verdict, Verdict::kStable) << design->equilibrium().message;
  model.plan->rods.pop_back();
  change = design->change(model);
  ASSERT_TRUE(change.ok());
  EXPECT_EQ(design->equilibrium().verdict, Verdict::kStable);
}

/// A change that cannot be built leaves everything as it was.
TEST(PlanDesign, ImpossibleChangesAreRefused) {
  const std::unique_ptr<LiveDesign> design = open(ring_with_rods());
  const VecX before = design->equilibrium().state.q;
  Model model = design->model();
  model.plan->points[4].at = {0.2, 0};  // outside of the ring
  EXPECT_FALSE(design->change(model).ok());
  model = design->model();
  model.plan->points[4].at.x() = NAN;
  EXPECT_FALSE(design->change(model).ok());
  model = design->model();
  model.plan.reset();
  EXPECT_FALSE(design->change(model).ok());
  EXPECT_EQ(design->equilibrium().state.q, before);
  model = design->model();
  model.plan->points[4].at.x() += 1e-3;
  EXPECT_TRUE(design->change(model).ok());
  EXPECT_EQ(design->equilibrium().verdict, Verdict::kStable);
}

/// On the same mesh nothing is lost on the way.
TEST(PlanDesign, AShapeCarriedToItsOwnMeshIsTheSame) {
  const std::unique_ptr<LiveDesign> design = open(ring_with_rods());
  const Result<ExpandedPlan> plan = expand_plan(design->model());
  ASSERT_TRUE(plan.ok());
  const PlanStage stage{*design->model().plan, plan.value(), design->system()};
  const State& state = design->equilibrium().state;
  const State carried = carried_over(stage, state, stage);
  EXPECT_LT((carried.q - state.q).head(3 * design->system().layout.nodes()).cwiseAbs().maxCoeff(), 1e-9);
  AssemblyBuffers buffers;
  const double energy = design->problem().potential.value(state, buffers);
  EXPECT_NEAR(design->problem().potential.value(carried, buffers), energy, 1e-6 * energy);
}

TEST(PlanDesign, JumpsAreSaid) {
  const std::unique_ptr<LiveDesign> design = open(ring_with_rods());
  Model model = design->model();
  for (PlanPoint& point : model.plan->points) point.r_n *= 1.01;
  Result<DesignChange> change = design->change(model);
  ASSERT_TRUE(change.ok());
  EXPECT_FALSE(change.value().following.jumped);
  EXPECT_GT(change.value().following.predicted, 0);
  // Rods so stiff that the sheet becomes plane, all at once: far from any prediction.
  for (PlanPoint& point : model.plan->points) {
    point.r_n *= 4;
    point.r_b *= 4;
  }
  change = design->change(model);
  ASSERT_TRUE(change.ok());
  EXPECT_EQ(design->equilibrium().verdict, Verdict::kStable) << design->equilibrium().message;
  EXPECT_LT(height(*design), 1e-3);
}

}  // namespace
}  // namespace lissom
