#pragma once
/// Inverse problems of one slender rod, for the tests of methods in total space: a cantilever in two poses, whose radii are
/// sought, and a strut under more than its critical load.

#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lissom/design/design_spaces.h"
#include "lissom/design/network_radii.h"
#include "lissom/design/objective_node_positions.h"
#include "lissom/design/optimizer.h"
#include "lissom/design/structure_problem.h"
#include "lissom/design/total_space.h"
#include "scenes/parts.h"

namespace lissom::total {

constexpr int kEdges = 24;
constexpr double kLength = 0.2;

/// Clamped at x = 0; hangs by its weight in one pose, is pulled aside and along at its end in the other.
inline Model cantilever() {
  Model model;
  model.rods.push_back(
      scene_models::round_rod("arm", Polyline{{Vec3(0, 0, 0), Vec3(kLength, 0, 0)}}, 2.4e-3, "TPU 92A", kEdges));
  Pose hanging;
  hanging.name = "hanging";
  hanging.supports.push_back(scene_models::hold(scene_models::rod_place("arm", 0), SupportKind::kClamp));
  Pose pulled = hanging;
  hanging.gravity = Gravity{};
  pulled.name = "pulled";
  pulled.forces.push_back(
      {scene_models::rod_place("arm", 1), Vec3(0.002, 0.02, -0.004), false, Scaling::kProportional});
  model.poses = {hanging, pulled};
  return model;
}

/// Clamped at one end, pressed at the other by more than any radius in its range bears; weaker in one direction.
inline Model strut() {
  Model model;
  model.rods.push_back(
      scene_models::round_rod("strut", Polyline{{Vec3(0, 0, 0), Vec3(kLength, 0, 0)}}, 2.0e-3, "TPU 92A", kEdges));
  model.rods[0].section.r_n = {1.7e-3};
  Pose pose;
  pose.name = "loaded";
  pose.supports.push_back(scene_models::hold(scene_models::rod_place("strut", 0), SupportKind::kClamp));
  pose.forces.push_back({scene_models::rod_place("strut", 1), Vec3(-0.04, 0, 0), false, Scaling::kProportional});
  Seed seed;
  seed.amplitude = 0.01;
  seed.direction = Vec3::UnitZ();
  pose.seed = seed;
  model.poses = {pose};
  return model;
}

/// All nodes of a pose towards these places (3 per node, m).
inline Goal shape_goal(int pose, const VecX& places) {
  const int n = static_cast<int>(places.size()) / 3;
  std::vector<int> nodes(n);
  for (int i = 0; i < n; ++i) nodes[i] = i;
  Goal goal;
  goal.name = "shape in pose " + std::to_string(pose);
  goal.pose = pose;
  goal.objective = make_node_positions(nodes);
  goal.target = places;
  goal.weights = VecX::Constant(3 * n, 1.0 / n);
  goal.scale = 1e-3;
  return goal;
}

inline std::unique_ptr<StructureProblem> problem_of(std::shared_ptr<const DesignSpace> space,
                                                    const std::vector<VecX>& places) {
  std::vector<Goal> goals;
  for (int k = 0; k < static_cast<int>(places.size()); ++k) goals.push_back(shape_goal(k, places[k]));
  StructureProblemOptions options;
  options.solve.tolerance = 1e-10;
  Result<std::unique_ptr<StructureProblem>> problem =
      StructureProblem::make(std::move(space), std::move(goals), {}, options, {});
  EXPECT_TRUE(problem) << problem.error().text();
  return std::move(problem).value();
}

/// The same in equilibrium.
inline std::unique_ptr<StructureProblem> started(std::shared_ptr<const DesignSpace> space,
                                                 const std::vector<VecX>& places) {
  std::unique_ptr<StructureProblem> problem = problem_of(std::move(space), places);
  const Status released = problem->release();
  EXPECT_TRUE(released) << released.error().text();
  return problem;
}

inline std::shared_ptr<const DesignSpace> radii_of(const Model& model, const Vec2& range) {
  auto base = std::make_shared<Design>();
  base->model = model;
  base->system = make_system(model).value();
  Result<LinearSpace> space = radii_space(base, ControlStage::kMiddle, range);
  EXPECT_TRUE(space) << space.error().text();
  return std::make_shared<LinearSpace>(std::move(space).value());
}

/// Radii of the shape that is asked for, m.
inline VecX wanted_radii() {
  VecX p(6);
  p << 2.9e-3, 1.9e-3, 2.2e-3, 2.1e-3, 1.8e-3, 2.7e-3;
  return p;
}

/// Shapes that some radii have, plus waves of this height (m) that none have.
inline std::unique_ptr<StructureProblem> cantilever_problem(double waves, const Vec2& range = {1e-3, 4e-3}) {
  const Model model = cantilever();
  const int nodes = static_cast<int>(make_system(model).value().structure.nodes.size());
  const std::unique_ptr<StructureProblem> any =
      problem_of(radii_of(model, {1e-3, 4e-3}), std::vector<VecX>(2, VecX::Zero(3 * nodes)));
  const VecX p = wanted_radii();
  const Status made = any->release(&p);
  EXPECT_TRUE(made) << made.error().text();
  std::vector<VecX> places;
  for (const auto& pose : any->poses()) {
    places.push_back(pose->state().q.head(3 * nodes));
    for (int i = 0; i <= kEdges; ++i) {
      const double s = double(i) / kEdges;
      places.back().segment<3>(3 * i) += waves * s * Vec3(0, std::sin(9 * s), std::cos(7 * s));
    }
  }
  return started(radii_of(model, range), places);
}

/// Where the nodes of a model are drawn (3 per node, m).
inline VecX drawn_places(const Model& model) {
  const std::vector<Vec3> nodes = make_system(model).value().structure.nodes;
  VecX places(3 * static_cast<Eigen::Index>(nodes.size()));
  for (int i = 0; i < static_cast<int>(nodes.size()); ++i) places.segment<3>(3 * i) = nodes[i];
  return places;
}

/// Asks a strut to be straight, as it is drawn, by its half-extents in the weaker direction, which stays the weaker one.
inline std::unique_ptr<StructureProblem> strut_problem() {
  const std::shared_ptr<const DesignSpace> all = radii_of(strut(), {1.4e-3, 2.2e-3});
  std::vector<Parameter> weak(all->parameters().begin(), all->parameters().begin() + 3);
  VecX origin = all->start();
  origin.head(3).setZero();
  SparseMatrix z(6, 3);
  for (int i = 0; i < 3; ++i) {
    z.insert(i, i) = 1;
    weak[i].upper = 1.9e-3;
  }
  Result<MappedSpace> space = MappedSpace::make(all, origin, z, weak);
  EXPECT_TRUE(space) << space.error().text();
  return started(std::make_shared<MappedSpace>(std::move(space).value()), {drawn_places(strut())});
}

/// The same by all radii. Where the strut becomes round it turns about its axis without a force.
inline std::unique_ptr<StructureProblem> round_strut_problem() {
  return started(radii_of(strut(), {1.5e-3, 2.2e-3}), {drawn_places(strut())});
}

inline VecX some_vector(Eigen::Index size, double phase) {
  VecX v(size);
  for (Eigen::Index i = 0; i < size; ++i) v[i] = std::sin(phase + 1.9 * static_cast<double>(i));
  return v / v.norm();
}

inline std::unique_ptr<TotalSpace> space_of(const StructureProblem& problem) {
  Result<std::unique_ptr<TotalSpace>> space = TotalSpace::make(problem, {});
  EXPECT_TRUE(space) << space.error().text();
  return std::move(space).value();
}

/// Away from equilibrium by a step of this length over scales, and linear there.
inline void leave(TotalSpace& space, double length) {
  ASSERT_TRUE(space.linearize());
  VecX step = length * some_vector(space.size(), 0.3);
  step.tail(space.parameters()) = 0.2 * some_vector(space.parameters(), 1.1);
  ASSERT_TRUE(space.attempt(step, 1));
  space.accept();
  ASSERT_GT(space.imbalance(), 1e3);
  ASSERT_TRUE(space.linearize());
  ASSERT_TRUE(space.is_regular());
}

/// The minimiser by structured BFGS, as precisely as it goes.
inline VecX reduced_minimiser(StructureProblem& problem) {
  Optimizer optimizer(
      problem, {.max_iterations = 300, .gradient_tolerance = 1e-11, .decrease_tolerance = 0, .least_step = 1e-12});
  const DesignVerdict verdict = optimizer.run({});
  EXPECT_EQ(verdict, DesignVerdict::kConverged) << optimizer.state().message;
  return problem.x();
}

inline double distance(const VecX& a, const VecX& b) { return (a - b).cwiseAbs().maxCoeff(); }

}  // namespace lissom::total
