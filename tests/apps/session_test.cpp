#include <gtest/gtest.h>
#include <random>

#include "lissom/equilibrium/solve.h"
#include "lissom/model/document.h"
#include "lissom/session/fields.h"
#include "lissom/session/quantities.h"
#include "lissom/session/result_file.h"
#include "lissom/session/rod_places.h"
#include "lissom/session/study.h"
#include "lissom/session/verify.h"

namespace lissom {
namespace {

/// Three rods at a joint of the given kind, one foot clamped and turned, one loaded.
Model tripod(JointKind joint) {
  constexpr std::string_view kText = R"({
    "lissom": 1,
    "materials": {"soft": {"youngs_modulus": "30 MPa", "poisson_ratio": 0.4, "density": "1200 kg/m^3"}},
    "rods": [
      {"name": "a", "line": [[0, 0, 0], [100, 0, 20]], "edges": 8, "material": "soft", "section": {"r_n": "1 mm", "r_b": "1.5 mm"}},
      {"name": "b", "line": [[0, 0, 0], [-50, 80, 10]], "edges": 7, "material": "soft", "section": {"radius": "1 mm"}},
      {"name": "c", "spline": [[0, 0, 0], [-50, -40, 0], [-60, -90, 30]], "edges": 9, "material": "soft", "section": {"radius": "1 mm"}}
    ],
    "joints": {"kind": "explicit"},
    "sets": {"tip": {"rod": "a", "at": "end"}, "foot": {"rod": "b", "at": "end"}},
    "poses": [{
      "name": "loaded",
      "supports": [
        {"at": "foot", "hold": "clamp", "turn": {"axis": [0, 0.2, 1], "angle": "20 deg"}, "move": [2, 0, 3]},
        {"at": {"rod": "c", "at": "end"}, "hold": "clamp"}
      ],
      "forces": [{"at": "tip", "force": [0, "3 mN", "-5 mN"]}],
      "gravity": {"acceleration": [0, 0, "-9.81 m/s^2"], "scaling": "constant"}
    }]
  })";
  Model model = read_document(kText).value();
  model.joint_kind = joint;
  return model;
}

Expectation asked(const std::string& quantity, const std::string& set, std::optional<Vec3> axis = {}) {
  Expectation e;
  e.quantity = quantity;
  e.axis = axis;
  if (!set.empty()) {
    e.at.kind = Selector::Kind::kSet;
    e.at.name = set;
  }
  return e;
}

double measured(Study& study, const Expectation& e) {
  const Result<std::vector<double>> values = measure(study, e, "/expect/0");
  EXPECT_TRUE(values.ok()) << (values.ok() ? "" : values.error().text());
  return values.ok() ? values.value().front() : std::nan("");
}

SolveOptions tight() {
  SolveOptions options;
  options.tolerance = 1e-10;
  return options;
}

class Joints : public testing::TestWithParam<JointKind> {};

TEST_P(Joints, ElementEnergiesAddUpToThePotential) {
  const Model model = tripod(GetParam());
  Study study(model, tight(), {});
  const Situation& s = *study.situation(0).value();
  double elastic = 0;
  AssemblyBuffers buffers;
  std::vector<double> shares(s.problem->potential.terms().size());
  s.problem->potential.value(s.state, buffers, nullptr, shares);
  for (size_t t = 0; t < shares.size(); ++t) {
    const std::string_view name = s.problem->potential.terms()[t]->name();
    if (name != "gravity" && name != "point_force") elastic += shares[t];
  }
  ASSERT_GT(elastic, 1e-6);
  const double total = measured(study, asked("energy", ""));
  EXPECT_NEAR(total, elastic, 1e-12 * elastic);
  const double parts = measured(study, asked("stretch_energy", "")) + measured(study, asked("bending_energy", "")) +
                       measured(study, asked("twist_energy", ""));
  EXPECT_NEAR(parts, total, 1e-12 * total);

  const Drawing drawing = draw_state({model, *s.system, s.state, &s.reaction}, &model.poses[0]).value();
  double integral = 0;
  for (const char* field : {"stretch energy", "bending energy", "twist energy"}) {
    const std::vector<double>& density = drawing.field(field)->values;
    size_t k = 0;
    for (const StructureRod& rod : s.system->structure.rods) {
      for (const int e : rod.edges) integral += density[k++] * s.system->rest.edges[e].length;
    }
  }
  EXPECT_NEAR(integral, total, 1e-12 * total);
}

TEST_P(Joints, RatesAreDerivativesByTheLoadFactor) {
  const Model model = tripod(GetParam());
  Study study(model, tight(), {});
  const double h = 1e-3;
  const auto near = [&](double factor) {
    Model moved = model;
    moved.poses[0].path = LoadPath{.from = factor, .to = factor + 1, .steps = 1};
    return moved;
  };
  // Values at factors -h and +h, read where the path of a copy begins.
  const Model back = near(-h), ahead = near(h);
  Study before(back, tight(), {}), after(ahead, tight(), {});
  const Rate &r0 = *before.rate(0).value(), &r1 = *after.rate(0).value(), &r = *study.rate(0).value();
  const VecX difference = (r1.state.q - r0.state.q) / (2 * h);
  const int positions = 3 * r.system->layout.nodes();
  const double size = r.unknowns.head(positions).cwiseAbs().maxCoeff();
  ASSERT_GT(size, 1e-4);
  EXPECT_LT((r.unknowns.head(positions) - difference.head(positions)).cwiseAbs().maxCoeff(), 2e-4 * size);
  const VecX reactions = (r1.reaction - r0.reaction) / (2 * h);
  const double force = r.reaction_rate.head(positions).cwiseAbs().maxCoeff();
  EXPECT_LT((r.reaction_rate.head(positions) - reactions.head(positions)).cwiseAbs().maxCoeff(), 1e-3 * force);
  EXPECT_NEAR(measured(study, asked("rotation_rate", "foot", Vec3(0, 0.2, 1))), 20 * 3.14159265358979 / 180, 1e-7);
}

TEST_P(Joints, ReactionsBalanceLoadsAndWeight) {
  const Model model = tripod(GetParam());
  Study study(model, tight(), {});
  const double mass = measured(study, asked("mass", ""));
  EXPECT_NEAR(measured(study, asked("reaction_force", "", Vec3::UnitZ())), 0.005 + 9.81 * mass, 1e-7);
  EXPECT_NEAR(measured(study, asked("reaction_force", "", Vec3::UnitY())), -0.003, 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Joints, testing::Values(JointKind::kExplicit, JointKind::kCorotational));

TEST(Quantities, EachHasAUnitAndADescriptionAndIsFoundByName) {
  for (const QuantityInfo& info : quantities()) {
    EXPECT_EQ(info.unit.empty(), (info.reads & kParameter) != 0) << info.name;
    EXPECT_FALSE(info.description.empty()) << info.name;
    EXPECT_EQ(find_quantity(info.name).value().measure, info.measure);
    EXPECT_EQ(find_quantity(std::string(info.name) + "_rate").ok(), info.rate != nullptr) << info.name;
    EXPECT_EQ(info.needs & ~info.reads, 0u) << info.name;
  }
}

TEST(Verify, ComparesInTheUnitOfTheEntry) {
  Model model = tripod(JointKind::kExplicit);
  Expectation e = asked("rest_length", "");
  e.rod = "a";
  e.unit = "mm";
  e.value = {0.10198039};  // SI
  e.tolerance_absolute = 1e-6;
  model.expectations = {e};
  const std::vector<Check> checks = verify(model, {});
  ASSERT_EQ(checks.size(), 1u);
  EXPECT_TRUE(checks[0].passed);
  EXPECT_NEAR(checks[0].got, 101.98039, 1e-4);
  EXPECT_NEAR(checks[0].tolerance, 1e-3, 1e-9);
}

TEST(Results, ReadBackExactlyAndSurviveMutilation) {
  const Model model = tripod(JointKind::kExplicit);
  const System system = make_system(model).value();
  const StaticProblem problem = make_static_problem(model, system, model.poses[0], "/poses/0").value();
  const Equilibrium equilibrium = solve(problem, start_state(problem, model.poses[0]), 1, {});
  const std::string text = result_text({"tripod", {}, model}, model.poses[0], system, {}, equilibrium, {});
  const SavedResult saved = read_result(text, "result.json").value();
  EXPECT_EQ(saved.verdict, "stable");
  EXPECT_TRUE(check_state(system, saved.state).ok());
  EXPECT_TRUE((saved.state.q.array() == equilibrium.state.q.array()).all());
  EXPECT_EQ(saved.state.pair_twist, equilibrium.state.pair_twist);
  EXPECT_EQ(saved.state.connection_twist, equilibrium.state.connection_twist);
  EXPECT_EQ(document_hash(saved.document.model), document_hash(model));

  std::mt19937 random(7);
  int refused = 0;
  for (int i = 0; i < 400; ++i) {
    std::string broken = text;
    for (int k = 0; k < 1 + i % 4; ++k) broken[random() % broken.size()] = static_cast<char>(32 + random() % 95);
    if (i % 5 == 0) broken.resize(random() % broken.size());
    const Result<SavedResult> read = read_result(broken, "broken.json");
    if (!read) {
      ++refused;
    } else if (const Result<System> other = make_system(read.value().document.model); other) {
      (void)check_state(other.value(), read.value().state).ok();
    }
  }
  EXPECT_GT(refused, 80);  // all that are cut off
}

}  // namespace
}  // namespace lissom
