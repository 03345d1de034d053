/// Whole solves: verdicts, stability, determinism, and changes of the description that must not change the result.

#include <algorithm>
#include <atomic>
#include <gtest/gtest.h>
#include <utility>

#include "lissom/equilibrium/continuation.h"
#include "lissom/equilibrium/solve.h"
#include "scenes/parts.h"
#include "scenes/scenes.h"

namespace lissom {
namespace {

Model scene(std::string_view name) {
  const auto all = scenes();
  return std::find_if(all.begin(), all.end(), [&](const Scene& s) { return s.name == name; })->make();
}

/// A model with its system and problem, solved at load factor 1.
struct Solved {
  explicit Solved(Model given, const SolveOptions& options = {}, const Context& context = {})
      : model(std::move(given)) {
    Result<System> made = make_system(model);
    EXPECT_TRUE(made.ok()) << made.error().text();
    system = std::make_unique<System>(std::move(made).value());
    Result<StaticProblem> problem = make_static_problem(model, *system, model.poses[0], "/poses/0");
    EXPECT_TRUE(problem.ok()) << problem.error().text();
    equilibrium = solve(problem.value(), start_state(problem.value(), model.poses[0]), 1, options, context);
  }
  Model model;
  std::unique_ptr<System> system;
  Equilibrium equilibrium;
};

Model strut(double force) {
  Model model;
  model.rods.push_back(
      scene_models::round_rod("strut", Polyline{{Vec3(0, 0, 0), Vec3(0.2, 0, 0)}, false}, 0.001, "PLA", 40));
  model.rods[0].section.r_b = {0.002};
  Pose pose;
  pose.name = "pressed";
  pose.supports.push_back(scene_models::hold(scene_models::rod_place("strut", 0), SupportKind::kClamp));
  PointForce load;
  load.at = scene_models::rod_place("strut", 1);
  load.force = Vec3(-force, 0, 0);
  pose.forces.push_back(load);
  model.poses.push_back(pose);
  return model;
}

TEST(Solve, EverySceneSettles) {
  int count = 0;
  for (const Scene& s : scenes()) {
    SCOPED_TRACE(std::string(s.name));
    const Solved solved(s.make());
    EXPECT_TRUE(solved.equilibrium.verdict == Verdict::kStable || solved.equilibrium.verdict == Verdict::kCritical)
        << solved.equilibrium.message;
    EXPECT_LE(solved.equilibrium.residual, solved.equilibrium.tolerance);
    ++count;
  }
  EXPECT_GE(count, 10);
}

TEST(Solve, LeavesTheStraightStrutBeyondItsBucklingLoad) {
  // Clamped-free: pi^2 B / (4 L^2) = 0.32 N about the weak axis.
  const Solved below(strut(0.25)), beyond(strut(0.5));
  EXPECT_EQ(below.equilibrium.verdict, Verdict::kStable) << below.equilibrium.message;
  EXPECT_LT(std::abs(below.equilibrium.state.position(40).z()), 1e-9);
  EXPECT_EQ(beyond.equilibrium.verdict, Verdict::kStable) << beyond.equilibrium.message;
  EXPECT_GT(std::abs(beyond.equilibrium.state.position(40).z()), 0.02);
  SolveOptions stay;
  stay.at_saddle = AtSaddle::kStay;
  const Solved held(strut(0.5), stay);
  EXPECT_EQ(held.equilibrium.verdict, Verdict::kUnstable);
  EXPECT_EQ(held.equilibrium.negative_modes, 1);
}

TEST(Solve, SaysWhyItStopped) {
  SolveOptions few;
  few.max_iterations = 2;
  EXPECT_EQ(Solved(scene("hexagon_sheet"), few).equilibrium.verdict, Verdict::kIterationLimit);
  std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  const Solved cancelled(scene("hexagon_sheet"), {}, context);
  EXPECT_EQ(cancelled.equilibrium.verdict, Verdict::kCancelled);
  EXPECT_TRUE(cancelled.equilibrium.state.q.allFinite());
}

TEST(Solve, AnUnheldPartThatItsLoadsDriveAwayIsRefused) {
  Model model = strut(0.1);
  model.poses[0].supports.clear();
  const Result<System> system = make_system(model);
  ASSERT_TRUE(system.ok());
  const Result<StaticProblem> problem = make_static_problem(model, system.value(), model.poses[0], "/poses/0");
  ASSERT_FALSE(problem.ok());
  EXPECT_EQ(problem.error().where, "/poses/0/supports");
}

TEST(Solve, ThreadsChangeNoByte) {
  const Solved one(scene("gridshell"));
  for (const int threads : {2, 8}) {
    ThreadPool pool(threads);
    Context context;
    context.threads = &pool;
    const Solved many(scene("gridshell"), {}, context);
    EXPECT_EQ(one.equilibrium.state.q, many.equilibrium.state.q);
    EXPECT_EQ(one.equilibrium.energy, many.equilibrium.energy);
    EXPECT_EQ(one.equilibrium.iterations, many.equilibrium.iterations);
  }
}

TEST(Solve, RodsDrawnBackwardsGiveTheSameShape) {
  const Model forward = scene("cantilever");
  Model backward = forward;
  auto& line = std::get<Polyline>(backward.rods[0].curve);
  std::reverse(line.points.begin(), line.points.end());
  backward.poses[0].supports[0].at.fraction = 1;
  backward.poses[0].forces[0].at.fraction = 0;
  const Solved a(forward), b(backward);
  const int last = 100;
  for (int i = 0; i <= last; ++i) {
    EXPECT_LT((a.equilibrium.state.position(i) - b.equilibrium.state.position(last - i)).norm(), 1e-9);
  }
}

TEST(Solve, SplitRodsActAsOneToFirstOrder) {
  // Under a load so small that only first order counts, both joints pass everything on.
  Model whole = scene("cantilever");
  whole.poses[0].forces[0].force *= 1e-5;
  for (const JointKind kind : {JointKind::kExplicit, JointKind::kCorotational}) {
    Model split = whole;
    split.joint_kind = kind;
    split.rods[0].curve = Polyline{{Vec3(0, 0, 0), Vec3(0.06, 0, 0)}, false};
    split.rods[0].edges = 30;
    Rod second = split.rods[0];
    second.name = "end";
    second.curve = Polyline{{Vec3(0.06, 0, 0), Vec3(0.2, 0, 0)}, false};
    second.edges = 70;
    split.rods.push_back(second);
    split.poses[0].forces[0].at.name = "end";
    const Solved a(whole), b(split);
    const double drop = a.equilibrium.state.position(100).z();
    EXPECT_LT(drop, -1e-7);
    EXPECT_NEAR(b.equilibrium.state.position(100).z() / drop, 1, 1e-9);
  }
}

TEST(Path, FindsTheEulerLoadAndTheBranch) {
  Model model = strut(0.6);
  const Result<System> system = make_system(model);
  ASSERT_TRUE(system.ok());
  const Result<StaticProblem> problem = make_static_problem(model, system.value(), model.poses[0], "/poses/0");
  ASSERT_TRUE(problem.ok());
  LoadPath path;
  path.steps = 12;
  path.switch_branch = true;
  const PathResult result = follow_path(problem.value(), drawn_state(system.value()), path, {});
  EXPECT_EQ(result.end, PathEnd::kReached) << result.message;
  ASSERT_FALSE(result.critical.empty());
  EXPECT_EQ(result.critical[0].kind, CriticalKind::kBifurcation);
  // pi^2 B / (4 L^2) with B = E A r_n^2 / 4.
  const double euler = 2.4674 * 3.31e9 * (3.14159265 * 2e-6) * 2.5e-7 / 0.04;
  EXPECT_NEAR(result.critical[0].load_factor * 0.6 / euler, 1, 1e-3);
  EXPECT_EQ(result.points.back().negative_modes, 0);
  EXPECT_GT(std::abs(result.points.back().state.position(40).z()), 0.02);
}

}  // namespace
}  // namespace lissom
