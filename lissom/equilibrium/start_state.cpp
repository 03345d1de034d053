#include <algorithm>
#include <cmath>
#include <numbers>

#include "lissom/equilibrium/edge_laplacian.h"
#include "lissom/equilibrium/length_fit.h"
#include "lissom/equilibrium/rigid_drift.h"
#include "lissom/equilibrium/static_problem.h"

namespace lissom {

namespace {

constexpr double kOwnSeed = 0.05;  // of the larger extent of the plan

/// Half a sine along each rod.
VecX sine_heights(const System& system) {
  VecX height = VecX::Zero(system.layout.nodes());
  for (const StructureRod& rod : system.structure.rods) {
    const double last = static_cast<double>(rod.nodes.size()) - 1;
    for (size_t k = 0; k < rod.nodes.size(); ++k) {
      height[rod.nodes[k]] = std::sin(std::numbers::pi * static_cast<double>(k) / last);
    }
  }
  return height;
}

/// The sag of a net under even load between what is held; along `direction`, largest 1. Empty where nothing is held.
VecX dome_heights(const StaticProblem& problem, const Vec3& direction) {
  const System& system = *problem.system;
  const int nodes = system.layout.nodes();
  VecX load = VecX::Zero(system.layout.size()), net;
  for (int i = 0; i < nodes; ++i) load.segment<3>(3 * i) = system.rest.node_length[i] * direction;
  EdgeLaplacian laplacian(problem);
  if (!laplacian.factorize(0)) return {};
  laplacian.solve(load, net);
  VecX height(nodes);
  for (int i = 0; i < nodes; ++i) height[i] = net.segment<3>(3 * i).dot(direction);
  const double largest = height.maxCoeff();
  // Parts that nothing holds float away as a whole: no dome.
  if (!(largest > 0) || height.minCoeff() > 0.5 * largest) return {};
  return height / largest;
}

/// A saddle with some slope and skew, so that no mode of a symmetric plan is left out [convergence 4]; largest 1.
VecX saddle_heights(const System& system) {
  Vec3 low = system.structure.nodes[0], high = low;
  for (const Vec3& p : system.structure.nodes) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec3 centre = 0.5 * (low + high);
  const double extent = std::max(high.x() - low.x(), high.y() - low.y());
  VecX height(system.layout.nodes());
  for (int i = 0; i < height.size(); ++i) {
    const double x = (system.structure.nodes[i].x() - centre.x()) / extent;
    const double y = (system.structure.nodes[i].y() - centre.y()) / extent;
    height[i] = 4 * x * y + 0.9 * (x * x - y * y) + 0.3 * x * x + 0.2 * x * x * x - 0.15 * y * y * y;
  }
  return height / std::max(height.cwiseAbs().maxCoeff(), 1e-300);
}

/// The seed of a pose that names none.
Seed own_seed(const System& system) {
  Seed seed;
  Vec3 low = system.structure.nodes[0], high = low;
  for (const Vec3& p : system.structure.nodes) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double extent = std::max(high.x() - low.x(), high.y() - low.y());
  if (system.rest.max_tension <= 0 || system.structure.rods.empty() || high.z() - low.z() > 1e-6 * extent) return seed;
  seed.shape = Seed::Shape::kSaddle;
  seed.amplitude = kOwnSeed * extent;
  return seed;
}

}  // namespace

State start_state(const StaticProblem& problem, const Pose& pose) {
  const System& system = *problem.system;
  State state = drawn_state(system);
  const Seed seed = pose.seed ? *pose.seed : own_seed(system);
  if (seed.amplitude == 0) return state;
  const Vec3 direction = seed.direction.normalized();
  VecX height;
  if (seed.shape == Seed::Shape::kSaddle) {
    height = saddle_heights(system);
  } else if (system.structure.rods.size() > 1) {
    height = dome_heights(problem, direction);
  }
  if (height.size() == 0) height = sine_heights(system);
  VecX dq = VecX::Zero(system.layout.size());
  for (int i = 0; i < system.layout.nodes(); ++i) dq.segment<3>(3 * i) = seed.amplitude * height[i] * direction;
  // What a support holds stays where it is.
  const RigidDrift drift(problem);
  problem.potential.to_local(dq);
  for (int i = 0; i < dq.size(); ++i) {
    if (!drift.can_move()[i]) dq[i] = 0;
  }
  problem.potential.to_global(dq);
  if (!system.structure.triangles.empty()) {
    // Rods keep their lengths: sideways displacement alone would stretch them.
    LengthFit fit(problem, drift.can_move());
    const VecX still = VecX::Zero(dq.size());
    VecX mended = dq;
    if (fit.mend(state, 1, still, {}, mended)) dq = mended;
  }
  State seeded;
  return advance(system, state, dq, seeded) ? seeded : state;
}

}  // namespace lissom
