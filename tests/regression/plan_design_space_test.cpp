/// A plan and its mesh as a design space, alone and with moduli beside it.

#include "lissom/design/plan_design_space.h"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>

#include "lissom/design/design_spaces.h"
#include "lissom/design/stiffness_spaces.h"
#include "tests/regression/design_samples.h"
#include "tests/regression/plan_samples.h"

namespace lissom {
namespace {

using samples::design_at;
using samples::expect_sensitivities;
using samples::made;

/// A ring of two arcs with an arc and a straight rod across, held at three points under its own weight.
Model arcs() {
  Model model;
  Plan& plan = model.plan.emplace();
  plan.material = "PLA";
  plan.edge_length = 8e-3;
  plan.fabric.material = "soft knit";
  plan.fabric.pre_stretch = {1.3, 1.25};
  plan.points = {{"e", {0.05, 0}, 4e-4, 5e-4, false},
                 {"n", {0.002, 0.05}, 3e-4, 4e-4, false},
                 {"w", {-0.05, 0}, 4e-4, 5e-4, false},
                 {"s", {0, -0.048}, 3e-4, 5e-4, false},
                 {"m", {0.004, 0.012}, 3e-4, 3e-4, false}};
  plan.rods.push_back({"upper", {0, 1, 2}, PlanCurve::kArc, PlanRole::kRod, false});
  plan.rods.push_back({"lower", {2, 3, 0}, PlanCurve::kArc, PlanRole::kRod, false});
  plan.rods.push_back({"bow", {0, 4, 2}, PlanCurve::kArc, PlanRole::kRod, false});
  plan.rods.push_back({"strut", {4, 3}, PlanCurve::kStraight, PlanRole::kRod, false});
  Pose pose;
  pose.name = "released";
  pose.gravity = Gravity{};
  for (const char* point : {"e", "n", "w"}) pose.supports.push_back(samples::pin(point));
  model.poses.push_back(pose);
  return model;
}

/// The triangles of a design are those of its mesh, which nobody would get from the description: all but those are compared.
void expect_consistent_on_mesh(const PlanDesignSpace& space, const Design& design) {
  const VecX numbers = rest_number_values(design.system);
  samples::expect_same_numbers(
      design.system.structure,
      rest_numbers_of(design.model, design.system, rest_input_values(design.model, design.system)), numbers, 1e-12);
  const Result<ExpandedPlan> plan = space.mesh()->moved_to(design.model);
  ASSERT_TRUE(plan);
  const Result<Structure> structure = discretize(design.model, plan.value());
  ASSERT_TRUE(structure);
  const Result<System> again = make_system(design.model, structure.value());
  ASSERT_TRUE(again);
  samples::expect_same_numbers(design.system.structure, rest_number_values(again.value()), numbers, 1e-13);
}

TEST(PlanDesignSpace, StartsAsDrawnAndFollowsItsParameters) {
  PlanSpaceOptions options;
  options.pre_stretch = PreStretchChoice::kPerAxis;
  const PlanDesignSpace space = made(PlanDesignSpace::make(arcs(), options));
  const Design start = design_at(space, space.start());
  samples::expect_same_numbers(start.system.structure, rest_number_values(start.system),
                               rest_number_values(space.base()->system), 1e-12);
  VecX p = space.start();
  for (int i = 0; i < p.size(); ++i)
    p[i] += 0.3 * space.parameters()[static_cast<std::size_t>(i)].scale * std::sin(1.0 + i);
  expect_consistent_on_mesh(space, design_at(space, p));
  samples::expect_input_jacobian(space, p, 1e-7);
}

TEST(PlanDesignSpace, CurvatureIsTheChangeOfTheJacobian) {
  const PlanDesignSpace space = made(PlanDesignSpace::make(arcs(), {}));
  const VecX p = space.start();
  const Design design = design_at(space, p);
  VecX v(p.size()), y(RestInputs(design.system.structure).size());
  for (int i = 0; i < v.size(); ++i)
    v[i] = space.parameters()[static_cast<std::size_t>(i)].scale * std::sin(2.0 * i + 1);
  for (int i = 0; i < y.size(); ++i) y[i] = std::cos(1.3 * i);
  const VecX exact = space.curvature(design, p, y, v);
  VecX field[2];
  for (int level = 0; level < 2; ++level) {
    const double h = 0.1 / (level + 1);
    VecX sides[2];
    for (int side = 0; side < 2; ++side) {
      const VecX q = p + (side == 0 ? -h : h) * v;
      sides[side] = space.jacobian(design_at(space, q), q).inputs.transpose() * y;
    }
    field[level] = (sides[1] - sides[0]) / (2 * h);
  }
  const VecX expected = (4 * field[1] - field[0]) / 3;
  ASSERT_GT(expected.norm(), 0);
  EXPECT_LT((exact - expected).norm(), 1e-7 * expected.norm());
  // Without arcs there is none.
  const PlanDesignSpace splines = made(PlanDesignSpace::make(samples::ring_with_rods(8e-3), {}));
  const Design ring = design_at(splines, splines.start());
  EXPECT_TRUE(splines
                  .curvature(ring, splines.start(), VecX::Ones(RestInputs(ring.system.structure).size()),
                             VecX::Ones(splines.size()))
                  .isZero(0));
}

TEST(PlanDesignSpace, SensitivitiesBesideModuli) {
  const auto plan = std::make_shared<const PlanDesignSpace>(made(PlanDesignSpace::make(arcs(), {})));
  const auto moduli = std::make_shared<const LinearSpace>(
      made(youngs_modulus_space(plan->base(), ModulusChoice::kPerMaterial, {1e9, 5e9})));
  const auto fabric = std::make_shared<const LinearSpace>(
      made(fabric_space(plan->base(), {{SheetProperty::kPoissonRatio, {0.05, 0.6}}})));
  const SumSpace space = made(SumSpace::make({plan, moduli, fabric}));
  const VecX p = space.start();
  std::vector<int> chosen;
  for (int i = 0; i < space.size(); ++i) {
    const std::string& name = space.parameters()[static_cast<std::size_t>(i)].name;
    if (name == "point \"n\": x" || name == "point \"m\": y" || name == "point \"e\": r_n" || name == "pre-stretch") {
      chosen.push_back(i);
    }
  }
  ASSERT_EQ(chosen.size(), 4u);
  chosen.push_back(space.size() - 2);
  chosen.push_back(space.size() - 1);
  expect_sensitivities(space, p, 0, chosen, 0.02);
  // Fabric numbers are those of the plan, too.
  const auto stretch =
      std::make_shared<const LinearSpace>(made(fabric_space(plan->base(), {{SheetProperty::kPreStretch, {1.1, 1.6}}})));
  const Result<SumSpace> twice = SumSpace::make({plan, stretch});
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().code, ErrorCode::kConflict);
}

TEST(PlanDesignSpace, PlansThatDoNotFitTheMeshAreRefused) {
  PlanSpaceOptions options;
  options.reach = 2;
  const PlanDesignSpace space = made(PlanDesignSpace::make(samples::ring_with_rods(8e-3), options));
  VecX p = space.start();
  int moved = 0;
  for (int i = 0; i < space.size(); ++i) {
    if (space.parameters()[static_cast<std::size_t>(i)].name != "point \"middle\": y") continue;
    p[i] += 0.08;
    ++moved;
  }
  ASSERT_EQ(moved, 1);
  const Result<Design> design = space.at(p);
  ASSERT_FALSE(design);
  EXPECT_EQ(design.error().code, ErrorCode::kConflict);
  EXPECT_EQ(design.error().message, "the mesh does not fit this plan: a triangle would turn over");
  EXPECT_FALSE(design.error().hint.empty());
}

}  // namespace
}  // namespace lissom
