/// Starts far from any shape end in stable equilibria. The long run over ten networks is bench/robustness_bench.cpp.

#include <cmath>
#include <gtest/gtest.h>

#include "bench/disturbed.h"
#include "bench/networks.h"
#include "lissom/equilibrium/solve.h"
#include "lissom/equilibrium/start_smoothing.h"

namespace lissom {
namespace {

struct Network {
  explicit Network(Model given)
      : model(std::move(given)),
        system(make_system(model).value()),
        problem(make_static_problem(model, system, model.poses[0], "/poses/0").value()) {}
  Model model;
  System system;
  StaticProblem problem;
};

TEST(Robustness, DisturbedStartsSettle) {
  for (const char* name : {"ring", "frame", "helix", "grid", "gridshell"}) {
    const Network n(networks::scene(name));
    for (const Disturbance kind : {Disturbance::kSmooth, Disturbance::kNoise}) {
      for (unsigned seed = 0; seed < 4; ++seed) {
        SCOPED_TRACE(std::string(name) + ", seed " + std::to_string(seed));
        const Equilibrium e = solve(n.problem, disturbed_state(n.problem, n.model.poses[0], seed, kind), 1, {});
        EXPECT_TRUE(e.verdict == Verdict::kStable || e.verdict == Verdict::kCritical) << e.message;
        EXPECT_LE(e.residual, e.tolerance);
      }
    }
  }
}

TEST(Robustness, OnlyCrumpledStartsAreSmoothedAndAsLittleAsNeeded) {
  const Network n(networks::scene("grid"));
  const Pose& pose = n.model.poses[0];
  EXPECT_FALSE(is_crumpled(n.system, start_state(n.problem, pose)));
  const State wild = disturbed_state(n.problem, pose, 1, Disturbance::kNoise);
  EXPECT_TRUE(is_crumpled(n.system, wild));
  const State smooth = smoothed_start(n.problem, wild);
  EXPECT_FALSE(is_crumpled(n.system, smooth));
  EXPECT_GT((smooth.q - drawn_state(n.system).q).norm(), 0.01 * n.system.structure.size);
  // What is held stays.
  for (int i = 0; i < 3 * n.system.layout.nodes(); ++i) {
    if (n.problem.supports.held_by_pose(i)) EXPECT_NEAR(smooth.q[i], wild.q[i], 1e-15);
  }
  // Where the frames alone are wild, a bent shape is kept.
  VecX bend = VecX::Zero(n.system.layout.size());
  for (int i = 0; i < n.system.layout.nodes(); ++i) {
    const double x = n.system.structure.nodes[i].x() + 0.02;
    if (x > 0) bend[3 * i + 2] = 5 * x * x;
  }
  VecX turned = bend;
  for (int e = 0; e < n.system.edge_count(); ++e) turned[n.system.layout.roll(e)] = 3 * std::sin(1.0 + e);
  State bent;
  ASSERT_TRUE(advance(n.system, drawn_state(n.system), turned, bent));
  EXPECT_TRUE(is_crumpled(n.system, bent));
  const VecX moved = (smoothed_start(n.problem, bent).q - bent.q).head(3 * n.system.layout.nodes());
  EXPECT_LT(moved.norm(), 0.02 * bend.norm());
}

TEST(Robustness, TheMessageSaysThatTheStartWasSmoothed) {
  const Network n(networks::scene("ring"));
  const State wild = disturbed_state(n.problem, n.model.poses[0], 1, Disturbance::kNoise);
  const Equilibrium e = solve(n.problem, wild, 1, {});
  EXPECT_TRUE(e.start_smoothed);
  EXPECT_NE(e.message.find("smoothed"), std::string::npos) << e.message;
  EXPECT_FALSE(solve(n.problem, start_state(n.problem, n.model.poses[0]), 1, {}).start_smoothed);
}

}  // namespace
}  // namespace lissom
