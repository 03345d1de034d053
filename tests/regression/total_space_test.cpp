/// Total space: its point and its products, against differences and the reduced problem.

#include "lissom/design/total_space.h"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <utility>

#include "lissom/design/load_space.h"
#include "lissom/design/rest_shape.h"
#include "lissom/equilibrium/step_path.h"
#include "tests/regression/design_samples.h"
#include "tests/regression/honeycomb.h"
#include "tests/regression/loaded_frame.h"
#include "tests/regression/total_samples.h"

namespace lissom {
namespace {

using total::leave;
using total::some_vector;
using total::space_of;

TEST(TotalSpace, BeginsAtThePointOfItsProblem) {
  const auto problem = total::cantilever_problem(0);
  const auto space = space_of(*problem);
  EXPECT_EQ(space->x(), problem->x());
  EXPECT_EQ(space->residual(), problem->residual());
  EXPECT_LE(space->imbalance(), 1);
  int unknowns = 0;
  for (const auto& pose : problem->poses()) unknowns += pose->problem().supports.unknowns();
  EXPECT_EQ(space->states(), unknowns);
  ASSERT_TRUE(space->linearize());
  EXPECT_EQ(space->negative(), 0);
  // S, and the gradient that is left when states follow, are those of the reduced problem.
  const VecX g = space->gradient();
  const VecX reduced = space->sensitivity().transpose() * g.head(space->states()) + g.tail(space->parameters());
  EXPECT_LT((reduced - problem->gradient()).norm(), 1e-9 * reduced.norm());
}

void expect_first_derivatives(const StructureProblem& problem) {
  const auto space = space_of(problem);
  ASSERT_TRUE(space->linearize());
  // In equilibrium, where re-anchoring changes nothing [mathematics 1.8].
  const VecX v = some_vector(space->size(), 0.7), w = some_vector(space->states(), 2.3);
  const VecX image = space->constraint_times(v);
  const double slope = space->gradient().dot(v);
  EXPECT_NEAR(w.dot(image), space->constraint_transposed_times(w).dot(v), 1e-12 * image.norm());
  EXPECT_LT((space->solve(space->hessian() * w) - w).norm(), 1e-8);
  VecX again[2];
  double slope_again[2];
  for (int level = 0; level < 2; ++level) {
    const double h = 0.02 / (level + 1);
    VecX sides[2];
    double changes[2];
    for (int side = 0; side < 2; ++side) {
      ASSERT_TRUE(space->attempt(side == 0 ? VecX(-v) : v, h));
      sides[side] = space->attempted_constraint();
      changes[side] = space->attempted_change();
    }
    again[level] = (sides[1] - sides[0]) / (2 * h);
    slope_again[level] = (changes[1] - changes[0]) / (2 * h);
  }
  const VecX expected = (4 * again[1] - again[0]) / 3;
  EXPECT_LT((image - expected).norm(), 1e-7 * image.norm());
  EXPECT_NEAR(slope, (4 * slope_again[1] - slope_again[0]) / 3, 1e-7 * space->gradient().norm());
}

/// Along equilibria the Hessian is that of the reduced problem.
void expect_reduced_hessian(StructureProblem& problem) {
  const auto space = space_of(problem);
  ASSERT_TRUE(space->linearize());
  const int n = space->states(), m = space->parameters();
  const VecX lambda = -space->solve(space->gradient().head(n)), v = some_vector(m, 0.4);
  const MatX s = space->sensitivity();
  VecX along(n + m);
  along << s * v, v;
  const VecX image = space->lagrangian_times(lambda, along), expected = problem.hessian_times(v);
  EXPECT_LT((s.transpose() * image.head(n) + image.tail(m) - expected).norm(), 1e-8 * expected.norm());
}

TEST(TotalSpace, DerivativesOfARodAgreeWithDifferences) {
  const auto problem = total::cantilever_problem(2e-3);
  expect_first_derivatives(*problem);
  expect_reduced_hessian(*problem);
}

/// With rotations among the unknowns, or slaved to the rods; soft pins, and wishes about the parameters.
void expect_derivatives_of_a_network(JointKind joints) {
  const auto problem = samples::honeycomb_problem(samples::honeycomb(joints));
  const Status released = problem->release();
  ASSERT_TRUE(released) << released.error().text();
  expect_first_derivatives(*problem);
  expect_reduced_hessian(*problem);
}

TEST(TotalSpace, DerivativesWithExplicitJoints) { expect_derivatives_of_a_network(JointKind::kExplicit); }
TEST(TotalSpace, DerivativesWithCorotationalJoints) { expect_derivatives_of_a_network(JointKind::kCorotational); }

/// What is held, targets of pins and loads follow the parameters; a rail holds an oblique direction.
TEST(TotalSpace, DerivativesWhereSupportsFollowTheParameters) {
  for (const JointKind joints : {JointKind::kExplicit, JointKind::kCorotational}) {
    Model model = samples::loaded_frame(joints);
    model.poses[1].moments.clear();
    const auto base = samples::base_of(model);
    const auto shape = std::make_shared<const LinearSpace>(
        samples::made(rest_shape_space(base, {ControlStage::kMiddle, 0.02, RestShapeGauge::kFree})));
    const auto loads = std::make_shared<const LinearSpace>(
        samples::made(load_space(base, {{LoadKind::kMove, 1, 1, LoadPart::kSize, {0, 0.02}},
                                        {LoadKind::kLineLoad, 1, 0, LoadPart::kX, {-5, 5}}})));
    const std::vector<Vec3>& drawn = base->system.structure.nodes;
    VecX places(3 * static_cast<Eigen::Index>(drawn.size()));
    for (int i = 0; i < static_cast<int>(drawn.size()); ++i) {
      places.segment<3>(3 * i) = drawn[i] + 2e-3 * Vec3(std::sin(i), std::cos(2 * i), std::sin(1.0 + i));
    }
    const auto space = std::make_shared<const SumSpace>(samples::made(SumSpace::make({shape, loads})));
    const auto problem = total::problem_of(space, {places, places});
    const VecX p = samples::uneven(*space, 0.05);
    const Status released = problem->release(&p);
    ASSERT_TRUE(released) << released.error().text();
    expect_first_derivatives(*problem);
    expect_reduced_hessian(*problem);
  }
}

/// h + lambda'c at the point of a problem of one pose moved by v, of the functions anchored at the point.
class Lagrangian {
 public:
  Lagrangian(const StructureProblem& problem, const TotalSpace& space, const VecX& lambda)
      : problem_(problem), space_(space), from_(space.point()) {
    VecX padded = VecX::Zero(space.size());
    padded.head(lambda.size()) = lambda;
    const Scales& scales = problem.poses()[0]->problem().scales;
    lambda_ = space.increment(0, padded) / (scales.force * 0.01 * scales.length);
  }

  double at(const VecX& v) const {
    VecX p = from_.p;
    for (int i = 0; i < p.size(); ++i) p[i] += problem_.space().parameters()[i].scale * v[space_.states() + i];
    const Design design = problem_.space().at(p).value();
    const int pose = problem_.poses()[0]->pose();
    const StaticProblem at = make_static_problem(design.model, design.system, design.model.poses[pose], "").value();
    const VecX dq = space_.increment(0, v);
    State moved;
    EXPECT_TRUE(advance(design.system, from_.states[0], dq, moved));
    VecX gradient;
    AssemblyBuffers buffers;
    at.potential.gradient(moved, gradient, buffers);
    to_anchored_gradient(design.system, from_.states[0], moved, dq, gradient);
    const PoseShape shape{design, design.model.poses[pose], at, moved};
    return 0.5 * goal_residual(problem_.goals()[0], shape).squaredNorm() + lambda_.dot(gradient);
  }

  /// Second derivative along v at 0, extrapolated once.
  double curvature(const VecX& v) const {
    const double here = at(VecX::Zero(v.size()));
    const auto second = [&](double h) { return (at(h * v) - 2 * here + at(-h * v)) / (h * h); };
    return (4 * second(0.02) - second(0.04)) / 3;
  }

 private:
  const StructureProblem& problem_;
  const TotalSpace& space_;
  DesignPoint from_;
  VecX lambda_;
};

TEST(TotalSpace, SecondDerivativesAgreeWithDifferencesAwayFromEquilibrium) {
  const auto problem = total::strut_problem();
  const auto space = space_of(*problem);
  leave(*space, 0.5);
  const VecX lambda = 10 * some_vector(space->states(), 0.9);
  const VecX v = some_vector(space->size(), 0.2), w = some_vector(space->size(), 1.4);
  const VecX image = space->lagrangian_times(lambda, v);
  EXPECT_NEAR(w.dot(image), v.dot(space->lagrangian_times(lambda, w)), 1e-10 * image.norm());
  const Lagrangian lagrangian(*problem, *space, lambda);
  const double size = image.norm();
  EXPECT_NEAR(v.dot(image), lagrangian.curvature(v), 1e-5 * size);
  EXPECT_NEAR(w.dot(image), 0.25 * (lagrangian.curvature(v + w) - lagrangian.curvature(v - w)), 1e-5 * size);
  // Of node positions r is linear: without multipliers the exact product is Gauss and Newton's.
  const VecX plain = space->gauss_newton_times(v);
  EXPECT_LT((space->lagrangian_times(VecX::Zero(space->states()), v) - plain).norm(), 1e-10 * plain.norm());
  EXPECT_GT((image - plain).norm(), 1e-2 * image.norm());
}

TEST(TotalSpace, RefusesWhatItDoesNotKnow) {
  Model model = total::cantilever();
  model.poses[1].moments.push_back({scene_models::rod_place("arm", 1), Vec3(0, 0, 1e-4)});
  const int nodes = static_cast<int>(make_system(model).value().structure.nodes.size());
  const auto turned = total::started(total::radii_of(model, {1e-3, 4e-3}), std::vector<VecX>(2, VecX::Zero(3 * nodes)));
  const auto refused = TotalSpace::make(*turned, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().where, "/poses/1/moments");
}

}  // namespace
}  // namespace lissom
