/// Solids: what they are refused for, masses, closed forms, and that threads change nothing.

#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <utility>

#include "lissom/equilibrium/solve.h"
#include "lissom/geometry/tetrahedron_faces.h"
#include "lissom/mechanics/solid_strain.h"
#include "scenes/parts.h"
#include "tests/derivatives/solid_block.h"

namespace lissom {
namespace {

constexpr double kYoung = 2e5, kPoisson = 0.3;

Model model_of(Solid solid) {
  Model model;
  model.materials.push_back({"gum", kYoung, kPoisson, 900, 1, "test"});
  model.solids.push_back(std::move(solid));
  return model;
}

using scene_models::box;

/// Nodes with this coordinate along an axis.
Selector plane(int axis, double at) {
  Vec3 low = Vec3::Constant(-10), high = Vec3::Constant(10);
  low[axis] = at - 1e-6;
  high[axis] = at + 1e-6;
  return box(low, high);
}

Support held(Selector at, std::vector<Vec3> directions) {
  Support support;
  support.at = std::move(at);
  support.kind = SupportKind::kFree;
  support.directions = std::move(directions);
  return support;
}

struct Solved {
  std::unique_ptr<System> system;
  Equilibrium equilibrium;
  double total_reaction(int axis, double at) const {
    double sum = 0;
    for (int i = 0; i < system->layout.nodes(); ++i) {
      if (std::abs(system->structure.nodes[i][axis] - at) < 1e-6) sum += equilibrium.reaction[3 * i + axis];
    }
    return sum;
  }
};

Solved solved(const Model& model, const Context& context = {}) {
  Solved result;
  Result<System> made = make_system(model);
  EXPECT_TRUE(made) << (made ? "" : made.error().text());
  if (!made) return result;
  result.system = std::make_unique<System>(std::move(made).value());
  const Result<StaticProblem> problem = make_static_problem(model, *result.system, model.poses[0], "/poses/0");
  EXPECT_TRUE(problem) << (problem ? "" : problem.error().text());
  if (!problem) return result;
  result.equilibrium = solve(problem.value(), start_state(problem.value(), model.poses[0]), 1, {}, context);
  EXPECT_EQ(result.equilibrium.verdict, Verdict::kStable) << result.equilibrium.message;
  return result;
}

TEST(Solid, FacesOfABlockAreItsOuterSides) {
  const Solid solid = block({3, 2, 4}, Vec3(0.3, 0.2, 0.4));
  const auto faces = outer_faces(solid.tetrahedra);
  EXPECT_EQ(faces.size(), 2u * 2 * (3 * 2 + 2 * 4 + 3 * 4));
  double volume = 0;
  for (const auto& [a, b, c] : faces) volume += solid.points[a].dot(solid.points[b].cross(solid.points[c])) / 6;
  EXPECT_NEAR(volume, 0.3 * 0.2 * 0.4, 1e-15);
}

TEST(Solid, MassGoesToTheCorners) {
  Solid solid = block({2, 1, 1}, Vec3(0.02, 0.03, 0.04));
  solid.density.assign(12, 1);
  for (size_t t = 6; t < 12; ++t) solid.density[t] = 3;
  const Result<System> system = make_system(model_of(solid));
  ASSERT_TRUE(system) << system.error().text();
  const RestState& rest = system.value().rest;
  const double cell = 0.01 * 0.03 * 0.04;
  EXPECT_NEAR(rest.total_mass, 900 * 4 * cell, 1e-12);
  double nodes = 0, volume = 0, far = 0;
  for (size_t i = 0; i < rest.node_mass.size(); ++i) {
    nodes += rest.node_mass[i];
    volume += rest.node_volume[i];
    if (system.value().structure.nodes[i].x() > 0.015) far += rest.node_mass[i];
  }
  EXPECT_NEAR(nodes, rest.total_mass, 1e-15);
  EXPECT_NEAR(volume, 2 * cell, 1e-15);
  EXPECT_NEAR(far, 900 * 3 * cell / 2, 1e-12);
}

TEST(Solid, NodesAreSharedWithRodsAndMembranesAtTheSamePlace) {
  Model model = model_of(block({1, 1, 1}, Vec3(0.02, 0.02, 0.02)));
  Rod rod;
  rod.name = "rod";
  rod.curve = Polyline{{Vec3(0.02, 0.02, 0.02), Vec3(0.06, 0.02, 0.02)}};
  rod.material = "gum";
  rod.section.r_n = rod.section.r_b = {1e-3};
  rod.edges = 4;
  model.rods.push_back(rod);
  Membrane skin;
  skin.name = "skin";
  skin.material = "soft knit";
  skin.shape = MembraneGrid{Vec2::Zero(), Vec2(0.02, 0.02), 1, 1};
  model.membranes.push_back(skin);
  const Result<Structure> joined = discretize(model);
  ASSERT_TRUE(joined) << joined.error().text();
  EXPECT_EQ(joined.value().nodes.size(), 8u + 4u);
  EXPECT_EQ(joined.value().components, 1);
  model.merge_distance = -1;
  const Result<Structure> apart = discretize(model);
  ASSERT_TRUE(apart) << apart.error().text();
  EXPECT_EQ(apart.value().nodes.size(), 8u + 5u + 4u);
  EXPECT_EQ(apart.value().components, 3);
}

/// Linear fields of displacement are met exactly by linear tetrahedra, however these lie.
TEST(Solid, PulledBlockHasYoungsModulusAndPoissonsRatio) {
  const Vec3 size(0.03, 0.02, 0.025);
  Solid solid = block({3, 2, 2}, size);
  for (size_t i = 0; i < solid.points.size(); ++i) {
    const Vec3 inside = solid.points[i].cwiseProduct(size - solid.points[i]);
    if (inside.minCoeff() > 0) solid.points[i] += Vec3(0.002, -0.001, 0.0015);
  }
  Model model = model_of(solid);
  const double strain = 1e-4;
  Pose pose;
  pose.name = "pulled";
  for (int axis = 0; axis < 3; ++axis) pose.supports.push_back(held(plane(axis, 0), {Vec3::Unit(axis)}));
  Support end = held(plane(0, size.x()), {Vec3::UnitX()});
  end.move = strain * size.x() * Vec3::UnitX();
  pose.supports.push_back(end);
  model.poses.push_back(pose);
  const Solved s = solved(model);
  for (int i = 0; i < s.system->layout.nodes(); ++i) {
    const Vec3& x = s.system->structure.nodes[i];
    const Vec3 expected = strain * Vec3(x.x(), -kPoisson * x.y(), -kPoisson * x.z());
    EXPECT_LT((s.equilibrium.state.position(i) - x - expected).norm(), 2e-3 * strain * size.norm());
  }
  const double force = kYoung * strain * size.y() * size.z();
  EXPECT_NEAR(s.total_reaction(0, size.x()), force, 1e-3 * force);
  for (const double ratio : volume_ratios(*s.system, s.equilibrium.state)) {
    EXPECT_NEAR(ratio - 1, (1 - 2 * kPoisson) * strain, 2e-3 * strain);
  }
  ASSERT_EQ(s.equilibrium.energy_shares.size(), 1u);
  EXPECT_EQ(s.equilibrium.energy_shares[0].term, "solid_stretch");
  EXPECT_NEAR(s.equilibrium.energy, 0.5 * force * strain * size.x(), 1e-3 * s.equilibrium.energy);
}

/// Deflection of the end of a clamped bar, 10 x 1 x 1, under a small force, over F L^3 / (3 E I).
double deflection(int cells) {
  const double length = 0.1, width = 0.01, force = 1e-5;
  Model model = model_of(block({10 * cells, cells, cells}, Vec3(length, width, width)));
  Pose pose;
  pose.name = "bent";
  pose.supports.push_back(held(plane(0, 0), {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}));
  PointForce tip;
  tip.at = plane(0, length);
  tip.force = force * Vec3::UnitY();
  tip.shared = true;
  pose.forces.push_back(tip);
  model.poses.push_back(pose);
  const Solved s = solved(model);
  double sum = 0;
  int count = 0;
  for (int i = 0; i < s.system->layout.nodes(); ++i) {
    if (std::abs(s.system->structure.nodes[i].x() - length) > 1e-6) continue;
    sum += s.equilibrium.state.position(i).y() - s.system->structure.nodes[i].y();
    ++count;
  }
  const double inertia = std::pow(width, 4) / 12;
  return sum / count / (force * std::pow(length, 3) / (3 * kYoung * inertia));
}

/// Linear tetrahedra are too stiff to bend, by the square of their size over that of the bar.
TEST(Solid, BarBendsAsABeamWhenTetrahedraAreSmall) {
  const double two = 1 / deflection(2), four = 1 / deflection(4), eight = 1 / deflection(8);
  EXPECT_LT(eight, 1.07);
  EXPECT_GT((two - 1) / (four - 1), 3.5);
  EXPECT_GT((four - 1) / (eight - 1), 3.5);
  EXPECT_NEAR((4 * eight - four) / 3, 1, 0.01);
}

TEST(Solid, StiffnessIsMultipliedByTheMap) {
  Solid solid = block({1, 1, 1}, Vec3(0.02, 0.02, 0.02));
  solid.stiffness = uneven_map(6);
  const Result<System> system = make_system(model_of(solid));
  ASSERT_TRUE(system);
  for (size_t t = 0; t < 6; ++t) {
    const TetrahedronRest& rest = system.value().rest.tetrahedra[t];
    EXPECT_NEAR(rest.mu * 2 * (1 + kPoisson), solid.stiffness[t] * kYoung, 1e-9 * kYoung);
    EXPECT_NEAR(rest.lambda / (2 * (rest.lambda + rest.mu)), kPoisson, 1e-12);
  }
}

TEST(Solid, ThreadsChangeNoByte) {
  Model model = model_of(block({8, 4, 4}, Vec3(0.08, 0.04, 0.04)));
  Pose pose;
  pose.name = "hanging";
  pose.gravity = Gravity{};
  pose.supports.push_back(held(plane(0, 0), {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}));
  Support end = held(plane(0, 0.08), {Vec3::UnitZ()});
  end.move = 0.03 * Vec3::UnitZ();
  pose.supports.push_back(end);
  model.poses.push_back(pose);
  const Solved alone = solved(model);
  for (const int threads : {2, 8}) {
    ThreadPool pool(threads);
    Context context;
    context.threads = &pool;
    const Solved other = solved(model, context);
    EXPECT_EQ(other.equilibrium.state.q, alone.equilibrium.state.q);
    EXPECT_EQ(other.equilibrium.energy, alone.equilibrium.energy);
  }
}

TEST(Solid, WhatNoSolidCanBeIsRefusedWhereItIs) {
  struct Mistake {
    const char* where;
    void (*make)(Model&);
  };
  const Mistake mistakes[] = {
      {"/solids/0/material", [](Model& m) { m.solids[0].material = "gumm"; }},
      {"/solids/0/material", [](Model& m) { m.materials[0].poisson_ratio = 0.5; }},
      {"/solids/0/tetrahedra", [](Model& m) { m.solids[0].tetrahedra.clear(); }},
      {"/solids/0/tetrahedra/2",
       [](Model& m) { std::swap(m.solids[0].tetrahedra[2][0], m.solids[0].tetrahedra[2][1]); }},
      {"/solids/0/tetrahedra/1/3", [](Model& m) { m.solids[0].tetrahedra[1][3] = 8; }},
      {"/solids/0/tetrahedra/1/0", [](Model& m) { m.solids[0].tetrahedra[1][0] = -1; }},
      {"/solids/0/tetrahedra/0",
       [](Model& m) {
         for (Vec3& p : m.solids[0].points) p.z() = 0;
       }},
      {"/solids/0/points/8", [](Model& m) { m.solids[0].points.emplace_back(1, 1, 1); }},
      {"/solids/0/points/3", [](Model& m) { m.solids[0].points[3].y() = std::nan(""); }},
      {"/solids/0/stiffness", [](Model& m) { m.solids[0].stiffness = {1}; }},
      {"/solids/0/stiffness/5", [](Model& m) { m.solids[0].stiffness = {1, 1, 1, 1, 1, -1}; }},
      {"/solids/0/density/0", [](Model& m) { m.solids[0].density = {-1, 1, 1, 1, 1, 1}; }},
  };
  for (const Mistake& mistake : mistakes) {
    Model model = model_of(block({1, 1, 1}, Vec3(0.02, 0.02, 0.02)));
    EXPECT_TRUE(model.validate());
    mistake.make(model);
    const Status status = model.validate();
    ASSERT_FALSE(status) << mistake.where;
    EXPECT_EQ(status.error().where, mistake.where);
    EXPECT_FALSE(status.error().hint.empty()) << mistake.where;
    const Result<Structure> structure = discretize(model);
    ASSERT_FALSE(structure) << mistake.where;
    EXPECT_EQ(structure.error().where, mistake.where);
  }
}

}  // namespace
}  // namespace lissom
