/// Inverse problems of structures: derivatives over several poses against equilibria solved again, and points that are taken up
/// again to the last bit.

#include "lissom/design/structure_problem.h"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <utility>

#include "lissom/design/network_radii.h"
#include "lissom/design/objective_node_positions.h"
#include "scenes/parts.h"
#include "tests/regression/exact_derivatives.h"

namespace lissom {
namespace {

/// A small honeycomb that hangs by two sides in one pose and is pulled by soft pins and a force in another.
Model honeycomb(JointKind joints) {
  const ObjLines lines = scene_models::hexagons(0.02, 2, 3);
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
Goal far_goal(const Structure& structure, int pose) {
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

std::unique_ptr<StructureProblem> problem_of(const Model& model, ThreadPool* threads = nullptr) {
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

/// Moves the point to uneven parameters.
void go_uneven(StructureProblem& problem) {
  VecX x = problem.x();
  for (int i = 0; i < x.size(); ++i) x[i] += 0.3 * std::sin(1.0 + 2.3 * i);
  const Attempt attempt = problem.attempt(x);
  ASSERT_EQ(attempt.outcome, Outcome::kSettled) << attempt.reason;
  problem.accept();
}

VecX direction(int size) {
  VecX v(size);
  for (int i = 0; i < size; ++i) v[i] = std::cos(0.7 + 1.9 * i);
  return v / v.norm();
}

void expect_derivatives(JointKind joints) {
  const std::unique_ptr<StructureProblem> problem = problem_of(honeycomb(joints));
  const Status released = problem->release();
  ASSERT_TRUE(released) << released.error().text();
  go_uneven(*problem);
  expect_exact_derivatives(*problem, direction(problem->size()), 4e-2);
}

TEST(StructureProblem, DerivativesWithExplicitJoints) { expect_derivatives(JointKind::kExplicit); }
TEST(StructureProblem, DerivativesWithCorotationalJoints) { expect_derivatives(JointKind::kCorotational); }

/// A fixed walk over the parameters.
std::vector<double> walk(StructureProblem& problem, int from, int to) {
  std::vector<double> values;
  for (int k = from; k < to; ++k) {
    VecX x = problem.x();
    for (int i = 0; i < x.size(); ++i) x[i] += 0.1 * std::sin(1.0 + 1.3 * i + 2.1 * k);
    // An attempt that is not accepted leaves no trace.
    EXPECT_EQ(problem.attempt(x + 0.05 * direction(problem.size())).outcome, Outcome::kSettled);
    const VecX tried = problem.jacobian_transposed_times(problem.attempted_residual());
    EXPECT_EQ(problem.attempt(x).outcome, Outcome::kSettled);
    problem.accept();
    values.push_back(problem.value());
    values.push_back(problem.gradient().sum());
    values.push_back(tried.sum());
  }
  return values;
}

TEST(StructureProblem, GoesOnFromASavedPointToTheLastBit) {
  const Model model = honeycomb(JointKind::kExplicit);
  const std::unique_ptr<StructureProblem> whole = problem_of(model);
  ASSERT_TRUE(whole->release());
  walk(*whole, 0, 2);
  const DesignPoint point = whole->point();
  const std::vector<double> expected = walk(*whole, 2, 4);
  const std::unique_ptr<StructureProblem> resumed = problem_of(model);
  const Status restored = resumed->restore(point);
  ASSERT_TRUE(restored) << restored.error().text();
  EXPECT_EQ(walk(*resumed, 2, 4), expected);
  ThreadPool threads(3);
  const std::unique_ptr<StructureProblem> threaded = problem_of(model, &threads);
  ASSERT_TRUE(threaded->restore(point));
  EXPECT_EQ(walk(*threaded, 2, 4), expected);
}

TEST(StructureProblem, StartsThatCannotBeAreNamed) {
  Model model = honeycomb(JointKind::kExplicit);
  Selector all;
  all.kind = Selector::Kind::kAll;
  model.poses[1].forces.push_back({all, Vec3(0, 0, -1e7), false, Scaling::kProportional});
  const std::unique_ptr<StructureProblem> problem = problem_of(model);
  const Status released = problem->release();
  ASSERT_FALSE(released);
  EXPECT_EQ(released.error().where, "/poses/1");
  EXPECT_NE(released.error().message.find("pose \"pulled\""), std::string::npos) << released.error().message;
}

}  // namespace
}  // namespace lissom
