// Exploring and pulling at shapes: responses against equilibria solved again, modes that keep their pins, fits that arrive.

#include <gtest/gtest.h>
#include <random>

#include "lissom/design/constrained_step.h"
#include "lissom/design/shape_fit.h"
#include "lissom/design/shape_modes.h"
#include "lissom/design/shape_response.h"
#include "lissom/studio/fit_job.h"
#include "lissom/studio/handle.h"
#include "tests/regression/plan_samples.h"

namespace lissom {
namespace {

PlanSpaceOptions space_options() {
  PlanSpaceOptions options;
  options.radius_range = {0.1e-3, 4e-3};
  options.pre_stretch_range = {1.05, 1.8};
  return options;
}

/// A released plan with what tools need of it.
struct Released {
  std::unique_ptr<LiveDesign> design;
  std::shared_ptr<const ShapeResponse> response;
  HardConstraints constraints;

  Released(const Model& model, const std::vector<int>& pinned) : design(samples::open(model, 1e-9)) {
    const State& state = design->equilibrium().state;
    std::vector<PinnedNode> pins;
    for (const int node : pinned) pins.push_back({node, state.position(node)});
    constraints.pinned = pinned;
    Result<std::shared_ptr<const ShapeResponse>> made = ShapeResponse::make(
        {design->mesh(), design->model(), 0, pinned_down(design->problem(), state, pins)}, space_options(), pins, {});
    EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().text());
    response = made.value();
  }

  int nodes() const { return response->system().layout.nodes(); }
};

/// Nodes of plan points: the first nodes of the fabric.
int node_of_point(const LiveDesign& design, const std::string& name) {
  const std::vector<PlanPoint>& points = design.model().plan->points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].name == name) return design.system().structure.membranes.front().nodes[i];
  }
  ADD_FAILURE() << "no point " << name;
  return 0;
}

/// The equilibrium at p / scale = start + change, pinned down like the response.
State solved_again(const Released& r, const VecX& change) {
  const ShapeResponse& s = *r.response;
  const Result<Design> design = s.space().at(s.p() + s.scale().cwiseProduct(change));
  EXPECT_TRUE(design.ok());
  SolveOptions options;
  options.tolerance = 1e-9;
  options.modes = 0;
  const Context context;
  const auto follower = std::move(PoseFollower::make(*s.space().base(), 0, options, context)).value();
  EXPECT_EQ(follower->restore(*s.space().base(), s.start().state).outcome, Outcome::kSettled);
  const PoseEnd end = follower->attempt(design.value());
  EXPECT_EQ(end.outcome, Outcome::kSettled) << end.reason;
  return pinned_down(follower->problem(), follower->attempted().state, s.pins());
}

VecX random_change(int size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  return VecX::NullaryExpr(size, [&] { return number(random); });
}

/// What is left of displacements (3 per node) at a state when the rigid motion nearest to them is taken out.
VecX without_rigid_motion(const State& state, const VecX& displacements) {
  MatX motions = MatX::Zero(displacements.size(), 6);
  for (Eigen::Index i = 0; i < displacements.size() / 3; ++i) {
    motions.block<3, 3>(3 * i, 0).setIdentity();
    motions.block<3, 3>(3 * i, 3) = -skew(state.position(static_cast<int>(i)));
  }
  return displacements - motions * motions.colPivHouseholderQr().solve(displacements);
}

/// How far the response is from differences, extrapolated to fourth order, of equilibria that were solved again: in all, and
/// in shape alone. Relative.
struct Mismatch {
  double all = 0, shape = 0;
};
Mismatch mismatch(const Released& r) {
  const VecX direction = random_change(r.response->size(), 5);
  const int places = 3 * r.nodes();
  const auto difference = [&](double step) -> VecX {
    return (solved_again(r, step * direction).q - solved_again(r, -step * direction).q).head(places) / (2 * step);
  };
  constexpr double kStep = 4e-3;
  const VecX measured = (4 * difference(kStep) - difference(2 * kStep)) / 3;
  const VecX expected = (r.response->matrix() * direction).head(places);
  const State& state = r.response->start().state;
  return {(measured - expected).norm() / expected.norm(),
          without_rigid_motion(state, measured - expected).norm() / expected.norm()};
}

TEST(ShapeResponse, IsTheChangeOfLaidDownShapes) {
  const Mismatch off = mismatch(Released(samples::ring_with_rods(), {}));
  EXPECT_LT(off.shape, 2e-5);
  // How much nodes count when a shape is laid down changes with the mesh a little, which the response leaves out: it turns the
  // whole by less than can be seen.
  EXPECT_LT(off.all, 2e-3);
}

TEST(ShapeResponse, IsTheChangeOfPinnedShapes) {
  Released probe(samples::ring_with_rods(), {});
  const int e = node_of_point(*probe.design, "e"), n = node_of_point(*probe.design, "n");
  const int free = node_of_point(*probe.design, "free");
  const Mismatch one = mismatch(Released(samples::ring_with_rods(), {e}));
  EXPECT_LT(one.shape, 2e-5);
  EXPECT_LT(one.all, 2e-3);
  EXPECT_LT(mismatch(Released(samples::ring_with_rods(), {e, n, free})).all, 2e-5);
}

TEST(PinnedDown, BringsPinsBackByARigidMotion) {
  Released r(samples::ring_with_rods(), {});
  const State& state = r.design->equilibrium().state;
  std::vector<PinnedNode> pins;
  for (const char* name : {"e", "w", "free"}) {
    const int node = node_of_point(*r.design, name);
    pins.push_back({node, state.position(node)});
  }
  const Mat3 turn = rotation_from_vector(Vec3(0.3, -0.2, 0.5));
  const State moved = rigidly_moved(r.design->system(), state, turn, Vec3(0.01, 0, 0), Vec3(0.02, 0.01, -0.03));
  const State back = pinned_down(r.design->problem(), moved, pins);
  EXPECT_LT((back.q - state.q).head(3 * r.nodes()).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(HardConstraints, JacobianIsTheChangeOfValues) {
  Released r(samples::ring_with_rods(), {});
  HardConstraints constraints;
  constraints.pinned = {3};
  constraints.attached = {{5, 20}};
  // A set in a plane, so that the first-order formula is the whole truth.
  VecX places = r.design->equilibrium().state.q;
  constraints.in_plane = {{1, 4, 9, 16, 25}};
  for (const int node : constraints.in_plane[0]) {
    Vec3 at = places.segment<3>(3 * node);
    at.z() = 0.3 * at.x() - 0.1 * at.y() + 0.002;
    places.segment<3>(3 * node) = at;
  }
  const int unknowns = static_cast<int>(places.size());
  const VecX direction = random_change(unknowns, 11);
  constexpr double kStep = 1e-7;
  const VecX measured = (violations(constraints, places, places + kStep * direction) -
                         violations(constraints, places, places - kStep * direction)) /
                        (2 * kStep);
  const VecX expected = constraint_jacobian(constraints, places, unknowns) * direction;
  EXPECT_EQ(constraints.size(), 11);
  EXPECT_LT((measured - expected).norm() / expected.norm(), 1e-5);
}

TEST(ConstraintProjection, LeavesNothingOfRedundantRows) {
  MatX k = MatX::Random(4, 12);
  k.row(3) = k.row(0) - 2 * k.row(1);
  const ConstraintProjection projection(k);
  EXPECT_EQ(projection.rank(), 3);
  const VecX v = projection.of(VecX::Random(12));
  EXPECT_LT((k * v).norm(), 1e-12);
  EXPECT_LT((projection.of(v) - v).norm(), 1e-12);
}

TEST(ConstraintProjection, LeastChangeMeetsValuesThatCanBeMet) {
  MatX k = MatX::Random(4, 12);
  k.row(3) = k.row(0) - 2 * k.row(1);
  const ConstraintProjection projection(k);
  const VecX values = k * VecX::Random(12);
  const VecX change = projection.least_change(values);
  EXPECT_LT((k * change - values).norm(), 1e-12);
  EXPECT_LT(projection.of(change).norm(), 1e-12);  // nothing in it that has no effect
}

/// Pulled far, so that bounds bend the way: constraints hold to first order all the same, and the shape is that of the
/// parameters.
TEST(TargetEdit, KeepsConstraintsWithinBounds) {
  const Model model = samples::fabric_scene("butterfly");
  const Released r(model, {node_of_point(*samples::open(model), "b1-l")});
  const ShapeResponse& s = *r.response;
  const TargetEdit edit(r.response, r.constraints, {{node_of_point(*r.design, "f3-l"), 1}}, 0.3);
  const MatX k = constraint_response(r.constraints, s.start().state.q, s.matrix());
  for (const double share : {0.5, 1.0}) {
    const Vec3 wanted(0, 0, 0.02);
    const TargetEdit::Answer answer = edit.shortened(edit.answer(wanted), wanted, share);
    const VecX x = (answer.p - s.p()).cwiseQuotient(s.scale());
    EXPECT_GT(x.cwiseAbs().maxCoeff(), 0.5);  // of a scale
    EXPECT_LT((k * x).norm(), 1e-6 * k.norm() * x.norm());
    EXPECT_LT((answer.dq - s.matrix() * x).norm(), 1e-9 * answer.dq.norm());
    for (int i = 0; i < s.size(); ++i) {
      EXPECT_GE(answer.p[i], s.parameters()[static_cast<std::size_t>(i)].lower);
      EXPECT_LE(answer.p[i], s.parameters()[static_cast<std::size_t>(i)].upper);
    }
    EXPECT_LT(answer.rms, share < 1 ? 0.015 : 0.01);
  }
  EXPECT_EQ(edit.answer(Vec3::Zero()).p, s.p());
}

TEST(ShapeModes, KeepTheirPinsWhenAdopted) {
  Released probe(samples::fabric_scene("butterfly"), {});
  std::vector<int> pinned;
  for (const char* name : {"b1-l", "b4-r", "f3-l", "f3-r"}) pinned.push_back(node_of_point(*probe.design, name));
  const Released r(samples::fabric_scene("butterfly"), pinned);
  const std::vector<ShapeMode> modes = shape_modes(*r.response, r.constraints, 3);
  ASSERT_EQ(modes.size(), 3u);
  EXPECT_EQ(modes[0].strength, 1);
  const double amplitude = 0.05 * r.design->system().structure.size;
  double before = 1;
  int adopted = 0;
  for (const ShapeMode& mode : modes) {
    EXPECT_LE(mode.strength, before);
    before = mode.strength;
    EXPECT_NEAR(mode.radii + mode.positions + mode.pre_stretch, 1, 1e-12);
    const VecX held = violations(r.constraints, VecX::Zero(mode.shape.size()), mode.shape);
    EXPECT_LT(held.cwiseAbs().maxCoeff(), 1e-6);  // of 1 m
    const Result<ConstrainedStep> step =
        constrained_step(*r.response, r.constraints, amplitude * mode.parameters, 2e-3 * amplitude, {});
    if (!step.ok()) continue;
    ++adopted;
    EXPECT_LT(step.value().violation, 0.01 * amplitude);
    for (std::size_t i = 0; i < r.response->parameters().size(); ++i) {
      const Parameter& parameter = r.response->parameters()[i];
      EXPECT_GE(step.value().p[static_cast<Eigen::Index>(i)], parameter.lower * (1 - 1e-12));
      EXPECT_LE(step.value().p[static_cast<Eigen::Index>(i)], parameter.upper * (1 + 1e-12));
    }
  }
  EXPECT_GE(adopted, 2);
}

/// Pulls at a point, looks at the linear answer, and fits.
void pull(const std::string& scene, const char* point, const Vec3& move, double radius) {
  SCOPED_TRACE(scene);
  const Released r(samples::fabric_scene(scene), {});
  const Context context;
  HandleGrip grip;
  grip.nodes = {node_of_point(*r.design, point)};
  grip.radius = radius;
  Result<Handle> handle = Handle::make(r.response, {}, grip, context);
  ASSERT_TRUE(handle.ok());
  const Result<Handle::Preview> preview = handle.value().move({.move = move});
  ASSERT_TRUE(preview.ok());
  EXPECT_LT(preview.value().answer.rms, 0.5 * move.norm());
  EXPECT_GT(preview.value().residual, 0);
  const auto fit = std::move(ShapeFit::make(r.response, {}, handle.value().target(), context)).value();
  const double before = fit->distance();
  run_fit(*fit, context, [](const FitRecord&) {});
  EXPECT_LT(fit->distance(), 0.2 * before) << before << " m";
  for (Eigen::Index i = 0; i < fit->x().size(); ++i) {
    EXPECT_GE(fit->x()[i], fit->lower()[i]);
    EXPECT_LE(fit->x()[i], fit->upper()[i]);
  }
}

/// The nose of the mask has short rods all around, whose triangles would turn over.
TEST(Handle, StaysBehindAPullThatThePlanHasNoRoomFor) {
  const Released r(samples::fabric_scene("mask"), {});
  HandleGrip grip;
  grip.nodes = {node_of_point(*r.design, "nose")};
  grip.radius = 0.02;
  Result<Handle> handle = Handle::make(r.response, {}, grip, {});
  ASSERT_TRUE(handle.ok());
  double missed = 0;
  for (const double far : {0.001, 0.02}) {
    const Result<Handle::Preview> preview = handle.value().move({.move = Vec3(0, 0, far)});
    ASSERT_TRUE(preview.ok());
    EXPECT_EQ(preview.value().lags.empty(), far < 0.01);
    EXPECT_TRUE(preview.value().refused.empty()) << preview.value().refused;
    EXPECT_TRUE(r.response->space().at(preview.value().answer.p).ok());
    EXPECT_GT(preview.value().answer.rms, missed);
    missed = preview.value().answer.rms;
  }
}

TEST(ShapeFit, ArrivesWhereTheLinearAnswerPoints) {
  pull("butterfly", "f3-l", Vec3(0, 0, 0.004), 0.05);
  pull("disc-crossed", "rim-0", Vec3(0, 0, 0.003), 0.02);
}

TEST(ShapeFit, GradientIsTheChangeOfTheValue) {
  const Released r(samples::ring_with_rods(), {node_of_point(*samples::open(samples::ring_with_rods()), "e")});
  ShapeTarget target;
  target.places = r.response->start().state.q.head(3 * r.nodes());
  target.nodes = spread_nodes(r.response->system(), 100);
  target.weights.assign(target.nodes.size(), 1);
  for (const int node : target.nodes) target.places.segment<3>(3 * node) += Vec3(1e-3, -2e-3, 1e-3) * std::sin(node);
  Context context;
  const auto fit = std::move(ShapeFit::make(r.response, r.constraints, target, context)).value();
  const VecX direction = random_change(fit->size(), 3), x = fit->x();
  const double slope = fit->gradient().dot(direction);
  constexpr double kStep = 1e-4;
  const Attempt plus = fit->attempt(x + kStep * direction), minus = fit->attempt(x - kStep * direction);
  ASSERT_EQ(plus.outcome, Outcome::kSettled) << plus.reason;
  ASSERT_EQ(minus.outcome, Outcome::kSettled) << minus.reason;
  EXPECT_NEAR((plus.value - minus.value) / (2 * kStep), slope, 2e-3 * std::abs(slope));
}

}  // namespace
}  // namespace lissom
