/// Stages of a design: one goes on where another ended, with other parameters and other pins.

#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <utility>

#include "lissom/design/adaptive_pins.h"
#include "lissom/design/design_spaces.h"
#include "lissom/design/network_radii.h"
#include "lissom/design/objective_node_positions.h"
#include "lissom/design/parameters_of.h"
#include "lissom/design/rest_shape.h"
#include "lissom/design/structure_problem.h"
#include "lissom/mechanics/rest_numbers.h"
#include "scenes/parts.h"

namespace lissom {
namespace {

constexpr double kPins = 5;  // N/m

/// A small honeycomb that hangs by two sides, one of them held by soft pins.
std::shared_ptr<const Design> honeycomb(double pins = kPins) {
  const ObjLines lines = hexagon_pattern(0.02, 2, 3);
  auto design = std::make_shared<Design>();
  design->model = scene_models::sheet("honeycomb", lines, 1.8e-3, "TPU 92A", 6);
  Pose pose = scene_models::hanging_pose(lines, 1e-6);
  pose.supports.pop_back();
  Selector far;
  far.kind = Selector::Kind::kBox;
  far.low = Vec3(0.02, -1, -1);
  far.high = Vec3(1, 1, 1);
  pose.soft_pins.push_back({far, pins, Vec3(0.05, 0.01, 0.02)});
  design->model.poses = {pose};
  design->system = make_system(design->model).value();
  return design;
}

SpacePtr radii(const std::shared_ptr<const Design>& base, ControlStage stage) {
  return std::make_shared<LinearSpace>(radii_space(base, stage, {1e-3, 4e-3}).value());
}

VecX uneven(const DesignSpace& space) {
  VecX p = space.start();
  for (int i = 0; i < p.size(); ++i) {
    const Parameter& parameter = space.parameters()[static_cast<std::size_t>(i)];
    p[i] += 0.1 * (parameter.upper - parameter.lower) * std::sin(1.0 + 2.3 * i);
  }
  return p;
}

/// Nodes where they are drawn, and a little up.
Goal lifted(const Structure& structure) {
  const int n = static_cast<int>(structure.nodes.size());
  std::vector<int> nodes(static_cast<std::size_t>(n));
  Goal goal;
  goal.target.resize(3 * n);
  for (int i = 0; i < n; ++i) {
    nodes[static_cast<std::size_t>(i)] = i;
    goal.target.segment<3>(3 * i) = structure.nodes[static_cast<std::size_t>(i)] + Vec3(0, 0, 2e-3);
  }
  goal.name = "positions";
  goal.objective = make_node_positions(nodes);
  goal.weights = VecX::Constant(3 * n, 1.0 / n);
  goal.scale = 1e-3;
  return goal;
}

std::unique_ptr<StructureProblem> problem_of(const std::shared_ptr<const Design>& base) {
  StructureProblemOptions options;
  options.solve.tolerance = 1e-11;
  Result<std::unique_ptr<StructureProblem>> problem =
      StructureProblem::make(radii(base, ControlStage::kEnds), {lifted(base->system.structure)}, {}, options, {});
  EXPECT_TRUE(problem) << problem.error().text();
  return std::move(problem).value();
}

TEST(ParametersOf, FindsTheSameRadiiAtMoreControls) {
  const auto base = honeycomb();
  const SpacePtr coarse = radii(base, ControlStage::kEnds);
  const Design design = coarse->at(uneven(*coarse)).value();
  for (const ControlStage stage : {ControlStage::kMiddle, ControlStage::kThirds}) {
    const SpacePtr fine = radii(base, stage);
    const Result<VecX> p = parameters_of(*fine, design);
    ASSERT_TRUE(p) << p.error().text();
    EXPECT_TRUE(check_bounds(fine->parameters(), p.value()));
    const Design again = fine->at(p.value()).value();
    const VecX a = rest_input_values(design.model, design.system), b = rest_input_values(again.model, again.system);
    EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-12 * a.cwiseAbs().maxCoeff());
    for (int e = 0; e < static_cast<int>(base->system.structure.edges.size()); ++e) {
      const RestInputs at(base->system.structure);
      EXPECT_NEAR(a[at.extent_n(e)], b[at.extent_n(e)], 1e-11);
    }
  }
}

TEST(ParametersOf, KeepsWhatOthersChangedWhenMoreKindsFollow) {
  const auto base = honeycomb();
  const SpacePtr first = radii(base, ControlStage::kEnds);
  const VecX p_first = uneven(*first);
  const auto shape = std::make_shared<LinearSpace>(
      rest_shape_space(base, {ControlStage::kEnds, 5e-3, RestShapeGauge::kFixSix}).value());
  const SumSpace both = SumSpace::make({radii(base, ControlStage::kEnds), shape}).value();
  const Result<VecX> p = parameters_of(both, first->at(p_first).value());
  ASSERT_TRUE(p) << p.error().text();
  EXPECT_LT((p.value().head(first->size()) - p_first).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT(p.value().tail(shape->size()).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(ParametersOf, PutsOnTheirBoundsWhatWouldBeOutside) {
  const auto base = honeycomb();
  const SpacePtr coarse = radii(base, ControlStage::kMiddle), fine = radii(base, ControlStage::kThirds);
  VecX p = coarse->start();
  // Thin at one end and in the middle, thick at the other: a parabola that dips below its bound between two controls.
  for (int i = 0; i < p.size(); ++i) p[i] = i % 2 == 0 ? 1e-3 : 3.9e-3;
  const Result<VecX> found = parameters_of(*fine, coarse->at(p).value());
  ASSERT_TRUE(found) << found.error().text();
  EXPECT_TRUE(check_bounds(fine->parameters(), found.value()));
  int at_bounds = 0;
  for (int i = 0; i < found.value().size(); ++i) {
    const Parameter& parameter = fine->parameters()[static_cast<std::size_t>(i)];
    at_bounds += found.value()[i] == parameter.lower || found.value()[i] == parameter.upper;
  }
  EXPECT_GT(at_bounds, 0);
}

TEST(ParametersOf, RefusesADesignThatTheSpaceDoesNotHave) {
  const auto base = honeycomb();
  const SpacePtr fine = radii(base, ControlStage::kThirds), coarse = radii(base, ControlStage::kEnds);
  const Result<VecX> p = parameters_of(*coarse, fine->at(uneven(*fine)).value());
  ASSERT_FALSE(p);
  EXPECT_EQ(p.error().code, ErrorCode::kConflict);
  EXPECT_NE(p.error().message.find("nearest"), std::string::npos) << p.error().text();
}

TEST(SoftPins, ChangeAsIfTheyHadBeenDescribedSo) {
  const auto problem = problem_of(honeycomb());
  ASSERT_TRUE(problem->release());
  const double before = problem->value();
  ASSERT_TRUE(problem->stiffen_pins(VecX::Constant(1, 0.6)).value());
  const auto described = problem_of(honeycomb(0.6 * kPins));
  ASSERT_TRUE(described->release());
  EXPECT_NE(problem->value(), before);
  EXPECT_NEAR(problem->value(), described->value(), 1e-8 * before);
  EXPECT_LT((problem->gradient() - described->gradient()).norm(), 1e-6 * described->gradient().norm());
  EXPECT_NEAR(problem->design().model.poses[0].soft_pins[0].stiffness, 0.6 * kPins, 1e-12);
}

/// Pins that are softened where they drag nodes away from their goal are better; stiffened ones are not taken.
TEST(SoftPins, ChangeOnlyForTheBetter) {
  const auto problem = problem_of(honeycomb());
  ASSERT_TRUE(problem->release());
  const double before = problem->value();
  const VecX residual = problem->residual();
  const VecX half = VecX::Constant(1, 0.5), twice = VecX::Constant(1, 2.0);
  const bool stiffer = problem->stiffen_pins(twice).value();
  if (!stiffer) {
    EXPECT_EQ(problem->value(), before);
    EXPECT_EQ(problem->residual(), residual);
  }
  const double between = problem->value();
  EXPECT_LE(between, before);
  const bool softer = problem->stiffen_pins(half).value();
  EXPECT_LE(problem->value(), between);
  EXPECT_NE(stiffer, softer);
}

TEST(SoftPins, AreAPartOfASavedPoint) {
  const auto base = honeycomb();
  const auto problem = problem_of(base), other = problem_of(base);
  ASSERT_TRUE(problem->release());
  ASSERT_TRUE(problem->stiffen_pins(VecX::Constant(1, 0.6)).value());
  const DesignPoint point = problem->point();
  ASSERT_TRUE(other->restore(point));
  EXPECT_EQ(other->value(), problem->value());
  EXPECT_EQ(other->residual(), problem->residual());
  DesignPoint broken = point;
  broken.pin_factors.resize(0);
  EXPECT_FALSE(other->restore(broken));
}

TEST(SoftPins, AdaptToWhatGoalsMiss) {
  const auto base = honeycomb();
  const auto problem = problem_of(base);
  ASSERT_TRUE(problem->release());
  BriefGoals goals;
  goals.goals = problem->goals();
  goals.nodes.emplace_back();
  for (int i = 0; i < static_cast<int>(base->system.structure.nodes.size()); ++i) goals.nodes[0].push_back(i);
  const Result<VecX> change = pin_changes(*problem, goals);
  ASSERT_TRUE(change) << change.error().text();
  // By hand, from the shape.
  double pinned = 0, others = 0;
  int pins = 0, rest = 0;
  for (int i = 0; i < static_cast<int>(base->system.structure.nodes.size()); ++i) {
    const Vec3 drawn = base->system.structure.nodes[static_cast<std::size_t>(i)];
    const Vec3 x = problem->poses()[0]->state().position(i);
    if (drawn.x() >= 0.02) {
      pinned += (x - Vec3(0.05, 0.01, 0.02)).squaredNorm(), ++pins;
    } else {
      others += (x - drawn - Vec3(0, 0, 2e-3)).squaredNorm(), ++rest;
    }
  }
  const double ratio = std::sqrt(pinned / pins / (others / rest));
  EXPECT_NEAR(change.value()[0], std::clamp(ratio, 0.5, 2.0), 1e-12);
  // A goal that misses more than the pins softens them, but never by more than half.
  Goal far = goals.goals[0];
  far.target.array() += 1;
  goals.goals[0] = far;
  EXPECT_EQ(pin_changes(*problem, goals).value()[0], 0.5);
  goals.goals.clear();
  goals.nodes.clear();
  EXPECT_EQ(pin_changes(*problem, goals).value()[0], 1);
}

}  // namespace
}  // namespace lissom
