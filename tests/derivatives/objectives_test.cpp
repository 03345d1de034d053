/// Derivatives of all objectives against differences, in unknowns and in rest numbers.

#include "lissom/design/objectives.h"

#include <algorithm>
#include <set>

#include "lissom/design/objective_stability_margin.h"
#include "tests/derivatives/objective_cases.h"

namespace lissom {
namespace {

using namespace objective_tests;

/// A quantity by its values at steps h, h/2, h/4 with errors of h^2, h^4, ...
template <class Value, class F>
Value extrapolated(double h, const F& at) {
  const Value a = at(h), b = at(h / 2), c = at(h / 4);
  const Value ab = (4 * b - a) / 3, bc = (4 * c - b) / 3;
  return (16 * bc - ab) / 15;
}

struct Direction {
  VecX dq, dn;
};

/// Along unknowns, along rest numbers, along both.
std::vector<Direction> directions(const Shape& shape, double amplitude) {
  std::mt19937 random(11);
  std::vector<Direction> all;
  for (int k = 0; k < 3; ++k) {
    Direction d{random_motion(shape.design.system, random, amplitude), random_numbers(shape, random, amplitude)};
    if (k == 0) d.dn.setZero();
    if (k == 1) d.dq.setZero();
    all.push_back(d);
  }
  return all;
}

constexpr double kRounding = 4e-15;  // of a component, which is a sum of rounded numbers

class Objectives : public testing::TestWithParam<JointKind> {
 protected:
  void SetUp() override {
    // Grown so far that no rod is without axial strain, of which rod strains take the size.
    shape_ = make_shape(model_of_everything(GetParam()), 0.15, 0.5);
    ASSERT_NE(shape_, nullptr);
    cases_ = cases_of(*shape_);
  }
  std::unique_ptr<Shape> shape_;
  std::vector<Case> cases_;
};

TEST_P(Objectives, ComponentsAreWhatTheirDefinitionSays) {
  const VecX still = VecX::Zero(shape_->unknowns()), same = VecX::Zero(shape_->numbers());
  for (const Case& c : cases_) {
    SCOPED_TRACE(c.label);
    VecX values;
    c.objective->values(shape_->pose_shape(), values);
    ASSERT_EQ(values.size(), c.objective->size());
    ASSERT_GT(values.norm(), 0);
    EXPECT_LT((values - c.components(still, same)).norm(), 1e-11 * values.norm());
    EXPECT_GT(c.objective->scale(shape_->pose_shape()), 0);
    const ObjectiveInfo* info = find_objective(c.objective->name());
    ASSERT_NE(info, nullptr) << c.objective->name();
    EXPECT_EQ(info->unit, c.objective->unit());
  }
}

TEST_P(Objectives, FirstDerivativesMatchDifferences) {
  for (const Case& c : cases_) {
    SCOPED_TRACE(c.label);
    SparseRows by_q, by_numbers;
    c.objective->jacobian(shape_->pose_shape(), by_q, by_numbers);
    ASSERT_EQ(by_q.rows(), c.objective->size());
    ASSERT_EQ(by_q.cols(), shape_->unknowns());
    ASSERT_EQ(by_numbers.rows(), c.objective->size());
    ASSERT_EQ(by_numbers.cols(), shape_->numbers());
    EXPECT_GT(by_q.norm() + by_numbers.norm(), 0);
    VecX values;
    c.objective->values(shape_->pose_shape(), values);
    for (const Direction& d : directions(*shape_, 1)) {
      const VecX exact = by_q * d.dq + by_numbers * d.dn;
      const VecX difference = extrapolated<VecX>(c.step, [&](double h) {
        return ((c.components(h * d.dq, h * d.dn) - c.components(-h * d.dq, -h * d.dn)) / (2 * h)).eval();
      });
      const double rounding = kRounding * values.norm() / (c.step / 4);
      EXPECT_LT((exact - difference).norm(), 1e-7 * exact.norm() + rounding) << "of " << exact.norm();
    }
  }
}

TEST_P(Objectives, SecondDerivativesMatchDifferences) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int curved = 0;
  for (const Case& c : cases_) {
    SCOPED_TRACE(c.label);
    ASSERT_TRUE(c.objective->has_curvature());
    VecX y(c.objective->size()), values;
    for (double& entry : y) entry = uniform(random);
    c.objective->values(shape_->pose_shape(), values);
    const std::vector<Direction> all = directions(*shape_, 1);
    bool any = false;
    for (const auto& [first, second] : {std::pair{0, 2}, {1, 2}}) {
      const Direction &a = all[first], &b = all[second];
      const auto product = [&](const Direction& along, const Direction& against) {
        VecX by_q = VecX::Zero(shape_->unknowns()), by_numbers = VecX::Zero(shape_->numbers());
        c.objective->curvature(shape_->pose_shape(), y, along.dq, along.dn, by_q, by_numbers);
        return by_q.dot(against.dq) + by_numbers.dot(against.dn);
      };
      const double exact = product(a, b), swapped = product(b, a);
      const auto at = [&](double s, double t) { return y.dot(c.components(s * a.dq + t * b.dq, s * a.dn + t * b.dn)); };
      const double difference = extrapolated<double>(
          c.step, [&](double h) { return (at(h, h) - at(h, -h) - at(-h, h) + at(-h, -h)) / (4 * h * h); });
      const double rounding = kRounding * y.cwiseProduct(values).cwiseAbs().sum() / (c.step * c.step / 16);
      EXPECT_NEAR(exact, difference, 1e-6 * std::abs(exact) + rounding);
      EXPECT_NEAR(exact, swapped, 1e-9 * std::abs(exact) + 1e-3 * rounding);
      any = any || std::abs(exact) > 1e4 * rounding;
    }
    curved += any;
  }
  EXPECT_GE(curved, 11);  // the others are linear, or nearly
}

TEST_P(Objectives, CurvatureIsAdded) {
  const std::vector<Direction> all = directions(*shape_, 1);
  for (const Case& c : cases_) {
    SCOPED_TRACE(c.label);
    const VecX y = VecX::Ones(c.objective->size());
    VecX q = VecX::Zero(shape_->unknowns()), numbers = VecX::Zero(shape_->numbers());
    c.objective->curvature(shape_->pose_shape(), y, all[2].dq, all[2].dn, q, numbers);
    VecX q_more = VecX::Ones(q.size()), numbers_more = VecX::Ones(numbers.size());
    c.objective->curvature(shape_->pose_shape(), y, all[2].dq, all[2].dn, q_more, numbers_more);
    EXPECT_LT((q_more - q - VecX::Ones(q.size())).norm(), 1e-12 * (q.norm() + 10));
    EXPECT_LT((numbers_more - numbers - VecX::Ones(numbers.size())).norm(), 1e-12 * (numbers.norm() + 10));
  }
}

TEST_P(Objectives, RigidMotionsChangeNothingThatIsMeasuredWithin) {
  const PoseShape here = shape_->pose_shape();
  const State moved = rigidly_moved(shape_->design.system, shape_->state, rotation_from_vector({0.7, -1.1, 0.4}),
                                    {0.1, 0.2, 0.3}, {-1, 2, 0.5});
  int compared = 0;
  for (const Case& c : cases_) {
    if (c.rigid != Rigid::kSame) continue;
    SCOPED_TRACE(c.label);
    VecX before, after;
    c.objective->values(here, before);
    c.objective->values({here.design, here.pose, here.problem, moved}, after);
    EXPECT_LT((after - before).norm(), 1e-11 * before.norm());
    // Hence no derivative along a translation.
    SparseRows by_q, by_numbers;
    c.objective->jacobian(here, by_q, by_numbers);
    VecX shift = VecX::Zero(shape_->unknowns());
    for (int i = 0; i < 3 * shape_->design.system.layout.nodes(); ++i) shift[i] = i % 3 == 1 ? 1 : 0.5;
    EXPECT_LE((by_q * shift).norm(), 1e-11 * by_q.norm());
    ++compared;
  }
  EXPECT_GE(compared, 10);
}

TEST_P(Objectives, EveryOneOfTheListIsTested) {
  std::set<std::string_view> tested;
  for (const Case& c : cases_) tested.insert(c.objective->name());
  tested.insert(make_stability_margin()->name());  // in stability_margin_test.cpp
  for (const ObjectiveInfo& info : objectives()) {
    EXPECT_TRUE(tested.contains(info.name)) << info.name;
    EXPECT_FALSE(info.meaning.empty());
  }
  EXPECT_EQ(tested.size(), objectives().size());
  EXPECT_EQ(find_objective("no such thing"), nullptr);
}

INSTANTIATE_TEST_SUITE_P(Joints, Objectives, testing::Values(JointKind::kExplicit, JointKind::kCorotational),
                         joint_name);

}  // namespace
}  // namespace lissom
