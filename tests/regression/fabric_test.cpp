/// Rods on pre-stretched fabric: known shapes, cost in factorisations, warm solves, and the parts of the method.

#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <numbers>
#include <random>
#include <utility>

#include "bench/fabric_problems.h"
#include "lissom/equilibrium/branches.h"
#include "lissom/equilibrium/length_fit.h"
#include "lissom/equilibrium/live_solver.h"
#include "lissom/equilibrium/rigid_drift.h"
#include "lissom/equilibrium/solve.h"

namespace lissom {
namespace {

using networks::square_frame_on_fabric;
using networks::SquareFrame;

struct Framed {
  explicit Framed(const SquareFrame& frame) : model(square_frame_on_fabric(frame)) {
    Result<System> made = make_system(model);
    EXPECT_TRUE(made.ok()) << made.error().text();
    system = std::make_unique<System>(std::move(made).value());
    Result<StaticProblem> ready = make_static_problem(model, *system, model.poses[0], "/poses/0");
    EXPECT_TRUE(ready.ok()) << ready.error().text();
    problem = std::make_unique<StaticProblem>(std::move(ready).value());
  }
  Equilibrium settled(const SolveOptions& options = {}, const Context& context = {}) const {
    return solve(*problem, start(), 1, options, context);
  }
  State start() const { return start_state(*problem, model.poses[0]); }
  double height(const State& state) const {
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < system->layout.nodes(); ++i) {
      low = std::min(low, state.position(i).z());
      high = std::max(high, state.position(i).z());
    }
    return 1e3 * (high - low);
  }

  Model model;
  std::unique_ptr<System> system;
  std::unique_ptr<StaticProblem> problem;
};

SquareFrame frame(int cells, double r_n, double r_b, double pre_stretch) {
  SquareFrame f;
  f.cells = cells;
  f.r_n = 1e-3 * r_n;
  f.r_b = 1e-3 * r_b;
  f.pre_stretch = pre_stretch;
  return f;
}

/// Energies (N mm) and heights (mm) of an independent implementation [convergence 1], and the factorisations granted.
TEST(Fabric, SquareFramesReachTheirKnownShapes) {
  struct Known {
    SquareFrame frame;
    double energy, height;
  };
  const Known known[] = {{frame(8, 0.2, 0.4, 1.3), 0.379972, 38.93},
                         {frame(49, 0.2, 0.4, 1.3), 0.381957, 40.82},
                         {frame(49, 0.2, 0.4, 1.6), 0.988718, 78.77},
                         {frame(49, 0.2, 0.2, 1.3), 0.202892, 82.40}};
  for (const Known& k : known) {
    const Framed framed(k.frame);
    const Equilibrium e = framed.settled();
    EXPECT_EQ(e.verdict, Verdict::kStable) << e.message;
    EXPECT_NEAR(1e3 * e.energy, k.energy, 1e-6 * k.energy + 5e-7);
    EXPECT_NEAR(framed.height(e.state), k.height, 0.006);
    EXPECT_LE(e.factorizations, 30);
  }
}

TEST(Fabric, ThickFrameStaysPlanar) {
  const Framed framed(frame(16, 0.4, 0.4, 1.3));
  const Equilibrium e = framed.settled();
  EXPECT_EQ(e.verdict, Verdict::kStable) << e.message;
  EXPECT_LT(framed.height(e.state), 1e-3);
}

TEST(Fabric, EveryPolicyEndsInTheSameShape) {
  const Framed framed(frame(8, 0.2, 0.4, 1.3));
  const double energy = framed.settled().energy;
  int tried = 0;
  for (const Relaxation rods : {Relaxation::kOff, Relaxation::kOn}) {
    for (const StepPath path : {StepPath::kStraight, StepPath::kSecondOrder, StepPath::kRotating}) {
      for (const FactorReuse reuse : {FactorReuse::kOff, FactorReuse::kOn}) {
        SolveOptions options;
        options.rods = rods;
        options.path = path;
        options.reuse = reuse;
        const Equilibrium e = framed.settled(options);
        EXPECT_EQ(e.verdict, Verdict::kStable) << e.message;
        EXPECT_NEAR(e.energy, energy, 1e-8 * energy);
        ++tried;
      }
    }
  }
  EXPECT_EQ(tried, 12);
}

TEST(Fabric, SameBytesAtAnyNumberOfThreads) {
  const Framed framed(frame(24, 0.2, 0.4, 1.3));
  const Equilibrium alone = framed.settled();
  ThreadPool pool(3);
  Context context;
  context.threads = &pool;
  const Equilibrium shared = framed.settled({}, context);
  ASSERT_EQ(alone.state.q.size(), shared.state.q.size());
  EXPECT_TRUE((alone.state.q.array() == shared.state.q.array()).all());
  EXPECT_EQ(alone.energy, shared.energy);
}

/// After a small change the live solver ends where a solve from scratch ends, at a fraction of its cost.
TEST(Fabric, WarmSolvesFollowChanges) {
  const SquareFrame before = frame(24, 0.2, 0.4, 1.3);
  struct Change {
    SquareFrame after;
    int factorizations;
  };
  const Change changes[] = {{frame(24, 0.204, 0.4, 1.3), 2},
                            {frame(24, 0.2, 0.408, 1.3), 2},
                            {frame(24, 0.2, 0.4, 1.31), 2},
                            {frame(24, 0.2, 0.4, 1.35), 6}};
  for (const Change& change : changes) {
    Framed framed(before);
    SolveOptions options;
    options.modes = 0;
    LiveSolver solver(*framed.problem, options);
    const Equilibrium old = solver.settle(framed.start(), 1);
    ASSERT_EQ(old.verdict, Verdict::kStable) << old.message;
    const Model changed = square_frame_on_fabric(change.after);
    const Status renewed = renew_numbers(changed, changed.poses[0], "/poses/0", *framed.system, *framed.problem);
    ASSERT_TRUE(renewed.ok()) << renewed.error().text();
    solver.renew_terms();
    const Equilibrium warm = solver.resettle(old.state);
    EXPECT_EQ(warm.verdict, Verdict::kStable) << warm.message;
    EXPECT_LE(warm.factorizations, change.factorizations);
    const Equilibrium cold = Framed(change.after).settled();
    EXPECT_NEAR(warm.energy, cold.energy, 1e-9 * cold.energy);
    EXPECT_LT(shape_distance(*framed.problem, warm.state, cold.state, Image::kItself), 1e-5);
  }
}

TEST(Fabric, OtherTopologyIsNoSmallChange) {
  Framed framed(frame(8, 0.2, 0.4, 1.3));
  const Model finer = square_frame_on_fabric(frame(9, 0.2, 0.4, 1.3));
  const State before = framed.start();
  const Status renewed = renew_numbers(finer, finer.poses[0], "/poses/0", *framed.system, *framed.problem);
  ASSERT_FALSE(renewed.ok());
  EXPECT_EQ(renewed.error().code, ErrorCode::kConflict);
  EXPECT_EQ(framed.start().q.size(), before.q.size());
}

TEST(Fabric, RigidMotionsAreTakenOutOfSteps) {
  const Framed framed(frame(8, 0.2, 0.4, 1.3));
  const State state = framed.settled().state;
  const RigidDrift drift(*framed.problem);
  // A pure rigid motion: translation, and a rotation with joints and spins along.
  const Vec3 turn(0.3, -0.2, 0.5), shift(1, 2, 3);
  const DofLayout& layout = framed.system->layout;
  VecX dq = VecX::Zero(layout.size());
  for (int i = 0; i < layout.nodes(); ++i) dq.segment<3>(3 * i) = shift + turn.cross(state.position(i));
  for (int e = 0; e < layout.edges(); ++e) dq[layout.roll(e)] = turn.dot(state.edges[e].t);
  for (int k = 0; k < layout.rotations(); ++k) dq.segment<3>(layout.rotation(layout.joint_of_rotation(k))) = turn;
  drift.remove(state, dq);
  EXPECT_LT(dq.cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Fabric, SeedsKeepTheLengthsOfRods) {
  const Framed framed(frame(24, 0.2, 0.4, 1.3));
  const State start = framed.start();
  double strain = 0;
  for (int e = 0; e < framed.system->edge_count(); ++e) {
    strain = std::max(strain, std::abs(start.edges[e].length / framed.system->rest.edges[e].length - 1));
  }
  EXPECT_GT(framed.height(start), 5);
  EXPECT_LT(strain, 1e-5);
}

TEST(Fabric, RelaxingRodsLeavesTheMembraneInPlace) {
  const Framed framed(frame(8, 0.2, 0.4, 1.3));
  const Context context;
  NewtonWorkspace workspace(*framed.problem, context);
  State state = framed.start();
  const State before = state;
  workspace.assemble(state);
  const RigidDrift drift(*framed.problem);
  BlockRelaxer rods(workspace, rod_unknowns(*framed.system), drift.can_move());
  ASSERT_TRUE(rods.useful());
  ASSERT_TRUE(rods.relax(state, 4, 0, 0));
  EXPECT_LT(workspace.energy(state), workspace.energy(before));
  const std::vector<bool> part = rod_unknowns(*framed.system);
  double moved = 0, still = 0;
  for (int i = 0; i < state.q.size(); ++i) {
    double& largest = part[i] ? moved : still;
    largest = std::max(largest, std::abs(state.q[i] - before.q[i]));
  }
  EXPECT_GT(moved, 0);
  EXPECT_EQ(still, 0);
}

/// The frame of the figure has one shape and its mirror image, both downhill from the flat one.
TEST(Fabric, BranchesOfTheSquareFrame) {
  const Framed framed(frame(8, 0.2, 0.4, 1.3));
  BranchOptions options;
  options.most_solves = 60;
  const BranchSearch search = find_branches(*framed.problem, framed.model.poses[0], options);
  EXPECT_GT(search.drawn_negative, 0);
  ASSERT_FALSE(search.branches.empty());
  const Branch& lowest = search.branches.front();
  EXPECT_NEAR(1e3 * lowest.equilibrium.energy, 0.379972, 1e-6);
  EXPECT_TRUE(lowest.barrier_free);
  for (size_t i = 0; i < search.branches.size(); ++i) {
    EXPECT_EQ(search.branches[i].equilibrium.verdict, Verdict::kStable);
    for (size_t j = 0; j < i; ++j) {
      const State &a = search.branches[i].equilibrium.state, &b = search.branches[j].equilibrium.state;
      EXPECT_GT(shape_distance(*framed.problem, a, b, Image::kItself), options.alike * framed.problem->scales.length);
    }
  }
}

/// A start raised to a random cubic polynomial over the plan, up to a fifth of the extent, lengths of rods kept.
State random_start(const Framed& framed, std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  double c[10];
  for (double& x : c) x = number(random);
  const double half = 0.5 * framed.system->structure.size / std::numbers::sqrt2;
  const double amplitude = half * std::pow(10, number(random) - 1);
  const int nodes = framed.system->layout.nodes();
  VecX height(nodes), dq = VecX::Zero(framed.system->layout.size());
  for (int i = 0; i < nodes; ++i) {
    const double x = framed.system->structure.nodes[i].x() / half, y = framed.system->structure.nodes[i].y() / half;
    height[i] = c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y + c[6] * x * x * x +
                c[7] * x * x * y + c[8] * x * y * y + c[9] * y * y * y;
  }
  height *= amplitude / height.cwiseAbs().maxCoeff();
  for (int i = 0; i < nodes; ++i) dq[3 * i + 2] = height[i];
  const State drawn = drawn_state(*framed.system);
  LengthFit fit(*framed.problem, RigidDrift(*framed.problem).can_move());
  VecX mended = dq;
  const VecX still = VecX::Zero(dq.size());
  State start;
  EXPECT_TRUE(fit.mend(drawn, 1, still, {}, mended));
  EXPECT_TRUE(advance(*framed.system, drawn, mended, start));
  return start;
}

TEST(Fabric, RandomStartsFindNoShapeThatTheSearchMisses) {
  const Framed framed(frame(8, 0.2, 0.4, 1.3));
  const BranchOptions options;
  const BranchSearch search = find_branches(*framed.problem, framed.model.poses[0], options);
  const double alike = options.alike * framed.problem->scales.length;
  std::mt19937 random(3);
  int settled = 0;
  for (int k = 0; k < 200; ++k) {
    const Equilibrium e = solve(*framed.problem, random_start(framed, random), 1, {});
    if (e.verdict != Verdict::kStable) continue;
    ++settled;
    bool known = false;
    for (const Branch& branch : search.branches) {
      for (const Image image : {Image::kItself, Image::kMirrored}) {
        known = known || shape_distance(*framed.problem, branch.equilibrium.state, e.state, image) < alike;
      }
    }
    EXPECT_TRUE(known) << "start " << k << ": " << 1e3 * e.energy << " mJ";
  }
  EXPECT_GE(settled, 195);
}

}  // namespace
}  // namespace lissom
