/// A toy of tetrahedra and a hat of felt, both soft in places, pulled far: the solver ends in stable shapes, and soon.

#include "bench/deformers.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "bench/first_pose.h"
#include "lissom/equilibrium/solve.h"
#include "lissom/mechanics/solid_strain.h"

namespace lissom {
namespace {

struct Posed {
  FirstPose ready;
  Equilibrium equilibrium;

  explicit Posed(const Model& model) : ready(first_pose("deformer", model)) {
    if (ready.problem) equilibrium = solve(*ready.problem, start_state(*ready.problem, model.poses[0]), 1, {});
  }
  double least_volume_ratio() const {
    const std::vector<double> ratios = volume_ratios(*ready.system, equilibrium.state);
    return *std::min_element(ratios.begin(), ratios.end());
  }
  double farthest() const {
    double farthest = 0;
    for (int i = 0; i < ready.system->layout.nodes(); ++i) {
      farthest = std::max(farthest, (equilibrium.state.position(i) - ready.system->structure.nodes[i]).norm());
    }
    return farthest;
  }
};

TEST(Deformers, TailOfAToyIsPulledByAQuarterOfItsLength) {
  const Posed toy(deformers::toy(16));
  ASSERT_TRUE(toy.ready.problem);
  EXPECT_GT(toy.ready.system->structure.tetrahedra.size(), 10000u);
  EXPECT_EQ(toy.equilibrium.verdict, Verdict::kStable) << toy.equilibrium.message;
  EXPECT_LE(toy.equilibrium.factorizations, 30);
  EXPECT_NEAR(toy.farthest(), 0.05, 0.003);
  EXPECT_GT(toy.least_volume_ratio(), 0.5);
}

TEST(Deformers, ToyIsPulledByForces) {
  Model model = deformers::toy(8);
  PointForce pull;
  pull.at = model.poses[0].supports.back().at;
  pull.force = Vec3(0.6, 0.9, 1.5);
  pull.shared = true;
  model.poses[0].supports.pop_back();
  model.poses[0].forces.push_back(pull);
  const Posed toy(model);
  ASSERT_TRUE(toy.ready.problem);
  EXPECT_EQ(toy.equilibrium.verdict, Verdict::kStable) << toy.equilibrium.message;
  EXPECT_LE(toy.equilibrium.factorizations, 40);
  EXPECT_GT(toy.farthest(), 0.05);
  EXPECT_GT(toy.least_volume_ratio(), 0);
}

/// In one step the brim would fold through itself, and the solve end there with forces left.
TEST(Deformers, BrimOfAHatIsTurnedUp) {
  const Posed hat(deformers::hat(27));
  ASSERT_TRUE(hat.ready.problem);
  EXPECT_EQ(hat.equilibrium.verdict, Verdict::kStable) << hat.equilibrium.message;
  EXPECT_LE(hat.equilibrium.factorizations, 250);
  EXPECT_LT(hat.equilibrium.energy, 0.4);
  double sharpest = 0;
  for (const StructureHinge& h : hat.ready.system->structure.hinges) {
    const auto at = [&](int i) { return hat.equilibrium.state.position(h.node[i]); };
    const Vec3 left = (at(1) - at(0)).cross(at(2) - at(0)), right = (at(3) - at(0)).cross(at(1) - at(0));
    sharpest = std::max(sharpest, std::acos(std::clamp(left.normalized().dot(right.normalized()), -1.0, 1.0)));
  }
  EXPECT_LT(sharpest, 2.5);
}

TEST(Deformers, HatIsPulledSoftly) {
  Model model = deformers::hat(16);
  Pose& pose = model.poses[0];
  pose.supports.resize(1);
  SoftPin pull;
  pull.at = deformers::in_box(Vec3(0.14, -0.03, -1), Vec3(1, 0.03, 0.001));
  pull.stiffness = 100;
  pull.target = Vec3(0.1, 0, 0.09);
  pose.soft_pins.push_back(pull);
  const Posed hat(model);
  ASSERT_TRUE(hat.ready.problem);
  EXPECT_EQ(hat.equilibrium.verdict, Verdict::kStable) << hat.equilibrium.message;
  EXPECT_LE(hat.equilibrium.factorizations, 120);
  EXPECT_GT(hat.farthest(), 0.05);
}

}  // namespace
}  // namespace lissom
