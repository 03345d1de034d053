#pragma once
/// Starts far from any shape: positions moved by up to a third of the size, frames turned at random.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "lissom/equilibrium/static_problem.h"

namespace lissom {

enum class Disturbance {
  kSmooth,  ///< a random smooth field: the shape is bent and crumpled, neighbours stay neighbours
  kNoise,   ///< every node by itself: edges stretched to many times their length, in every direction
};

/// Uniform in [-1, 1); the same on every system, unlike the distributions of the standard library.
inline double random_number(std::mt19937_64& random) {
  return std::ldexp(static_cast<double>(random() >> 11), -52) - 1;
}

/// The start of a pose with its free positions moved by up to a third of the size, its rolls turned by up to 180 degrees
/// and its joints by up to 90 degrees about each axis. The same for the same seed.
inline State disturbed_state(const StaticProblem& problem, const Pose& pose, unsigned seed, Disturbance kind) {
  const System& system = *problem.system;
  std::mt19937_64 random(seed);
  const auto vector = [&] { return Vec3(random_number(random), random_number(random), random_number(random)); };
  const double size = system.structure.size, amplitude = size / 3 * (0.5 + 0.5 * random_number(random));
  VecX dq = VecX::Zero(system.layout.size());
  const int nodes = system.layout.nodes();
  Vec3 waves[4], directions[4], phases = std::numbers::pi * vector();
  for (int k = 0; k < 4; ++k) waves[k] = 2 * std::numbers::pi / size * vector(), directions[k] = vector();
  double largest = 0;
  for (int i = 0; i < nodes; ++i) {
    Vec3 move = Vec3::Zero();
    if (kind == Disturbance::kNoise) {
      move = vector();
    } else {
      for (int k = 0; k < 4; ++k)
        move += std::sin(waves[k].dot(system.structure.nodes[i]) + phases[k % 3]) * directions[k];
    }
    dq.segment<3>(3 * i) = move;
    largest = std::max(largest, move.norm());
  }
  dq *= amplitude / largest;
  for (int e = 0; e < system.edge_count(); ++e) dq[system.layout.roll(e)] = std::numbers::pi * random_number(random);
  for (int i = 3 * nodes + system.edge_count(); i < dq.size(); ++i) {
    dq[i] = 0.5 * std::numbers::pi * random_number(random);
  }
  problem.potential.to_local(dq);
  for (int i = 0; i < dq.size(); ++i) {
    if (problem.supports.kept()[i] < 0) dq[i] = 0;
  }
  problem.potential.to_global(dq);
  // In small parts, as an edge must not turn around within one.
  State state = start_state(problem, pose), moved;
  constexpr int kParts = 16;
  for (int k = 0; k < kParts; ++k) {
    if (advance(system, state, dq / kParts, moved)) std::swap(state, moved);
  }
  return state;
}

}  // namespace lissom
