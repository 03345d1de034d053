#include "lissom/equilibrium/static_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lissom/mechanics/energies.h"

namespace lissom {

namespace {

/// Largest force on a node and largest moment / L0 on a joint from loads that are linear in the unknowns, at factor 1.
double largest_load(const System& system, const Potential& potential) {
  State state = drawn_state(system);
  state.load_factor = 1;
  AssemblyBuffers buffers;
  double largest = 0;
  VecX load = VecX::Zero(system.layout.size());
  for (const auto& term : potential.terms()) {
    if (term->has_hessian()) continue;
    buffers.gradient.resize(static_cast<size_t>(term->groups()) * kLanes * term->dofs());
    term->derivatives(state, 0, term->groups(), buffers.gradient.data(), nullptr);
    for (int s = 0; s < term->stencils(); ++s) {
      for (int i = 0; i < term->dofs(); ++i) {
        load[term->indices()[s * term->dofs() + i]] += buffers.gradient[static_cast<size_t>(s) * term->dofs() + i];
      }
    }
  }
  for (int i = 0; i < system.layout.nodes(); ++i) largest = std::max(largest, load.segment<3>(3 * i).norm());
  for (int k = 0; k < system.layout.rotations(); ++k) {
    const int r = system.layout.rotation(system.layout.joint_of_rotation(k));
    largest = std::max(largest, load.segment<3>(r).norm() / system.rest.mean_edge_length);
  }
  return largest;
}

/// Of the solids together: E A (N) and E I / L^3 (N/m) of a square bar as long as the structure with their volume and, on
/// average, their modulus.
struct BarOfSolids {
  double stretch = 0, bending = 0;

  explicit BarOfSolids(const System& system) {
    const double length = system.structure.size;
    double volume = 0, stiffness = 0;  // m^3, Pa m^3
    for (const TetrahedronRest& tetrahedron : system.rest.tetrahedra) {
      const double share = tetrahedron.lambda / (tetrahedron.lambda + tetrahedron.mu);  // 2 nu
      volume += tetrahedron.volume;
      stiffness += tetrahedron.mu * (2 + share) * tetrahedron.volume;
    }
    stretch = stiffness / length;
    bending = stretch * volume / (12 * std::pow(length, 4));
  }
};

Scales make_scales(const System& system, const Potential& potential) {
  Scales scales;
  scales.length = system.structure.size;
  const BarOfSolids solids(system);
  scales.force = std::max({largest_load(system, potential), 1e-6 * system.rest.max_stretch,
                           system.rest.max_tension * system.rest.mean_edge_length, 1e-6 * solids.stretch});
  scales.moment = scales.force * system.rest.mean_edge_length;
  // An edge length is known to machine precision of the coordinates; the axial force amplifies it by E A / l.
  double reach = 0, stiffest = 0, bend = 0;
  for (const Vec3& x : system.structure.nodes) reach = std::max(reach, x.cwiseAbs().maxCoeff());
  for (const EdgeRest& edge : system.rest.edges) stiffest = std::max(stiffest, edge.stretch / edge.length);
  for (const PairRest& pair : system.rest.pairs) bend = std::max({bend, pair.bend_1, pair.bend_2});
  for (const PairRest& pair : system.rest.connections) bend = std::max({bend, pair.bend_1, pair.bend_2});
  for (const TriangleRest& triangle : system.rest.triangles) {
    stiffest = std::max({stiffest, triangle.stiffness_1, triangle.stiffness_2});
  }
  for (const TetrahedronRest& tetrahedron : system.rest.tetrahedra) {
    stiffest = std::max(stiffest, (tetrahedron.lambda + 2 * tetrahedron.mu) * std::cbrt(tetrahedron.volume));
  }
  scales.rounding = 4 * std::numeric_limits<double>::epsilon() * stiffest * (reach + scales.length);
  scales.stiffness =
      bend > 0 ? bend / std::pow(scales.length, 3) : std::max(system.rest.max_stretch / scales.length, solids.bending);
  return scales;
}

VecX make_mode_metric(const System& system, const Supports& supports) {
  VecX metric = VecX::Zero(system.layout.size());
  double length = 0, area = 0, volume = 0;
  for (const EdgeRest& edge : system.rest.edges) length += edge.length;
  for (const TriangleRest& triangle : system.rest.triangles) area += triangle.area;
  for (const TetrahedronRest& tetrahedron : system.rest.tetrahedra) volume += tetrahedron.volume;
  // Rods, membranes and solids count alike where there are several of them.
  const double share_of_each = 1.0 / std::max(1, (length > 0) + (area > 0) + (volume > 0));
  const double per_length = length > 0 ? share_of_each / length : 0;
  const double per_area = area > 0 ? share_of_each / area : 0;
  const double per_volume = volume > 0 ? share_of_each / volume : 0;
  for (int i = 0; i < system.layout.nodes(); ++i) {
    const double share = per_length * system.rest.node_length[i] + per_area * system.rest.node_area[i] +
                         per_volume * system.rest.node_volume[i];
    metric.segment<3>(3 * i).setConstant(share);
  }
  for (int e = 0; e < system.edge_count(); ++e) {
    metric[system.layout.roll(e)] = per_length * system.rest.edges[e].length * system.rest.edges[e].gyration2;
  }
  VecX free;
  supports.restrict(metric, free);
  return free;
}

bool same_topology(const Structure& a, const Structure& b) {
  const auto equal = [](const auto& x, const auto& y, const auto& same) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), same);
  };
  return a.nodes.size() == b.nodes.size() &&
         equal(
             a.edges, b.edges,
             [](const StructureEdge& x, const StructureEdge& y) { return x.node0 == y.node0 && x.node1 == y.node1; }) &&
         equal(
             a.pairs, b.pairs,
             [](const StructurePair& x, const StructurePair& y) { return x.edge0 == y.edge0 && x.edge1 == y.edge1; }) &&
         equal(a.joints, b.joints,
               [&](const StructureJoint& x, const StructureJoint& y) {
                 return x.node == y.node && x.kind == y.kind &&
                        equal(x.connections, y.connections, [](const JointConnection& c, const JointConnection& d) {
                          return c.edge == d.edge && c.direction == d.direction;
                        });
               }) &&
         equal(a.triangles, b.triangles,
               [](const StructureTriangle& x, const StructureTriangle& y) { return x.node == y.node; }) &&
         equal(a.hinges, b.hinges, [](const StructureHinge& x, const StructureHinge& y) { return x.node == y.node; }) &&
         equal(a.tetrahedra, b.tetrahedra,
               [](const StructureTetrahedron& x, const StructureTetrahedron& y) { return x.node == y.node; });
}

}  // namespace

Status renew_numbers(const Model& model, const Pose& pose, const std::string& where, System& system,
                     StaticProblem& problem) {
  Result<System> changed = make_system(model);
  if (!changed) return changed.error();
  return renew_numbers(model, pose, where, std::move(changed).value(), system, problem);
}

Status renew_numbers(const Model& model, const Pose& pose, const std::string& where, System changed, System& system,
                     StaticProblem& problem) {
  auto terms = make_terms(model, changed, &pose, where);
  if (!terms) return terms.error();
  const Result<Supports> supports = Supports::make(model, changed, pose, where, NullMotions::kKeep);
  if (!supports) return supports.error();
  bool same = same_topology(system.structure, changed.structure) && problem.supports.same_held(supports.value()) &&
              terms.value().size() == problem.potential.terms().size();
  for (size_t t = 0; same && t < terms.value().size(); ++t) {
    same = terms.value()[t]->stencils() == problem.potential.terms()[t]->stencils();
  }
  if (!same) {
    return Error{ErrorCode::kConflict, where, "the changed structure has other nodes, joints, triangles or supports",
                 "discretise it anew and carry the shape over"};
  }
  system = std::move(changed);
  problem.potential.replace_terms(std::move(terms).value());
  problem.supports.take_places(supports.value());
  problem.scales = make_scales(system, problem.potential);
  problem.mode_metric = make_mode_metric(system, problem.supports);
  return {};
}

Result<StaticProblem> make_static_problem(const Model& model, const System& system, const Pose& pose,
                                          const std::string& where, NullMotions null_motions) {
  Result<Supports> supports = Supports::make(model, system, pose, where, null_motions);
  if (!supports) return supports.error();
  auto terms = make_terms(model, system, &pose, where);
  if (!terms) return terms.error();
  Potential potential(system.layout.size(), std::move(terms).value(), supports.value().local_axes());
  const Scales scales = make_scales(system, potential);
  VecX metric = make_mode_metric(system, supports.value());
  const bool stretches = pose.stretch_scaling == Scaling::kProportional && system.rest.max_tension != 0;
  return StaticProblem{&system,   std::move(potential), std::move(supports).value(), scales,
                       stretches, std::move(metric)};
}

}  // namespace lissom
