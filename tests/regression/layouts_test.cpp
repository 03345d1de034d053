/// Random layouts of rods on fabric settle in shapes that are stable indeed. Five hundred of them: bench/layouts_bench.cpp.

#include <gtest/gtest.h>
#include <memory>
#include <string>

#include "bench/shape_check.h"
#include "lissom/equilibrium/solve.h"
#include "lissom/mechanics/membrane_strain.h"
#include "lissom/model/document.h"
#include "scenes/random_plans.h"

namespace lissom {
namespace {

constexpr scene_models::RandomPlanSize kSmall{120, 260, 3, 14};

struct Layout {
  Layout(unsigned seed, const scene_models::RandomPlanSize& size) : model(scene_models::random_plan(seed, size)) {
    Result<System> made = make_system(model);
    EXPECT_TRUE(made.ok()) << made.error().text();
    system = std::make_unique<System>(std::move(made).value());
    Result<StaticProblem> ready = make_static_problem(model, *system, model.poses[0], "/poses/0");
    EXPECT_TRUE(ready.ok()) << ready.error().text();
    problem = std::make_unique<StaticProblem>(std::move(ready).value());
  }
  Equilibrium settled() const { return solve(*problem, start_state(*problem, model.poses[0]), 1, {}); }
  double smallest_stretch(const State& state) const {
    double smallest = INFINITY;
    for (const TriangleStretch& t : triangle_stretches(*system, state, 1)) smallest = std::min(smallest, t.smallest);
    return smallest;
  }

  Model model;
  std::unique_ptr<System> system;
  std::unique_ptr<StaticProblem> problem;
};

TEST(Layouts, SettleInStableShapes) {
  int ghosts = 0, splits = 0, holes = 0, rings = 0, curves[3] = {0, 0, 0};
  for (unsigned seed = 3; seed < 17; ++seed) {
    const Layout layout(seed, kSmall);
    SCOPED_TRACE(layout.model.title);
    const Plan& plan = *layout.model.plan;
    for (const PlanRod& rod : plan.rods) {
      ghosts += rod.role == PlanRole::kGhost;
      ++curves[static_cast<int>(rod.curve)];
      rings += rod.closed && &rod != &plan.rods[0];
    }
    for (const PlanPoint& point : plan.points) splits += point.split;
    holes += static_cast<int>(plan.fabric.holes.size());
    EXPECT_TRUE(layout.model.validate());
    const Equilibrium e = layout.settled();
    EXPECT_EQ(e.verdict, Verdict::kStable) << e.message;
    EXPECT_TRUE(verdict_is_true(*layout.problem, e)) << e.message;
  }
  EXPECT_GT(ghosts, 3);
  EXPECT_GT(splits, 3);
  EXPECT_GT(holes, 1);
  EXPECT_GT(rings, 2);
  for (const int count : curves) EXPECT_GT(count, 3);
}

TEST(Layouts, AreTheSameForTheSameSeed) {
  const Layout once(3, kSmall), again(3, kSmall);
  EXPECT_EQ(write_document(once.model), write_document(again.model));
  EXPECT_NE(write_document(once.model), write_document(scene_models::random_plan(4, kSmall)));
  const Equilibrium a = once.settled(), b = again.settled();
  ASSERT_EQ(a.state.q.size(), b.state.q.size());
  EXPECT_TRUE((a.state.q.array() == b.state.q.array()).all());
  EXPECT_EQ(a.factorizations, b.factorizations);
}

/// Slack fabric lays itself in folds of single triangles. Before crushed triangles resisted, this one stalled.
TEST(Layouts, FoldsOfSlackFabricSettle) {
  const Layout layout(52, {});
  const Equilibrium e = layout.settled();
  EXPECT_EQ(e.verdict, Verdict::kStable) << e.message;
  EXPECT_TRUE(verdict_is_true(*layout.problem, e));
  EXPECT_LT(layout.smallest_stretch(e.state), 0.5);
  EXPECT_GT(layout.smallest_stretch(e.state), 0.05);
  EXPECT_LE(e.factorizations, 60);
}

TEST(Layouts, SlackFabricIsNamedWhereNoShapeWasReached) {
  const Layout layout(2, kSmall);
  SolveOptions options;
  options.max_iterations = 40;
  const Equilibrium e = solve(*layout.problem, start_state(*layout.problem, layout.model.poses[0]), 1, options);
  EXPECT_EQ(e.verdict, Verdict::kIterationLimit);
  EXPECT_LT(layout.smallest_stretch(e.state), 1);
  EXPECT_NE(e.message.find("the fabric has gone slack, least stretch 0."), std::string::npos) << e.message;
  EXPECT_NE(e.message.find("make the rods thicker"), std::string::npos) << e.message;
}

/// A flat rod that is straight and held by points alone can be turned about its axis, and nothing moves.
TEST(Layouts, ARodThatSpinsMakesNoShapeCritical) {
  const Layout layout(22, {});
  const Equilibrium e = layout.settled();
  EXPECT_EQ(e.verdict, Verdict::kStable) << e.message;
  EXPECT_TRUE(verdict_is_true(*layout.problem, e));
  EXPECT_EQ(e.spins, 1);
  EXPECT_NE(e.message.find("1 straight rod turns about its own axis"), std::string::npos) << e.message;
  ASSERT_GT(e.modes.size(), 1u);
  EXPECT_GT(e.modes[1].stiffness, 1e3 * std::abs(e.modes[0].stiffness));
}

}  // namespace
}  // namespace lissom
