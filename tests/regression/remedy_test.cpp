/// The remedy against slack fabric, as solving finds it.

#include <gtest/gtest.h>

#include "bench/fabric_problems.h"
#include "lissom/equilibrium/solve.h"
#include "lissom/session/solved_remedy.h"

namespace lissom {
namespace {

Equilibrium released(const Model& model) {
  const Result<System> system = make_system(model);
  EXPECT_TRUE(system.ok()) << system.error().text();
  const Result<StaticProblem> problem = make_static_problem(model, system.value(), model.poses[0], "/poses/0");
  EXPECT_TRUE(problem.ok()) << problem.error().text();
  return solve(problem.value(), start_state(problem.value(), model.poses[0]), 1, {});
}

TEST(SolvedRemedy, MakesSlackFabricTautInAboutTheSameShape) {
  networks::SquareFrame frame;
  frame.cells = 12;
  frame.r_b = 0.2e-3;  // the case whose fabric sags [mathematics 8]
  const Model model = networks::square_frame_on_fabric(frame);
  const Equilibrium slack = released(model);
  ASSERT_EQ(slack.verdict, Verdict::kStable);
  const std::optional<SolvedRemedy> solved =
      solved_remedy(model, model.poses[0], "/poses/0", slack, 1.02, 1.05, {}, {});
  ASSERT_TRUE(solved.has_value());
  EXPECT_GE(solved->smallest_stretch, 1.02);
  EXPECT_LT(solved->moved, 0.05 * frame.side);
  EXPECT_GT(solved->remedy.pre_stretch[0], frame.pre_stretch);
  EXPECT_GT(solved->remedy.radius_factor, 1);
  // What is promised holds for the design solved from its own start.
  const Model changed =
      remedied(model, solved->remedy.pre_stretch[0] / frame.pre_stretch, solved->remedy.radius_factor);
  EXPECT_EQ(changed.membranes[0].pre_stretch, solved->remedy.pre_stretch);
  const Equilibrium again = released(changed);
  ASSERT_EQ(again.verdict, Verdict::kStable);
  const std::string text = solved_remedy_text(*solved);
  EXPECT_NE(text.find("the smallest stretch is 1.0"), std::string::npos) << text;
}

TEST(SolvedRemedy, IsNotOfferedForShapesThatAreNotStable) {
  const Model model = networks::square_frame_on_fabric({});
  Equilibrium unfinished = released(model);
  unfinished.verdict = Verdict::kIterationLimit;
  EXPECT_FALSE(solved_remedy(model, model.poses[0], "/poses/0", unfinished, 1.02, 1.05, {}, {}).has_value());
}

}  // namespace
}  // namespace lissom
