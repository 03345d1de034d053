/// Maps of stiffness and density on membranes of triangles.

#include <gtest/gtest.h>
#include <utility>

#include "lissom/equilibrium/solve.h"
#include "lissom/mechanics/rest_numbers.h"
#include "tests/derivatives/folded_sheet.h"

namespace lissom {
namespace {

System system_of(const Model& model) {
  Result<System> made = make_system(model);
  EXPECT_TRUE(made) << (made ? "" : made.error().text());
  return made ? std::move(made).value() : System();
}

MembraneMesh& mesh_of(Model& model) { return std::get<MembraneMesh>(model.membranes[0].shape); }

Model folded() {
  Model model;
  model.membrane_materials.push_back({"cloth", 20, 35, 0.25, 4e-4, 0.2, "test"});
  model.membranes.push_back(folded_sheet(5, 0.7));
  mesh_of(model).stiffness.clear();
  mesh_of(model).density.clear();
  return model;
}

TEST(StiffnessMap, AFactorEverywhereIsAStifferAndHeavierMaterial) {
  Model mapped = folded(), stiffer = folded();
  mesh_of(mapped).stiffness.assign(mesh_of(mapped).triangles.size(), 3);
  mesh_of(mapped).density.assign(mesh_of(mapped).triangles.size(), 2.5);
  MembraneMaterial& material = stiffer.membrane_materials[0];
  material.stiffness_1 *= 3;  // at equal thickness
  material.stiffness_2 *= 3;
  material.area_density *= 2.5;
  const System a = system_of(mapped), b = system_of(stiffer), plain = system_of(folded());
  const VecX numbers = rest_number_values(a), expected = rest_number_values(b), before = rest_number_values(plain);
  ASSERT_EQ(numbers.size(), expected.size());
  int changed = 0;
  for (int i = 0; i < numbers.size(); ++i) {
    EXPECT_NEAR(numbers[i], expected[i], 1e-13 * std::abs(expected[i])) << i;
    changed += numbers[i] != before[i];
  }
  EXPECT_EQ(changed, static_cast<int>(2 * a.structure.triangles.size() + a.structure.hinges.size()));
  EXPECT_NEAR(a.rest.total_mass, b.rest.total_mass, 1e-13 * b.rest.total_mass);
  EXPECT_NEAR(a.rest.total_mass, 2.5 * plain.rest.total_mass, 1e-13 * b.rest.total_mass);
  EXPECT_NEAR(a.rest.max_tension, b.rest.max_tension, 1e-13 * b.rest.max_tension);
  for (size_t i = 0; i < a.rest.node_mass.size(); ++i) {
    EXPECT_NEAR(a.rest.node_mass[i], b.rest.node_mass[i], 1e-13 * b.rest.node_mass[i]);
  }
}

TEST(StiffnessMap, EachTriangleHasItsOwn) {
  Model model = folded();
  const size_t triangles = mesh_of(model).triangles.size();
  mesh_of(model).stiffness = uneven_map(triangles);
  mesh_of(model).density.assign(triangles, 0);
  mesh_of(model).density[4] = 3;
  const System system = system_of(model), plain = system_of(folded());
  for (size_t t = 0; t < triangles; ++t) {
    EXPECT_NEAR(system.rest.triangles[t].stiffness_2, mesh_of(model).stiffness[t] * 35, 1e-12);
  }
  EXPECT_NEAR(system.rest.total_mass, 3 * 0.2 * plain.rest.triangles[4].area, 1e-15);
}

/// The moment at a hinge passes through one triangle after the other: their turns add up.
TEST(StiffnessMap, CompliancesAddAtAHinge) {
  Model model = folded();
  mesh_of(model).stiffness = uneven_map(mesh_of(model).triangles.size());
  const System system = system_of(model), plain = system_of(folded());
  ASSERT_GT(system.structure.hinges.size(), 10u);
  for (size_t h = 0; h < system.structure.hinges.size(); ++h) {
    const auto [left, right] = system.structure.hinges[h].triangle;
    const double a = plain.rest.triangles[left].area, b = plain.rest.triangles[right].area;
    const double share_left = a / (a + b) / mesh_of(model).stiffness[left];
    const double share_right = b / (a + b) / mesh_of(model).stiffness[right];
    EXPECT_NEAR(1 / system.rest.hinges[h].stiffness, (share_left + share_right) / plain.rest.hinges[h].stiffness,
                1e-12 / plain.rest.hinges[h].stiffness);
  }
}

/// A strip, 0.4 m by 0.1 m, whose second half is four times as stiff, pulled lengthwise: F L / (Y b) (1/2 + 1/8).
TEST(StiffnessMap, TwoHalvesOfAStripYieldInSeries) {
  Model model;
  model.membrane_materials.push_back({"cloth", 100, 100, 0, 0, 0, "test"});
  Membrane strip;
  strip.name = "strip";
  strip.material = "cloth";
  MembraneMesh mesh;
  for (int i = 0; i <= 4; ++i) {
    for (int j = 0; j <= 1; ++j) mesh.points.emplace_back(0.1 * i, 0.1 * j, 0);
  }
  for (int i = 0; i < 4; ++i) {
    mesh.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 3});
    mesh.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 1});
  }
  mesh.stiffness = {1, 1, 1, 1, 4, 4, 4, 4};
  strip.shape = mesh;
  model.membranes.push_back(strip);
  Pose pose;
  pose.name = "pulled";
  const auto box = [](double low, double high) {
    Selector selector;
    selector.kind = Selector::Kind::kBox;
    selector.low = Vec3(low, -1, -1);
    selector.high = Vec3(high, 1, 1);
    return selector;
  };
  Support flat, start;
  flat.at = box(-1, 1);
  flat.kind = start.kind = SupportKind::kFree;
  flat.directions = {Vec3::UnitY(), Vec3::UnitZ()};
  start.at = box(-1, 0.01);
  start.directions = {Vec3::UnitX()};
  pose.supports = {flat, start};
  PointForce pull;
  pull.at = box(0.39, 1);
  pull.force = Vec3(1e-3, 0, 0);
  pull.shared = true;
  pose.forces.push_back(pull);
  model.poses.push_back(pose);
  const System system = system_of(model);
  const Result<StaticProblem> problem = make_static_problem(model, system, model.poses[0], "/poses/0");
  ASSERT_TRUE(problem) << problem.error().text();
  const Equilibrium e = solve(problem.value(), start_state(problem.value(), model.poses[0]), 1, {});
  ASSERT_EQ(e.verdict, Verdict::kStable) << e.message;
  const double expected = 1e-3 * 0.4 / (100 * 0.1) * (0.5 + 0.125);
  EXPECT_NEAR(e.state.position(8).x() - 0.4, expected, 1e-3 * expected);
  EXPECT_NEAR(e.state.position(9).x() - 0.4, expected, 1e-3 * expected);
}

TEST(StiffnessMap, ImpossibleMapsAreRefusedWhereTheyAre) {
  struct Mistake {
    const char* where;
    void (*make)(MembraneMesh&);
  };
  const Mistake mistakes[] = {
      {"/membranes/0/mesh/stiffness",
       [](MembraneMesh& m) {
         m.stiffness = {1, 2};
       }},
      {"/membranes/0/mesh/stiffness/3", [](MembraneMesh& m) { m.stiffness[3] = 0; }},
      {"/membranes/0/mesh/stiffness/0", [](MembraneMesh& m) { m.stiffness[0] = std::nan(""); }},
      {"/membranes/0/mesh/density", [](MembraneMesh& m) { m.density.push_back(1); }},
      {"/membranes/0/mesh/density/2", [](MembraneMesh& m) { m.density[2] = -1; }},
  };
  for (const Mistake& mistake : mistakes) {
    Model model = folded();
    mesh_of(model).stiffness = mesh_of(model).density = uneven_map(mesh_of(model).triangles.size());
    EXPECT_TRUE(model.validate());
    mistake.make(mesh_of(model));
    const Status status = model.validate();
    ASSERT_FALSE(status) << mistake.where;
    EXPECT_EQ(status.error().where, mistake.where);
    EXPECT_FALSE(status.error().hint.empty());
    const Result<Structure> structure = discretize(model);
    ASSERT_FALSE(structure) << mistake.where;
    EXPECT_EQ(structure.error().where, mistake.where);
  }
}

}  // namespace
}  // namespace lissom
