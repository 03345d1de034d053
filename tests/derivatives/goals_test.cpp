/// Goals as residuals: weights, sides, both orders of derivatives, and what is refused.

#include "lissom/design/goal.h"
#include "lissom/design/network_radii.h"
#include "lissom/design/objective_stability_margin.h"
#include "lissom/design/parameter_goals.h"
#include "tests/derivatives/objective_cases.h"

namespace lissom {
namespace {

using namespace objective_tests;

class Goals : public testing::TestWithParam<GoalKind> {
 protected:
  void SetUp() override {
    shape_ = make_shape(model_of_everything(JointKind::kExplicit), 0.15, 0.5);
    ASSERT_NE(shape_, nullptr);
  }
  /// Targets on both sides of the values.
  Goal goal(std::shared_ptr<const Objective> objective) const {
    Goal g;
    g.name = "goal";
    g.objective = std::move(objective);
    g.kind = GetParam();
    g.objective->values(shape_->pose_shape(), g.target);
    g.weights.resize(g.target.size());
    for (int i = 0; i < g.target.size(); ++i) {
      g.target[i] *= i % 2 == 0 ? 0.9 : 1.05;
      g.weights[i] = 1 + i % 3;
    }
    g.scale = 0.02;
    g.weight = 3;
    return g;
  }
  double half_square(const Goal& g, const Components& components, const VecX& dq, const VecX& dn) const {
    const VecX deviation = (g.weight * g.weights).cwiseSqrt().cwiseProduct(components(dq, dn) - g.target) / g.scale;
    double sum = 0;
    for (const double d : deviation) {
      const bool counts = g.kind == GoalKind::kReach || (g.kind == GoalKind::kAtMost) == (d > 0);
      if (counts) sum += d * d / 2;
    }
    return sum;
  }
  std::unique_ptr<Shape> shape_;
};

TEST_P(Goals, BothOrdersMatchDifferences) {
  std::mt19937 random(2);
  for (const auto& objective :
       {make_smallest_stretch(shape_->design.system.structure), make_rod_strain(shape_->design.system),
        make_node_positions({3, 7, 1}), make_mass(), make_membrane_area()}) {
    SCOPED_TRACE(objective->name());
    const Goal g = goal(objective);
    ASSERT_TRUE(check_goal(g, "/goals/0").ok());
    const Components components = by_advance(*shape_, *objective);
    const PoseShape here = shape_->pose_shape();
    const VecX r = goal_residual(g, here), still = VecX::Zero(shape_->unknowns()), same = VecX::Zero(shape_->numbers());
    const double value = half_square(g, components, still, same);
    EXPECT_NEAR(r.squaredNorm() / 2, value, 1e-12 * value);
    SparseRows j_q, j_numbers;
    goal_jacobian(g, here, j_q, j_numbers);
    const VecX dq = random_motion(shape_->design.system, random, 1), dn = random_numbers(*shape_, random, 1);
    const VecX eq = random_motion(shape_->design.system, random, 1), en = random_numbers(*shape_, random, 1);
    const auto at = [&](double s, double t) { return half_square(g, components, s * dq + t * eq, s * dn + t * en); };
    const auto extrapolate = [](const auto& by_step) {
      const double h = 1e-3, a = by_step(h), b = by_step(h / 2), c = by_step(h / 4);
      return (16 * (4 * c - b) / 3 - (4 * b - a) / 3) / 15;
    };
    const double slope = r.dot(j_q * dq + j_numbers * dn);
    EXPECT_NEAR(slope, extrapolate([&](double h) { return (at(h, 0) - at(-h, 0)) / (2 * h); }),
                1e-7 * std::abs(slope) + 1e-10 * value);
    VecX q = VecX::Zero(still.size()), numbers = VecX::Zero(same.size());
    add_goal_second_order(g, here, SecondOrder::kExact, dq, dn, q, numbers);
    const double exact = q.dot(eq) + numbers.dot(en);
    const double difference =
        extrapolate([&](double h) { return (at(h, h) - at(h, -h) - at(-h, h) + at(-h, -h)) / (4 * h * h); });
    EXPECT_NEAR(exact, difference, 1e-5 * std::abs(exact) + 1e-7 * value);
    q.setZero();
    numbers.setZero();
    add_goal_second_order(g, here, SecondOrder::kGaussNewton, dq, dn, q, numbers);
    const double gauss_newton = (j_q * dq + j_numbers * dn).dot(j_q * eq + j_numbers * en);
    EXPECT_NEAR(q.dot(eq) + numbers.dot(en), gauss_newton, 1e-11 * std::abs(gauss_newton));
  }
}

TEST_P(Goals, OnlyTheWrongSideCounts) {
  const Goal g = goal(make_smallest_stretch(shape_->design.system.structure));
  const VecX r = goal_residual(g, shape_->pose_shape());
  SparseRows by_q, by_numbers;
  goal_jacobian(g, shape_->pose_shape(), by_q, by_numbers);
  for (int i = 0; i < r.size(); ++i) {
    const bool above = i % 2 == 0;  // of the target
    const bool counts = g.kind == GoalKind::kReach || (g.kind == GoalKind::kAtMost) == above;
    EXPECT_EQ(r[i] != 0, counts) << i;
    EXPECT_EQ(by_q.row(i).norm() > 0, counts) << i;
  }
}

std::string kind_name(const testing::TestParamInfo<GoalKind>& kinds) {
  constexpr const char* kNames[] = {"Reach", "AtMost", "AtLeast"};
  return kNames[static_cast<int>(kinds.param)];
}
INSTANTIATE_TEST_SUITE_P(Kinds, Goals, testing::Values(GoalKind::kReach, GoalKind::kAtMost, GoalKind::kAtLeast),
                         kind_name);

TEST(GoalWeights, MakeRootMeanSquares) {
  const auto shape = make_shape(model_of_everything(JointKind::kExplicit), 0.1);
  ASSERT_NE(shape, nullptr);
  Goal g;
  g.name = "places";
  g.objective = make_node_positions({1, 4, 6});
  g.objective->values(shape->pose_shape(), g.target);
  const Vec3 miss(3e-3, -4e-3, 12e-3);
  for (int k = 0; k < 3; ++k) g.target.segment<3>(3 * k) += (k + 1) * miss;
  const auto weights = weights_of_places(Vec3(2, 0, 6), 3, "/weights");
  ASSERT_TRUE(weights.ok());
  g.weights = weights.value();
  g.scale = 0.01;
  const double rms = 13e-3 * std::sqrt(0.25 * 1 + 0.75 * 9);
  EXPECT_NEAR(goal_residual(g, shape->pose_shape()).norm() * g.scale, rms, 1e-15);
  ASSERT_TRUE(weights_of_places(Vec3(1e308, 1e308, 1e308), 1, "/weights").ok());
  EXPECT_NEAR(weights_of_places(Vec3(1e308, 1e308, 1e308), 1, "/weights").value().sum(), 1, 1e-15);
  EXPECT_EQ(weights_of_places(Vec3(1, -1, 0), 1, "/weights").error().where, "/weights/1");
  EXPECT_EQ(weights_of_places(Vec3(1, 1, NAN), 1, "/weights").error().where, "/weights/2");
  EXPECT_EQ(weights_of_places(Vec3(0, 0, 0), 1, "/weights").error().where, "/weights");
  EXPECT_EQ(weights_of_places(VecX(), 1, "/weights").error().where, "/weights");
}

TEST(GoalChecks, NameWhatIsWrong) {
  Goal good;
  good.name = "pose \"bent\": node positions";
  good.objective = make_node_positions({0, 1});
  good.target = VecX::Zero(6);
  good.weights = VecX::Ones(6);
  const auto place = [&](const auto& spoil) {
    Goal g = good;
    spoil(g);
    const Status s = check_goal(g, "/goals/2");
    return s ? std::string() : s.error().where;
  };
  EXPECT_EQ(place([](Goal&) {}), "");
  EXPECT_EQ(place([](Goal& g) { g.target[4] = NAN; }), "/goals/2/target/4");
  EXPECT_EQ(place([](Goal& g) { g.target[0] = INFINITY; }), "/goals/2/target/0");
  EXPECT_EQ(place([](Goal& g) { g.target.conservativeResize(5); }), "/goals/2/target");
  EXPECT_EQ(place([](Goal& g) { g.weights.resize(0); }), "/goals/2/weights");
  EXPECT_EQ(place([](Goal& g) { g.weights[3] = -1e-9; }), "/goals/2/weights/3");
  EXPECT_EQ(place([](Goal& g) { g.weights.setZero(); }), "/goals/2/weights");
  EXPECT_EQ(place([](Goal& g) { g.scale = 0; }), "/goals/2/scale");
  EXPECT_EQ(place([](Goal& g) { g.scale = NAN; }), "/goals/2/scale");
  EXPECT_EQ(place([](Goal& g) { g.weight = -1; }), "/goals/2/weight");
  EXPECT_TRUE(check_curvature(good).ok());
  good.objective = make_stability_margin();
  EXPECT_EQ(check_curvature(good).error().code, ErrorCode::kUnsupported);
}

TEST(ParameterGoals, ClosenessIsARootMeanSquareOfFeltChanges) {
  const std::vector<Parameter> parameters = {{ParameterKind::kRadius, "a", 0, 1, 0.1},
                                             {ParameterKind::kRadius, "b", 0, 1, 0.2}};
  const ParameterGoal g = make_closeness(parameters, Vec2(3, 4), 5);
  EXPECT_EQ(g.weight, 5);
  EXPECT_NEAR((g.rows * (Vec2(3.3, 3.6) - g.target)).norm(), std::sqrt((9.0 + 4.0) / 2), 1e-12);
}

TEST(ParameterGoals, SmoothnessComparesNeighboursAlongRods) {
  Model model;
  const Vec3 a(0, 0, 0), b(0.1, 0, 0), c(0.2, 0.05, 0);
  model.rods.push_back(rod("one", Polyline{{a, b}}, SectionShape::kEllipse, 1e-3, 1e-3));
  model.rods.push_back(rod("two", Polyline{{b, c}}, SectionShape::kEllipse, 1e-3, 1e-3));
  const Result<System> system = make_system(model);
  ASSERT_TRUE(system.ok());
  const auto radii = NetworkRadii::make(model, system.value().structure, ControlStage::kMiddle, {5e-4, 2e-3});
  ASSERT_TRUE(radii.ok());
  const int controls = radii.value().controls().size();
  ASSERT_EQ(controls, 5);  // three ends, two middles
  const auto pairs = neighbours_along_rods(radii.value().controls(), system.value().structure, std::array{0, controls});
  ASSERT_EQ(pairs.size(), 8u);
  const ParameterGoal g = make_smoothness(radii.value().parameters(), pairs);
  EXPECT_EQ(g.rows.rows(), 10);
  EXPECT_LT((g.rows * VecX::Constant(10, 1e-3)).norm(), 1e-12);
  // A ramp along both rods: ends 0, 2, 4, middles 1, 3; only the two free ends differ from their neighbour.
  VecX p = VecX::Zero(10);
  p.head(5) << 0, 2, 4, 1, 3;
  const double scale = radii.value().parameters()[0].scale;
  EXPECT_NEAR((g.rows * p).norm(), std::sqrt(2.0 / 10) / scale, 1e-9 / scale);
  EXPECT_EQ(make_smoothness(radii.value().parameters(), {}).rows.rows(), 0);
}

}  // namespace
}  // namespace lissom
