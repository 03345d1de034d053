/// Plans under edit: parameters, moves on one mesh, remeshing with the shape carried over.

#include <cmath>
#include <gtest/gtest.h>

#include "lissom/design/carry_over.h"
#include "lissom/design/plan_space.h"
#include "tests/regression/plan_samples.h"

namespace lissom {
namespace {

using samples::fabric_scene;
using samples::open;
using samples::ring_with_rods;

double height(const LiveDesign& design) {
  double low = INFINITY, high = -INFINITY;
  for (int i = 0; i < design.system().layout.nodes(); ++i) {
    const double z = design.equilibrium().state.position(i).z();
    low = std::min(low, z);
    high = std::max(high, z);
  }
  return high - low;
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
      EXPECT_LE(design->equilibrium().factorizations, 5) << k;  // 14 to 24 where rods do not keep their lengths
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
  const auto [carried, strains] = carried_over(stage, state, stage);
  for (int e = 0; e < design->system().edge_count(); ++e) {
    const double strain = state.edges[e].length / design->system().rest.edges[e].length - 1;
    EXPECT_NEAR(strains[e], strain, 1e-12) << e;
  }
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
