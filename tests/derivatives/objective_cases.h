#pragma once
/// Objectives of all kinds on one small structure, and the same structure with other rest numbers, for tests of derivatives.

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "lissom/design/objective_angle.h"
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
#include "lissom/geometry/frame.h"
#include "lissom/mechanics/energies.h"
#include "lissom/mechanics/joint_explicit.h"
#include "lissom/mechanics/rest_numbers.h"

namespace lissom::objective_tests {

inline Rod rod(const char* name, Curve curve, SectionShape shape, double r_n, double r_b) {
  Rod r;
  r.name = name;
  r.curve = std::move(curve);
  r.material = "PLA";
  r.section.shape = shape;
  r.section.r_n = {r_n};
  r.section.r_b = {r_b};
  r.edges = 4;
  return r;
}

/// A folded sheet that bends, rods of all sections across and beside it, held along axes and across them, under loads that
/// hang on rest numbers.
inline Model model_of_everything(JointKind joints) {
  Model model;
  model.joint_kind = joints;
  model.membrane_materials.push_back({"cloth", 20, 35, 0.25, 4e-4, 0.2, "test"});
  Membrane sheet;
  sheet.name = "sheet";
  sheet.material = "cloth";
  sheet.pre_stretch = {1.3, 1.15};
  sheet.warp_angle = 0.4;
  MembraneMesh mesh;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 5; ++i) mesh.points.emplace_back(0.02 * i, 0.021 * j + 0.002 * i, 0.004 * ((i * j) % 3));
  }
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 4; ++i) {
      const int a = 5 * j + i;
      mesh.triangles.push_back({a, a + 1, a + 6});
      mesh.triangles.push_back({a, a + 6, a + 5});
    }
  }
  const Vec3 corner = mesh.points[0], far = mesh.points[19], side = mesh.points[4];
  sheet.shape = std::move(mesh);
  model.membranes.push_back(sheet);
  const Vec3 top(0.03, 0.03, 0.05);
  model.rods.push_back(rod("oval", Polyline{{corner, top}}, SectionShape::kEllipse, 1e-3, 2e-3));
  model.rods.push_back(rod("lath", Spline{{top, Vec3(0.06, 0.02, 0.04), far}}, SectionShape::kRectangle, 5e-4, 2e-3));
  Rod tube = rod("tube", Spline{{side, Vec3(0.08, 0.04, 0.02), far}}, SectionShape::kTube, 2e-3, 2e-3);
  tube.section.wall = 5e-4;
  model.rods.push_back(tube);
  model.rods.push_back(rod("round", Polyline{{corner, side}}, SectionShape::kEllipse, 1e-3, 1e-3));
  Pose pose;
  pose.name = "loaded";
  pose.gravity = Gravity{};
  EdgeLoad pull;
  pull.at.kind = Selector::Kind::kAll;
  pull.force_per_length = {0.4, -0.1, 0.2};
  pose.edge_loads.push_back(pull);
  const auto hold = [&](const Vec3& at, SupportKind kind) {
    Support support;
    support.at.kind = Selector::Kind::kPoint;
    support.at.point = at;
    support.kind = kind;
    pose.supports.push_back(support);
  };
  hold(corner, SupportKind::kPin);
  hold(far, SupportKind::kPin);
  hold(side, SupportKind::kFree);
  pose.supports.back().directions = {Vec3(1, 2, 2) / 3, Vec3(2, 1, -2) / 3};
  model.poses.push_back(pose);
  return model;
}

/// A strained state of a model, which is no equilibrium.
struct Shape {
  Design design;
  StaticProblem problem;
  State state;

  PoseShape pose_shape() const { return {design, design.model.poses[0], problem, state}; }
  int numbers() const { return RestNumbers(design.system.structure).size(); }
  int unknowns() const { return design.system.layout.size(); }
  int node_at(const Vec3& place) const {
    int best = 0;
    const std::vector<Vec3>& nodes = design.system.structure.nodes;
    for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
      if ((nodes[i] - place).norm() < (nodes[best] - place).norm()) best = i;
    }
    return best;
  }
};

/// Each position moved by up to `amplitude` edge lengths, each angle by up to as many rad.
inline VecX random_motion(const System& system, std::mt19937& random, double amplitude) {
  std::uniform_real_distribution<double> uniform(-amplitude, amplitude);
  VecX dq(system.layout.size());
  for (int i = 0; i < dq.size(); ++i) {
    dq[i] = uniform(random) * (system.layout.dof_class(i) == DofClass::kPosition ? system.rest.mean_edge_length : 1);
  }
  return dq;
}

inline std::unique_ptr<Shape> make_shape(const Model& model, double amplitude) {
  Result<System> system = make_system(model);
  if (!system) {
    ADD_FAILURE() << system.error().text();
    return nullptr;
  }
  auto shape = std::make_unique<Shape>(
      Shape{{model, std::move(system).value()}, {nullptr, Potential(0, {}), {}, {}, false, {}}, {}});
  Result<StaticProblem> problem =
      make_static_problem(shape->design.model, shape->design.system, model.poses[0], "/poses/0");
  if (!problem) {
    ADD_FAILURE() << problem.error().text();
    return nullptr;
  }
  shape->problem = std::move(problem).value();
  State drawn = drawn_state(shape->design.system);
  drawn.load_factor = 1;
  std::mt19937 random(7);
  if (!advance(shape->design.system, drawn, random_motion(shape->design.system, random, amplitude), shape->state)) {
    ADD_FAILURE() << "the state cannot be reached";
  }
  return shape;
}

/// Rest numbers of a size that derivatives are judged by: their own, or 0.1 for strains and turns that are 0.
inline VecX random_numbers(const Shape& shape, std::mt19937& random, double amplitude) {
  std::uniform_real_distribution<double> uniform(-amplitude, amplitude);
  VecX dn = rest_number_values(shape.design.system);
  for (int i = 0; i < dn.size(); ++i) dn[i] = uniform(random) * (std::abs(dn[i]) > 1e-12 ? std::abs(dn[i]) : 0.1);
  return dn;
}

/// Rest numbers changed by dn. The turns of rest frames are carried out.
inline System system_with(const Shape& shape, const VecX& dn) {
  System system = shape.design.system;
  const RestNumbers layout(system.structure);
  RestState& rest = system.rest;
  for (int e = 0; e < system.edge_count(); ++e) {
    rest.edges[e].length += dn[layout.edge(e, kEdgeLength)];
    rest.edges[e].stretch += dn[layout.edge(e, kEdgeStretch)];
    rest.edges[e].mass += dn[layout.edge(e, kEdgeMass)];
  }
  const auto change = [&](PairRest& pair, int first) {
    pair.kappa_1 += dn[first + kKappa1];
    pair.kappa_2 += dn[first + kKappa2];
    pair.twist += dn[first + kRestTwist];
    pair.bend_1 += dn[first + kBend1];
    pair.bend_2 += dn[first + kBend2];
    pair.twist_stiffness += dn[first + kTwistStiffness];
    pair.length += dn[first + kPairLength];
  };
  for (std::size_t p = 0; p < rest.pairs.size(); ++p) change(rest.pairs[p], layout.pair(static_cast<int>(p), 0));
  for (std::size_t k = 0; k < rest.connections.size(); ++k) {
    const int first = layout.connection(static_cast<int>(k), 0);
    change(rest.connections[k], first);
    Connection& connection = system.connections[k];
    connection.rest = rotated(rotation_from_vector(dn.segment<3>(first + kRestTurn)), connection.rest);
    const auto numbers = connection_rest_values(rest.connections[k]);
    connection.weight = connection_weights<double>(numbers.data(), shape.design.model.joint_weights);
  }
  for (std::size_t t = 0; t < rest.triangles.size(); ++t) {
    const int first = layout.triangle(static_cast<int>(t), 0);
    for (int i = 0; i < 3; ++i) rest.triangles[t].corner[i] += dn.segment<2>(first + kCorner + 2 * i);
    rest.triangles[t].area += dn[first + kTriangleArea];
  }
  return system;
}

/// Terms whose rest quantities follow the numbers changed by dn, while it lives.
class ChangedTerms {
 public:
  ChangedTerms(Potential& potential, const VecX& dn) : potential_(potential) {
    for (std::size_t i = 0; i < potential.terms().size(); ++i) {
      EnergyTerm& term = potential.term(static_cast<int>(i));
      VecX change = VecX::Zero(term.stencils() * term.rests());
      for (const RestLink& link : term.links()) change[link.entry] += link.factor * dn[link.number];
      for (int s = 0; s < term.stencils(); ++s) {
        before_.push_back(term.rest(s));
        term.set_rest(s, before_.back() + change.segment(s * term.rests(), term.rests()));
      }
    }
  }
  ~ChangedTerms() {
    std::size_t at = 0;
    for (std::size_t i = 0; i < potential_.terms().size(); ++i) {
      EnergyTerm& term = potential_.term(static_cast<int>(i));
      for (int s = 0; s < term.stencils(); ++s) term.set_rest(s, before_[at++]);
    }
  }
  ChangedTerms(const ChangedTerms&) = delete;
  ChangedTerms& operator=(const ChangedTerms&) = delete;

 private:
  Potential& potential_;
  std::vector<VecX> before_;
};

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
  };
  std::vector<int> all;
  for (int i = 0; i < system.layout.nodes(); ++i) all.push_back(i);
  add("places", make_node_positions({3, 7, 1}), Rigid::kOther);
  const auto surface = octahedron({0.04, 0.03, 0.01}, 0.02);
  add("vectors from a surface", make_surface_distance(surface, all, DistanceKind::kVector), Rigid::kOther);
  add("distances from a surface", make_surface_distance(surface, all, DistanceKind::kSigned), Rigid::kOther);
  add("mean place", make_set_position({2, 5, 9}), Rigid::kOther);
  Eigen::Matrix3Xd places(3, 6);
  for (int i = 0; i < 6; ++i) places.col(i) = rotation_from_vector({0.9, -1.2, 0.7}) * system.structure.nodes[i + 2];
  add("turn of a set", taken(make_set_orientation({2, 3, 4, 5, 6, 7}, places)), Rigid::kOther);
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
