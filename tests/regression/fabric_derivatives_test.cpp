/// Inverse problems of fabric: exact derivatives of first and second order of a clamped sheet and of the butterfly.

#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <utility>
#include <vector>

#include "lissom/design/objective_angle.h"
#include "lissom/design/objective_membrane_area.h"
#include "lissom/design/objective_node_positions.h"
#include "lissom/design/objective_strain_energy.h"
#include "lissom/design/plan_design_space.h"
#include "lissom/design/stiffness_spaces.h"
#include "scenes/parts.h"
#include "tests/regression/exact_derivatives.h"
#include "tests/regression/plan_samples.h"

namespace lissom {
namespace {

VecX direction(int size) {
  VecX v(size);
  for (int i = 0; i < size; ++i) v[i] = std::cos(0.7 + 1.9 * i);
  return v / v.norm();
}

Goal goal_of(std::shared_ptr<const Objective> objective, VecX target, double scale) {
  Goal goal;
  goal.name = "goal";
  goal.weights = VecX::Constant(objective->size(), 1.0 / objective->size());
  goal.objective = std::move(objective);
  goal.target = std::move(target);
  goal.scale = scale;
  return goal;
}

/// A square of taut fabric clamped all around, with a load in its middle and its own weight.
Model clamped_sheet() {
  Model model;
  model.membrane_materials.push_back({"knit", 40, 25, 0.3, 0.4e-3, 0.2, "made up"});
  Membrane sheet;
  sheet.name = "sheet";
  sheet.material = "knit";
  sheet.pre_stretch = {1.15, 1.1};
  sheet.warp_angle = 0.4;
  sheet.shape = MembraneGrid{Vec2(-0.05, -0.05), Vec2(0.1, 0.1), 8, 8};
  model.membranes.push_back(sheet);
  Pose pose;
  pose.name = "loaded";
  Selector rim;
  rim.kind = Selector::Kind::kRim;
  rim.name = "sheet";
  pose.supports.push_back(scene_models::hold(rim, SupportKind::kPin));
  PointForce load;
  load.at.kind = Selector::Kind::kPoint;
  load.at.point = Vec3(0.0125, 0, 0);
  load.force = Vec3(0.02, 0.01, -0.15);
  pose.forces.push_back(load);
  pose.gravity = Gravity{};
  model.poses.push_back(pose);
  return model;
}

TEST(FabricDerivatives, OfAClampedSheet) {
  auto base = std::make_shared<Design>();
  base->model = clamped_sheet();
  base->system = make_system(base->model).value();
  using Property = SheetProperty;
  Result<LinearSpace> space = fabric_space(base, {{Property::kStiffness1, Vec2(10, 100)},
                                                  {Property::kStiffness2, Vec2(10, 100)},
                                                  {Property::kPoissonRatio, Vec2(0, 0.45)},
                                                  {Property::kThickness, Vec2(1e-4, 1e-3)},
                                                  {Property::kPreStretch, Vec2(1.05, 1.5)}});
  ASSERT_TRUE(space) << space.error().text();
  const int n = static_cast<int>(base->system.structure.nodes.size());
  std::vector<int> nodes(static_cast<std::size_t>(n));
  VecX target(3 * n);
  for (int i = 0; i < n; ++i) {
    nodes[static_cast<std::size_t>(i)] = i;
    const Vec3& x = base->system.structure.nodes[static_cast<std::size_t>(i)];
    target.segment<3>(3 * i) = x + 1e-3 * Vec3(std::sin(i), std::cos(2 * i), -2 + std::sin(1.0 + i));
  }
  StructureProblemOptions options;
  options.solve.tolerance = 1e-12;
  Result<std::unique_ptr<StructureProblem>> problem =
      StructureProblem::make(std::make_shared<LinearSpace>(std::move(space).value()),
                             {goal_of(make_node_positions(nodes), target, 1e-3)}, {}, options, {});
  ASSERT_TRUE(problem) << problem.error().text();
  const Status released = problem.value()->release();
  ASSERT_TRUE(released) << released.error().text();
  expect_exact_derivatives(*problem.value(), direction(problem.value()->size()), 4e-2);
}

/// Free in space, so that goals are of what a rigid motion does not change.
TEST(FabricDerivatives, OfTheButterfly) {
  PlanSpaceOptions options;
  Result<PlanDesignSpace> space = PlanDesignSpace::make(samples::fabric_scene("butterfly"), options);
  ASSERT_TRUE(space) << space.error().text();
  const auto shared = std::make_shared<const PlanDesignSpace>(std::move(space).value());
  const std::array<int, 4> nodes{0, 300, 700, 1500};
  StructureProblemOptions solve;
  solve.solve.tolerance = 1e-12;
  ThreadPool threads(2);
  Context context;
  context.threads = &threads;
  Result<std::unique_ptr<StructureProblem>> problem =
      StructureProblem::make(shared,
                             {goal_of(make_membrane_area(), VecX::Constant(1, 0.01), 1e-3),
                              goal_of(make_strain_energy(), VecX::Constant(1, 0.05), 1e-2),
                              goal_of(make_angle(nodes), VecX::Constant(1, 0.2), 0.1)},
                             {}, solve, context);
  ASSERT_TRUE(problem) << problem.error().text();
  const Status released = problem.value()->release();
  ASSERT_TRUE(released) << released.error().text();
  EXPECT_GT(problem.value()->size(), 100);
  expect_exact_derivatives(*problem.value(), direction(problem.value()->size()), 4e-2);
}

}  // namespace
}  // namespace lissom
