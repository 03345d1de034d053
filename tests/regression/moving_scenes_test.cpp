/// The windmills and the sphere move as the thesis shows, and keep their energy.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <vector>

#include "lissom/motion/motion.h"
#include "scenes/scene_models.h"

namespace lissom {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

MotionResult play(const Model& model, const std::vector<std::string>& sets, const Vec3& axis) {
  MotionOptions options;
  for (const std::string& set : sets) {
    MotionWatch watch;
    watch.nodes.kind = Selector::Kind::kSet;
    watch.nodes.name = set;
    watch.axis = axis;
    options.watches.push_back(watch);
  }
  const Result<System> system = make_system(model);
  EXPECT_TRUE(system.ok()) << system.error().text();
  Result<MotionResult> result = simulate(model, system.value(), model.motions[0], "/motions/0", options);
  EXPECT_TRUE(result.ok()) << result.error().text();
  EXPECT_EQ(result.value().verdict, MotionVerdict::kFinished) << result.value().message;
  return std::move(result).value();
}

/// Nothing is damped, so nothing is lost.
void expect_balance(const Model& model, const MotionResult& motion) {
  EXPECT_EQ(model.motions[0].rho_infinity, 1);
  EXPECT_EQ(model.motions[0].mass_damping, 0);
  EXPECT_EQ(model.motions[0].stiffness_damping, 0);
  EXPECT_LT(motion.balance_error(), 0.01);
}

TEST(MovingScenes, TwistOfTheAxisTurnsIntoBendingAndTurningOfTheBlades) {
  const Model model = scene_models::windmill();
  const MotionResult motion = play(model, {"thin", "medium", "thick"}, Vec3::UnitX());
  expect_balance(model, motion);
  const System system = make_system(model).value();
  double momentum[3] = {0, 0, 0}, bent[3] = {0, 0, 0};
  for (size_t i = 0; i < motion.records.size(); ++i) {
    for (int w = 0; w < 3; ++w) {
      momentum[w] = std::max(momentum[w], std::abs(motion.records[i].watches[w].angular_momentum));
      // How much nearer the end of the first blade has come to the hub.
      const StructureRod& blade = system.structure.rods[5 * w + 1];
      const int hub = blade.nodes.front(), end = blade.nodes.back();
      const State& state = motion.states[i];
      bent[w] = std::max(bent[w], 1 - (state.position(end) - state.position(hub)).norm() / 0.07);
    }
  }
  EXPECT_NEAR(motion.records.front().watches[0].turn, 150 * kDegree, 1 * kDegree);
  EXPECT_GT(momentum[1], 1.5 * momentum[0]);
  EXPECT_GT(momentum[2], 1.3 * momentum[1]);
  EXPECT_LT(bent[0], 0.05);
  EXPECT_GT(bent[1], bent[0]);
  EXPECT_GT(bent[2], 0.3);
}

TEST(MovingScenes, SphereGoesStraightDownAndThenTwists) {
  const Model model = scene_models::sphere();
  const MotionResult motion = play(model, {"top"}, Vec3::UnitZ());
  expect_balance(model, motion);
  double early = 0, late = 0;
  for (const MotionRecord& record : motion.records) {
    double& turn = record.load_factor < 0.33 ? early : late;
    turn = std::max(turn, std::abs(record.watches[0].turn));
  }
  EXPECT_LT(early, 1 * kDegree);
  EXPECT_GT(late, 90 * kDegree);
}

}  // namespace
}  // namespace lissom
