/// Rest numbers and their derivatives by places, sections, pre-stretch and moduli.

#include <cmath>
#include <gtest/gtest.h>
#include <utility>

#include "lissom/mechanics/energies.h"
#include "lissom/mechanics/gradient_by_rest.h"
#include "lissom/mechanics/load_numbers.h"
#include "lissom/mechanics/rest_jacobian.h"
#include "tests/derivatives/folded_sheet.h"

namespace lissom {
namespace {

Rod rod(const char* name, Curve curve, SectionShape shape, std::vector<double> r_n, std::vector<double> r_b) {
  Rod r;
  r.name = name;
  r.curve = std::move(curve);
  r.material = "PLA";
  r.section.shape = shape;
  r.section.r_n = std::move(r_n);
  r.section.r_b = std::move(r_b);
  r.edges = 4;
  return r;
}

/// A folded sheet with bending and a warp direction of its own, a solid at its corner, rods of all sections across and beside
/// it, loads of every kind that hangs on lengths and areas.
Model everything() {
  Model model;
  model.membrane_materials.push_back({"cloth", 20, 35, 0.25, 4e-4, 0.2, "test"});
  const Membrane sheet = folded_sheet(5, 0.7);
  const auto& points = std::get<MembraneMesh>(sheet.shape).points;
  const Vec3 corner = points[0], far = points[19], side = points[4];
  model.membranes.push_back(sheet);
  const Vec3 top(0.03, 0.03, 0.05);
  model.rods.push_back(rod("taper", Polyline{{corner, top}}, SectionShape::kEllipse, {1e-3, 2e-3}, {2e-3, 1e-3}));
  model.rods.push_back(
      rod("lath", Spline{{top, Vec3(0.06, 0.02, 0.04), far}}, SectionShape::kRectangle, {5e-4}, {2e-3}));
  Rod tube = rod("tube", Spline{{side, Vec3(0.08, 0.04, 0.02), far}}, SectionShape::kTube, {2e-3}, {2e-3});
  tube.section.wall = 5e-4;
  model.rods.push_back(tube);
  Rod curved = rod("curved", Polyline{{corner, side}}, SectionShape::kEllipse, {1e-3}, {1e-3});
  curved.natural.kind = Natural::Kind::kCurved;
  curved.natural.curvature_b = 12;
  curved.natural.curvature_n = -7;
  curved.natural.twist = 5;
  curved.natural.length_factor = 1.05;
  model.rods.push_back(curved);
  model.materials.push_back({"gum", 2e5, 0.4, 900, 1, "test"});
  Solid solid = block({1, 1, 1}, Vec3(0.02, 0.03, 0.025));
  for (Vec3& p : solid.points) p += corner - Vec3(0.02, 0.03, 0.025) + 5 * p.cwiseProduct(Vec3(p.y(), p.z(), p.x()));
  solid.points.back() = corner;
  solid.stiffness = uneven_map(6);
  solid.density = uneven_map(6);
  model.solids.push_back(solid);
  Pose pose;
  pose.name = "loaded";
  pose.gravity = Gravity{};
  LineLoad wind;
  wind.force_per_length = {0.1, 0.2, -0.3};
  wind.rods = {"lath", "tube"};
  pose.line_loads.push_back(wind);
  EdgeLoad pull;
  pull.at.kind = Selector::Kind::kAll;
  pull.force_per_length = {0.4, -0.1, 0.2};
  pose.edge_loads.push_back(pull);
  PointForce force;
  force.at.kind = Selector::Kind::kRod;
  force.at.name = "lath";
  force.force = {0.2, -0.3, 0.1};
  force.shared = true;
  pose.forces.push_back(force);
  PointMoment moment;
  moment.at.kind = Selector::Kind::kRod;
  moment.at.name = "taper";
  moment.at.fraction = 1;
  moment.moment = {1e-3, 2e-3, -1e-3};
  pose.moments.push_back(moment);
  SoftPin here, there;
  here.at = there.at = moment.at;
  here.stiffness = 30;
  there.stiffness = 20;
  there.target = Vec3(0.01, 0.02, 0.06);
  pose.soft_pins = {here, there};
  model.poses.push_back(pose);
  return model;
}

System system_of(const Model& model) {
  Result<System> made = make_system(model);
  EXPECT_TRUE(made.ok()) << made.error().text();
  return std::move(made).value();
}

TEST(RestNumbers, FormulasGiveTheRestState) {
  for (const JointKind joints : {JointKind::kExplicit, JointKind::kCorotational}) {
    Model model = everything();
    model.joint_kind = joints;
    const System system = system_of(model);
    const VecX expected = rest_number_values(system);
    const VecX got = rest_numbers_of(model, system, rest_input_values(model, system));
    ASSERT_GT(expected.size(), 500);
    for (int i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(got[i], expected[i], 1e-12 * std::max(1e-3, std::abs(expected[i]))) << i;
    }
  }
}

TEST(RestNumbers, DerivativesMatchDifferences) {
  const Model model = everything();
  const System system = system_of(model);
  const VecX inputs = rest_input_values(model, system);
  const VecX numbers = rest_number_values(system);
  const MatX exact = MatX(rest_jacobian(model, system));
  int compared = 0;
  for (int k = 0; k < inputs.size(); ++k) {
    const double h = 1e-5 * (std::abs(inputs[k]) > 1e-8 ? std::abs(inputs[k]) : 1e-2);
    VecX plus = inputs, minus = inputs;
    plus[k] += h;
    minus[k] -= h;
    const VecX difference = (rest_numbers_of(model, system, plus) - rest_numbers_of(model, system, minus)) / (2 * h);
    for (int i = 0; i < difference.size(); ++i) {
      const double scale = std::max(exact.row(i).cwiseAbs().maxCoeff() * 1e-3, std::abs(exact(i, k)));
      const double rounding = 5e-14 * std::max(1.0, std::abs(numbers[i])) / h;
      const double deviation = std::abs(difference[i] - exact(i, k)) / (scale + 1e5 * rounding);
      EXPECT_LT(deviation, 1e-5) << "number " << i << " by input " << k << ": " << exact(i, k) << ", by differences "
                                 << difference[i];
      compared += exact(i, k) != 0;
    }
  }
  EXPECT_GT(compared, 1000);
}

/// A rod that is curved by itself keeps its length and strains when its nodes are elsewhere; one that is natural as drawn
/// does not.
TEST(RestNumbers, OnlyRodsThatAreNaturalAsDrawnFollowTheDrawing) {
  const Model model = everything();
  const System system = system_of(model);
  const RestNumbers numbers(system.structure);
  const SparseMatrix jacobian = rest_jacobian(model, system);
  const MatX by_places = MatX(jacobian).leftCols(3 * system.layout.nodes());
  const int curved = system.structure.rods[3].edges[1], lath = system.structure.rods[1].edges[1];
  EXPECT_EQ(by_places.row(numbers.edge(curved, kEdgeLength)).norm(), 0);
  EXPECT_GT(by_places.row(numbers.edge(lath, kEdgeLength)).norm(), 0.5);
}

TEST(RestNumbers, StencilsTakeTheirRestQuantitiesFromThem) {
  for (const JointKind joints : {JointKind::kExplicit, JointKind::kCorotational}) {
    Model model = everything();
    model.joint_kind = joints;
    const System system = system_of(model);
    const auto terms = make_terms(model, system, &model.poses[0], "/poses/0");
    ASSERT_TRUE(terms.ok()) << terms.error().text();
    const VecX of_structure = rest_number_values(system);
    const VecX of_pose = load_number_values(model.poses[0], system.structure);
    VecX numbers(of_structure.size() + of_pose.size());
    numbers << of_structure, of_pose;
    for (const auto& term : terms.value()) {
      SCOPED_TRACE(std::string(term->name()));
      VecX sums = VecX::Zero(term->stencils() * term->rests());
      int before = 0;
      for (const RestLink& link : term->links()) {
        EXPECT_GE(link.entry, before);
        before = link.entry;
        sums[link.entry] += link.factor * numbers[link.number];
      }
      ASSERT_FALSE(term->links().empty());
      for (int s = 0; s < term->stencils(); ++s) {
        const VecX rest = term->rest(s);
        for (int i = 0; i < term->rests(); ++i) {
          const double got = sums[s * term->rests() + i];
          EXPECT_NEAR(got, rest[i], 1e-13 * std::max(1e-3, std::abs(rest[i]))) << "stencil " << s << ", rest " << i;
        }
      }
    }
  }
}

/// The whole chain: gradient of a strained state by inputs, against gradients of models with other inputs.
TEST(RestNumbers, GradientsFollowInputs) {
  Model model = everything();
  const System system = system_of(model);
  auto terms = make_terms(model, system, &model.poses[0], "/poses/0");
  ASSERT_TRUE(terms.ok());
  Potential potential(system.layout.size(), std::move(terms).value());
  State state = drawn_state(system), moved;
  state.load_factor = 1;
  VecX dq(system.layout.size());
  for (int i = 0; i < dq.size(); ++i) dq[i] = (i < 3 * system.layout.nodes() ? 1e-3 : 0.05) * std::sin(1.7 * i);
  ASSERT_TRUE(advance(system, state, dq, moved));
  const MatX by_rest = MatX(gradient_by_rest(potential, moved, RestNumbers(system.structure).size()));
  const MatX exact = by_rest * MatX(rest_jacobian(model, system));
  const RestInputs inputs(system.structure);

  const auto gradient_of = [&](const Model& changed) {
    const System other = system_of(changed);
    auto own = make_terms(changed, other, &changed.poses[0], "/poses/0");
    EXPECT_TRUE(own.ok());
    const Potential own_potential(other.layout.size(), std::move(own).value());
    AssemblyBuffers buffers;
    VecX gradient;
    State own_state;  // with twists against the joints of this model
    EXPECT_TRUE(advance(other, moved, VecX::Zero(dq.size()), own_state));
    own_potential.gradient(own_state, gradient, buffers);
    return gradient;
  };
  const auto compare = [&](const VecX& column, double h, const auto& change) {
    Model plus = model, minus = model;
    change(plus, h);
    change(minus, -h);
    const VecX difference = (gradient_of(plus) - gradient_of(minus)) / (2 * h);
    ASSERT_GT(difference.norm(), 0);
    EXPECT_LT((column - difference).norm(), 1e-6 * difference.norm());
  };
  compare(exact.col(inputs.length_factor(1)), 1e-5, [](Model& m, double h) { m.rods[1].natural.length_factor += h; });
  compare(exact.col(inputs.length_factor(3)), 1e-5, [](Model& m, double h) { m.rods[3].natural.length_factor += h; });
  compare(exact.col(inputs.natural_rate(3, 0)), 1e-3, [](Model& m, double h) { m.rods[3].natural.curvature_b += h; });
  compare(exact.col(inputs.natural_rate(3, 1)), 1e-3, [](Model& m, double h) { m.rods[3].natural.curvature_n += h; });
  compare(exact.col(inputs.natural_rate(3, 2)), 1e-3, [](Model& m, double h) { m.rods[3].natural.twist += h; });
  compare(exact.col(inputs.pre_stretch(0, 1)), 1e-5, [](Model& m, double h) { m.membranes[0].pre_stretch[1] += h; });
  compare(exact.col(inputs.sheet_poisson(0)), 1e-5,
          [](Model& m, double h) { m.membrane_materials[0].poisson_ratio += h; });
  compare(exact.col(inputs.thickness(0)), 1e-5, [](Model& m, double h) { m.membrane_materials[0].thickness += h; });
  compare(exact.col(inputs.solid_modulus(0)), 1, [](Model& m, double h) { m.materials[0].youngs_modulus += h; });
  VecX thicker = VecX::Zero(dq.size());
  for (const int e : system.structure.rods[1].edges) thicker += exact.col(inputs.extent_n(e));
  compare(thicker, 1e-7, [](Model& m, double h) { m.rods[1].section.r_n[0] += h; });
}

}  // namespace
}  // namespace lissom
