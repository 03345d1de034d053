#pragma once
/// Deformed structures with every energy term, for the tests of third derivatives, and extrapolated differences.

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <utility>

#include "lissom/mechanics/energies.h"
#include "tests/derivatives/derivative_checks.h"
#include "tests/derivatives/folded_sheet.h"

namespace lissom::third {

/// Derivative at 0 of a vector-valued function: central differences at three steps, extrapolated to order h^6.
template <class F>
VecX slope(const F& f) {
  const double h = 0.006;
  const auto central = [&](double step) -> VecX { return (f(step) - f(-step)) / (2 * step); };
  const VecX d1 = central(h), d2 = central(h / 2), d4 = central(h / 4);
  const VecX coarse = (4 * d2 - d1) / 3, fine = (4 * d4 - d2) / 3;
  return (16 * fine - coarse) / 15;
}

inline Rod rod(const char* name, Curve curve, std::vector<double> r_n, std::vector<double> r_b, int edges) {
  Rod r;
  r.name = name;
  r.curve = std::move(curve);
  r.material = "TPU 92A";
  r.section.r_n = std::move(r_n);
  r.section.r_b = std::move(r_b);
  r.edges = edges;
  return r;
}

/// Rods in space, one naturally curved and twisted, with joints of two, three and four ends, under loads of all kinds.
inline Model network(JointKind joints, JointWeights weights) {
  Model model;
  model.joint_kind = joints;
  model.joint_weights = weights;
  const Vec3 o(0, 0, 0), a(0.05, 0, 0.01), b(-0.04, 0.03, 0), c(-0.01, -0.05, -0.01), d(0.06, 0.05, 0.02);
  model.rods.push_back(rod("taper", Polyline{{o, a}}, {0.001, 0.002}, {0.002, 0.001}, 3));
  model.rods.push_back(rod("spline", Spline{{o, Vec3(-0.02, 0.03, 0.01), b}}, {0.001}, {0.0015}, 3));
  model.rods.push_back(rod("curved", Polyline{{c, o}}, {0.0012}, {0.0012}, 3));
  model.rods.push_back(rod("across", Polyline{{o, d}}, {0.001}, {0.003}, 3));
  model.rods.push_back(rod("closing", Polyline{{a, d}}, {0.001}, {0.001}, 3));
  model.rods.push_back(rod("third", Polyline{{b, d}}, {0.002}, {0.001}, 3));
  model.rods[2].natural.kind = Natural::Kind::kCurved;
  model.rods[2].natural.curvature_b = 20;
  model.rods[2].natural.curvature_n = -7;
  model.rods[2].natural.twist = 11;
  Pose pose;
  pose.name = "loaded";
  pose.gravity = Gravity{};
  Selector end;
  end.kind = Selector::Kind::kRod;
  end.name = "curved";
  end.fraction = 0;
  Support clamp;
  clamp.at = end;
  clamp.kind = SupportKind::kClamp;
  pose.supports.push_back(clamp);
  PointMoment moment;
  moment.at = end;
  moment.moment = Vec3(0.001, 0.002, -0.003);
  pose.moments.push_back(moment);
  end.name = "spline";
  end.fraction = 1;
  PointForce force;
  force.at = end;
  force.force = Vec3(0.01, -0.02, 0.03);
  pose.forces.push_back(force);
  LineLoad line;
  line.force_per_length = Vec3(0.1, 0.2, -0.1);
  pose.line_loads.push_back(line);
  SoftPin pin;
  pin.at = end;
  pin.stiffness = 12;
  pin.target = Vec3(0, 0, 0.02);
  pose.soft_pins.push_back(pin);
  model.poses.push_back(pose);
  return model;
}

/// A folded sheet with bending and a warp direction of its own; with rods of all sections from vertex to vertex, or on a solid.
enum class Contents { kSheet, kSheetWithRods, kSheetOnSolid };
inline Model sheet(Contents contents) {
  Model model;
  model.membrane_materials.push_back({"cloth", 20, 35, 0.25, 4e-4, 0.2, "test"});
  const Membrane sheet = folded_sheet(4, 0.7);
  const auto& points = std::get<MembraneMesh>(sheet.shape).points;
  const Vec3 corner = points[0], far = points[15], side = points[3];
  model.membranes.push_back(sheet);
  Pose pose;
  pose.name = "loaded";
  pose.gravity = Gravity{};
  EdgeLoad pull;
  pull.at.kind = Selector::Kind::kAll;
  pull.force_per_length = {0.4, -0.1, 0.2};
  pose.edge_loads.push_back(pull);
  if (contents == Contents::kSheetWithRods) {
    const Vec3 top(0.03, 0.03, 0.05);
    model.rods.push_back(rod("taper", Polyline{{corner, top}}, {1e-3, 2e-3}, {2e-3, 1e-3}, 4));
    model.rods.push_back(rod("lath", Spline{{top, Vec3(0.06, 0.02, 0.04), far}}, {5e-4}, {2e-3}, 4));
    model.rods[1].section.shape = SectionShape::kRectangle;
    model.rods.push_back(rod("tube", Spline{{side, Vec3(0.08, 0.04, 0.02), far}}, {2e-3}, {2e-3}, 4));
    model.rods[2].section.shape = SectionShape::kTube;
    model.rods[2].section.wall = 5e-4;
    model.rods.push_back(rod("curved", Polyline{{corner, side}}, {1e-3}, {1e-3}, 3));
    model.rods[3].natural.kind = Natural::Kind::kCurved;
    model.rods[3].natural.curvature_b = 12;
  }
  if (contents == Contents::kSheetOnSolid) {
    Solid solid = block({3, 3, 1}, Vec3::Ones(), "TPU 92A");
    for (std::size_t i = 0; i < points.size(); ++i) {
      solid.points[points.size() + i] = points[i];
      solid.points[i] = points[i] + Vec3(0.001 * static_cast<double>(i % 3), 0.002, -0.02);
    }
    solid.stiffness = uneven_map(solid.tetrahedra.size());
    solid.density = uneven_map(solid.tetrahedra.size());
    model.solids.push_back(solid);
  }
  model.poses.push_back(pose);
  return model;
}

struct Case {
  const char* name;
  Model (*make)();
  int terms;
};
inline const Case kCases[] = {
    {"Explicit", [] { return network(JointKind::kExplicit, JointWeights::kEnergy); }, 8},
    {"Corotational", [] { return network(JointKind::kCorotational, JointWeights::kEnergy); }, 11},
    {"ThesisWeights", [] { return network(JointKind::kCorotational, JointWeights::kThesis); }, 11},
    {"Sheet", [] { return sheet(Contents::kSheet); }, 4},
    {"RodsOnFabric", [] { return sheet(Contents::kSheetWithRods); }, 7},
    {"FabricOnSolid", [] { return sheet(Contents::kSheetOnSolid); }, 5},
};

/// A model far from rest, over many transported steps.
struct Deformed {
  Model model;
  System system;
  State state;

  explicit Deformed(Model from) : model(std::move(from)) {
    Result<System> made = make_system(model);
    if (!made) {
      ADD_FAILURE() << made.error().text();
      return;
    }
    system = std::move(made).value();
    std::mt19937 random(17);
    state = drawn_state(system);
    state.load_factor = 0.7;
    State next;
    for (int k = 0; k < 40; ++k) {
      EXPECT_TRUE(advance(system, state, checks::random_increment(system, random, 0.05), next));
      std::swap(state, next);
    }
  }

  Potential potential(std::vector<LocalAxes> axes = {}) const {
    auto terms = make_terms(model, system, &model.poses[0], "/poses/0");
    EXPECT_TRUE(terms.ok()) << terms.error().text();
    return Potential(system.layout.size(), std::move(terms).value(), std::move(axes));
  }
};

/// By how much a rest quantity of this value may change.
inline double size_of(double value) { return std::abs(value) > 1e-8 ? 0.3 * std::abs(value) : 0.1; }

inline VecX random_vector(std::mt19937& random, Eigen::Index size) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  VecX x(size);
  for (double& entry : x) entry = uniform(random);
  return x;
}

/// Rest quantities of all terms at numbers + dn.
inline void move_rests(Potential& potential, const Potential& original, const VecX& dn) {
  for (int t = 0; t < static_cast<int>(potential.terms().size()); ++t) {
    EnergyTerm& term = potential.term(t);
    const EnergyTerm& before = *original.terms()[t];
    std::vector<VecX> rest;
    for (int s = 0; s < term.stencils(); ++s) rest.push_back(before.rest(s));
    for (const RestLink& link : before.links()) {
      if (link.number >= dn.size()) continue;  // of loads
      rest[link.entry / term.rests()][link.entry % term.rests()] += link.factor * dn[link.number];
    }
    for (int s = 0; s < term.stencils(); ++s) term.set_rest(s, rest[s]);
  }
}

}  // namespace lissom::third
