#pragma once
/// One small structure with everything in it, strained, and the same with other unknowns and rest numbers: what derivatives of
/// objectives are tested on.

#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "lissom/design/objective.h"
#include "lissom/geometry/frame.h"
#include "lissom/mechanics/joint_explicit.h"
#include "lissom/mechanics/rest_numbers.h"
#include "tests/derivatives/folded_sheet.h"

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
  const Membrane sheet = folded_sheet(5, Membrane().bending);
  const auto& points = std::get<MembraneMesh>(sheet.shape).points;
  const Vec3 corner = points[0], far = points[19], side = points[4];
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

/// Names of tests with either joint.
inline std::string joint_name(const testing::TestParamInfo<JointKind>& joints) {
  return joints.param == JointKind::kExplicit ? "Explicit" : "Corotational";
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

/// `stretch`: by which everything has grown before it is moved at random.
inline std::unique_ptr<Shape> make_shape(const Model& model, double amplitude, double stretch = 0) {
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
  const int drawn_positions = 3 * shape->design.system.layout.nodes();
  drawn.load_factor = 1;
  std::mt19937 random(7);
  VecX dq = random_motion(shape->design.system, random, amplitude);
  dq.head(drawn_positions) += stretch * drawn.q.head(drawn_positions);
  if (!advance(shape->design.system, drawn, dq, shape->state)) {
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
      for (const RestLink& link : term.links()) {
        if (link.number < dn.size()) change[link.entry] += link.factor * dn[link.number];  // the others are of loads
      }
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

}  // namespace lissom::objective_tests
