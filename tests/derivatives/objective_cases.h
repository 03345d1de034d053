#pragma once
/// Objectives of all kinds on one small structure, with other ways to their components, for tests of derivatives.

#include <functional>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "lissom/design/objective_angle.h"
#include "lissom/design/objective_distance.h"
#include "lissom/design/objective_enclosed_volume.h"
#include "lissom/design/objective_mass.h"
#include "lissom/design/objective_membrane_area.h"
#include "lissom/design/objective_node_positions.h"
#include "lissom/design/objective_reaction_force.h"
#include "lissom/design/objective_rigid_motion.h"
#include "lissom/design/objective_rod_bending.h"
#include "lissom/design/objective_rod_strain.h"
#include "lissom/design/objective_smallest_stretch.h"
#include "lissom/design/objective_strain_energy.h"
#include "lissom/design/objective_surface_distance.h"
#include "lissom/equilibrium/report.h"
#include "lissom/mechanics/energies.h"
#include "tests/derivatives/objective_shape.h"

namespace lissom::objective_tests {

/// Components of an objective at unknowns moved by dq and rest numbers changed by dn.
using Components = std::function<VecX(const VecX& dq, const VecX& dn)>;

/// By `advance`, which changes the anchors and with them nothing that can be measured.
inline Components by_advance(const Shape& shape, const Objective& objective) {
  return [&shape, &objective](const VecX& dq, const VecX& dn) {
    const Design changed{shape.design.model, system_with(shape, dn)};
    State moved;
    EXPECT_TRUE(advance(changed.system, shape.state, dq, moved));
    VecX c;
    objective.values({changed, changed.model.poses[0], shape.problem, moved}, c);
    return c;
  };
}

/// Elastic energy, by automatic derivatives of the terms at their anchors.
inline Components elastic_energy_of(Shape& shape) {
  return [&shape](const VecX& dq, const VecX& dn) {
    const ChangedTerms changed(shape.problem.potential, dn);
    double sum = 0;
    for (const auto& term : shape.problem.potential.terms()) {
      if (!is_elastic(term->name())) continue;
      for (int s = 0; s < term->stencils(); ++s) sum += term->automatic(shape.state, dq, s).energy;
    }
    return VecX::Constant(1, sum).eval();
  };
}

/// Sums of reactions over nodes along axes, from gradients at fixed anchors.
inline Components reaction_of(Shape& shape, std::vector<int> nodes, std::vector<Vec3> axes) {
  return [&shape, nodes, axes](const VecX& dq, const VecX& dn) {
    const ChangedTerms changed(shape.problem.potential, dn);
    VecX gradient = VecX::Zero(dq.size());
    for (const auto& term : shape.problem.potential.terms()) {
      for (int s = 0; s < term->stencils(); ++s) {
        const VecX own = term->automatic(shape.state, dq, s).gradient;
        for (int i = 0; i < term->dofs(); ++i) gradient[term->indices()[s * term->dofs() + i]] += own[i];
      }
    }
    shape.problem.potential.to_local(gradient);
    const VecX reaction = reactions(shape.problem, gradient);
    VecX c = VecX::Zero(static_cast<int>(axes.size()));
    for (std::size_t k = 0; k < axes.size(); ++k) {
      for (const int node : nodes) c[static_cast<int>(k)] += axes[k].normalized().dot(reaction.segment<3>(3 * node));
    }
    return c;
  };
}

enum class Rigid { kSame, kOther };  ///< after a rigid motion of everything

struct Case {
  std::string label;
  std::shared_ptr<const Objective> objective;
  Components components;
  Rigid rigid = Rigid::kOther;
  double step = 2e-3;  ///< of differences: smaller where a root is rounded off nearby
};

inline std::shared_ptr<const Objective> taken(Result<std::shared_ptr<const Objective>> made) {
  if (made) return made.value();
  ADD_FAILURE() << made.error().text();
  return nullptr;
}

/// An octahedron of this size about a centre, whose triangles, edges and corners are near some of the nodes.
inline std::shared_ptr<const TriangleSurface> octahedron(const Vec3& centre, double radius) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 3; ++i) {
    corners.push_back(centre + radius * Vec3::Unit(i));
    corners.push_back(centre - radius * Vec3::Unit(i));
  }
  std::vector<std::array<int, 3>> triangles;
  for (const int x : {0, 1}) {
    for (const int y : {2, 3}) {
      for (const int z : {4, 5}) {
        triangles.push_back((x + y + z) % 2 == 0 ? std::array{x, y, z} : std::array{y, x, z});
      }
    }
  }
  Result<TriangleSurface> made = TriangleSurface::make(corners, triangles, "surface");
  EXPECT_TRUE(made.ok());
  return std::make_shared<const TriangleSurface>(std::move(made).value());
}

/// One of every objective at least, but for the stability margin.
inline std::vector<Case> cases_of(Shape& shape) {
  const System& system = shape.design.system;
  std::vector<Case> cases;
  const auto add = [&](std::string label, std::shared_ptr<const Objective> objective, Rigid rigid) {
    ASSERT_NE(objective, nullptr);
    Components components = by_advance(shape, *objective);
    cases.push_back({std::move(label), std::move(objective), std::move(components), rigid});
    if (cases.back().objective->unit().empty()) cases.back().step = 5e-4;
  };
  std::vector<int> all;
  for (int i = 0; i < system.layout.nodes(); ++i) all.push_back(i);
  add("places", make_node_positions({3, 7, 1}), Rigid::kOther);
  const auto surface = octahedron({0.06, 0.045, 0.015}, 0.03);
  add("vectors from a surface", make_surface_distance(surface, all, DistanceKind::kVector), Rigid::kOther);
  add("distances from a surface", make_surface_distance(surface, all, DistanceKind::kSigned), Rigid::kOther);
  add("mean place", make_set_position({2, 5, 9}), Rigid::kOther);
  Eigen::Matrix3Xd places(3, 6);
  for (int i = 0; i < 6; ++i) places.col(i) = rotation_from_vector({0.9, -1.2, 0.7}) * system.structure.nodes[i + 2];
  add("turn of a set", taken(make_set_orientation({2, 3, 4, 5, 6, 7}, places)), Rigid::kOther);
  add("distance", make_distance(std::vector<int>{2, 5}, {7, 9, 12}, {}), Rigid::kSame);
  add("distance along an axis", make_distance(Vec3(0.01, 0.02, -0.1), {7, 9}, Vec3(1, 2, -3)), Rigid::kOther);
  add("angle", make_angle({0, 7, 3, 12}), Rigid::kSame);
  add("angle at a node", make_angle({6, 7, 6, 12}), Rigid::kSame);
  add("angle about an axis", make_angle({0, 7, 3, 12}, Vec3(0.3, -0.4, 2)), Rigid::kOther);
  add("area", make_membrane_area(), Rigid::kSame);
  add("volume", taken(make_enclosed_volume(system.structure)), Rigid::kSame);
  add("volume under an apex", taken(make_enclosed_volume(system.structure, {0}, Vec3(0.05, 0.02, -0.1))),
      Rigid::kOther);
  add("mass", make_mass(), Rigid::kSame);
  add("mass of a rod", make_mass({{1}, {}}), Rigid::kSame);
  add("volume of material", taken(make_material_volume(shape.design.model, system.structure)), Rigid::kSame);
  add("energy", make_strain_energy(), Rigid::kSame);
  cases.back().components = elastic_energy_of(shape);
  add("stretches", make_smallest_stretch(system.structure), Rigid::kSame);
  add("strains of rods", make_rod_strain(system), Rigid::kSame);
  add("strains of a rod", make_rod_strain(system, {1}), Rigid::kSame);
  add("bending of rods", make_rod_bending(system.structure), Rigid::kOther);
  const std::vector<int> held = {shape.node_at(Vec3::Zero()), shape.node_at({0.08, 0.008, 0}), 7};
  const std::vector<Vec3> axes = {Vec3::UnitX(), Vec3(1, 2, -3)};
  add("reaction", make_reaction_force(held, axes), Rigid::kOther);
  cases.back().components = reaction_of(shape, held, axes);
  return cases;
}

}  // namespace lissom::objective_tests
