#pragma once
/// A small network of rods with joints in two poses, with radii to be sought, for tests of inverse problems.

#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lissom/design/network_radii.h"
#include "lissom/design/objective_node_positions.h"
#include "lissom/design/structure_problem.h"
#include "scenes/parts.h"

namespace lissom::samples {

/// A small honeycomb that hangs by two sides in one pose and is pulled by soft pins and a force in another.
inline Model honeycomb(JointKind joints) {
  const ObjLines lines = hexagon_pattern(0.02, 2, 3);
  Model model = scene_models::sheet("honeycomb", lines, 1.8e-3, "TPU 92A", 6);
  model.joint_kind = joints;
  model.poses.push_back(scene_models::hanging_pose(lines, 1e-6));
  Pose pulled = model.poses[0];
  pulled.name = "pulled";
  pulled.supports.pop_back();
  pulled.gravity->acceleration = Vec3(1, 2, -6);
  Selector far;
  far.kind = Selector::Kind::kBox;
  far.low = Vec3(0.02, -1, -1);
  far.high = Vec3(1, 1, 1);
  pulled.soft_pins.push_back({far, 0.3, Vec3(0.05, 0.01, 0.02)});
  model.poses.push_back(pulled);
  return model;
}

/// All nodes of a pose towards places off those at the start, more so with every node.
inline Goal far_goal(const Structure& structure, int pose) {
  const int n = static_cast<int>(structure.nodes.size());
  std::vector<int> nodes(n);
  Goal goal;
  goal.target.resize(3 * n);
  for (int i = 0; i < n; ++i) {
    nodes[i] = i;
    goal.target.segment<3>(3 * i) = structure.nodes[i] + 2e-3 * Vec3(std::sin(i), std::cos(2 * i), std::sin(1.0 + i));
  }
  goal.name = "pose " + std::to_string(pose);
  goal.pose = pose;
  goal.objective = make_node_positions(nodes);
  goal.weights = VecX::Constant(3 * n, 1.0 / n);
  goal.scale = 1e-3;
  goal.weight = 1 + pose;
  return goal;
}

/// Radii with three controls per rod, towards `far_goal` in both poses and a little towards thin rods; not solved yet.
inline std::unique_ptr<StructureProblem> honeycomb_problem(const Model& model, ThreadPool* threads = nullptr) {
  auto base = std::make_shared<Design>();
  base->model = model;
  base->system = make_system(model).value();
  Result<LinearSpace> space = radii_space(base, ControlStage::kMiddle, {1e-3, 4e-3});
  EXPECT_TRUE(space) << space.error().text();
  const int m = space.value().size();
  ParameterGoal wish;
  wish.name = "few changes";
  wish.rows.resize(m, m);
  wish.rows.setIdentity();
  wish.rows *= 1e3;
  wish.target = VecX::Constant(m, 1.5e-3);
  wish.weight = 0.01;
  StructureProblemOptions options;
  options.solve.tolerance = 1e-11;
  Context context;
  context.threads = threads;
  Result<std::unique_ptr<StructureProblem>> problem = StructureProblem::make(
      std::make_shared<LinearSpace>(std::move(space).value()),
      {far_goal(base->system.structure, 0), far_goal(base->system.structure, 1)}, {wish}, options, context);
  EXPECT_TRUE(problem) << problem.error().text();
  return std::move(problem).value();
}

}  // namespace lissom::samples
