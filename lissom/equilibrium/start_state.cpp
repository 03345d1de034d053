#include <cmath>
#include <numbers>

#include "lissom/equilibrium/edge_laplacian.h"
#include "lissom/equilibrium/static_problem.h"

namespace lissom {

namespace {

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

}  // namespace

State start_state(const StaticProblem& problem, const Pose& pose) {
  const System& system = *problem.system;
  State state = drawn_state(system);
  if (!pose.seed || pose.seed->amplitude == 0) return state;
  const Vec3 direction = pose.seed->direction.normalized();
  VecX height;
  if (system.structure.rods.size() > 1) height = dome_heights(problem, direction);
  if (height.size() == 0) height = sine_heights(system);
  VecX dq = VecX::Zero(system.layout.size());
  for (int i = 0; i < system.layout.nodes(); ++i) dq.segment<3>(3 * i) = pose.seed->amplitude * height[i] * direction;
  // Held unknowns stay where they are.
  problem.potential.to_local(dq);
  for (int i = 0; i < dq.size(); ++i) {
    if (problem.supports.kept()[i] < 0) dq[i] = 0;
  }
  problem.potential.to_global(dq);
  State seeded;
  return advance(system, state, dq, seeded) ? seeded : state;
}

}  // namespace lissom
