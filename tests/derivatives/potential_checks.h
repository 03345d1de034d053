#pragma once
/// What holds for the potential of every energy.

#include <gtest/gtest.h>
#include <random>

#include "lissom/geometry/frame.h"
#include "tests/derivatives/derivative_checks.h"

namespace lissom::checks {

/// Remainders of the Taylor series along random increments fall with the order that exact derivatives give them.
inline void expect_full_order(const System& system, const Potential& potential, const State& state) {
  std::mt19937 random(5);
  for (int k = 0; k < 5; ++k) {
    const VecX direction = random_increment(system, random, 1);
    const TaylorSlopes slopes = taylor_slopes(system, potential, state, direction, 1e-2);
    EXPECT_GT(slopes.gradient, 1.95);
    EXPECT_GT(slopes.hessian, 2.95);
  }
}

/// A rigid motion changes no value and turns the gradient at the nodes.
inline void expect_rigid_motion_neutral(const System& system, const Potential& potential, const State& state) {
  const Mat3 rotation = rotation_from_vector(Vec3(1.1, -2.0, 0.6));
  const State moved = rigidly_moved(system, state, rotation, Vec3(0.01, 0.02, 0.03), Vec3(0.2, -0.1, 0.3));
  AssemblyBuffers buffers;
  EXPECT_NEAR(potential.value(moved, buffers) / potential.value(state, buffers), 1, 1e-12);
  VecX g, g_moved;
  potential.gradient(state, g, buffers);
  potential.gradient(moved, g_moved, buffers);
  const double scale = g.cwiseAbs().maxCoeff();
  ASSERT_GT(scale, 0);
  for (int i = 0; i < system.layout.nodes(); ++i) {
    EXPECT_LT((rotation * g.segment<3>(3 * i) - g_moved.segment<3>(3 * i)).norm(), 1e-9 * scale);
  }
}

}  // namespace lissom::checks
