#include "lissom/mechanics/energies.h"

#include <utility>

#include "lissom/mechanics/corotational_joints.h"
#include "lissom/mechanics/joint_corotational_kernel.h"
#include "lissom/mechanics/joint_explicit.h"
#include "lissom/mechanics/loads.h"
#include "lissom/mechanics/membrane_bend.h"
#include "lissom/mechanics/membrane_stretch.h"
#include "lissom/mechanics/rod_bend_twist.h"
#include "lissom/mechanics/rod_stretch.h"
#include "lissom/model/membrane_rim.h"

namespace lissom {

namespace {

using Terms = std::vector<std::unique_ptr<EnergyTerm>>;

struct Source {
  const Model& model;
  const System& system;
  const Pose* pose;
  std::string where;

  std::string place(const char* list, size_t i) const { return where + "/" + list + "/" + std::to_string(i); }
  std::array<int, 3> node_dofs(int node) const { return {3 * node, 3 * node + 1, 3 * node + 2}; }
  Vec3 drawn(int node) const { return system.structure.nodes[node]; }
  Result<std::vector<int>> nodes(const Selector& at, const std::string& where_at) const {
    return select(model, system.structure, at, where_at + "/at");
  }
};

template <class E>
void add(Terms& terms, E energy) {
  if (!energy.stencils.empty()) terms.push_back(make_term(std::move(energy)));
}

Status stretch(const Source& source, Terms& terms) {
  RodStretch energy;
  for (int e = 0; e < source.system.edge_count(); ++e) {
    const StructureEdge& edge = source.system.structure.edges[e];
    const int a = 3 * edge.node0, b = 3 * edge.node1;
    const EdgeRest& rest = source.system.rest.edges[e];
    energy.stencils.push_back({{a, a + 1, a + 2, b, b + 1, b + 2}, {rest.length, rest.stretch}, e});
  }
  add(terms, std::move(energy));
  return {};
}

Status bend_twist(const Source& source, Terms& terms) {
  const Structure& structure = source.system.structure;
  RodBendTwist energy;
  for (int p = 0; p < static_cast<int>(structure.pairs.size()); ++p) {
    const StructurePair& pair = structure.pairs[p];
    const int a = 3 * structure.edges[pair.edge0].node0, b = 3 * structure.edges[pair.edge0].node1;
    const int c = 3 * structure.edges[pair.edge1].node1;
    energy.stencils.push_back({{a, a + 1, a + 2, b, b + 1, b + 2, c, c + 1, c + 2,
                                source.system.layout.roll(pair.edge0), source.system.layout.roll(pair.edge1)},
                               rest_values(source.system.rest.pairs[p]),
                               p,
                               pair.edge0,
                               pair.edge1});
  }
  add(terms, std::move(energy));
  return {};
}

Status explicit_joints(const Source& source, Terms& terms) {
  const System& system = source.system;
  JointExplicit energy;
  for (int k = 0; k < static_cast<int>(system.connections.size()); ++k) {
    const Connection& c = system.connections[k];
    const int r = system.layout.rotation(c.joint);
    if (r < 0) continue;
    const StructureEdge& edge = system.structure.edges[c.edge];
    const int a = 3 * edge.node0, b = 3 * edge.node1;
    energy.stencils.push_back({{a, a + 1, a + 2, b, b + 1, b + 2, system.layout.roll(c.edge), r, r + 1, r + 2},
                               connection_rest_values(system.rest.connections[k]),
                               k,
                               c.edge,
                               c.joint,
                               c.direction,
                               c.rest});
  }
  add(terms, std::move(energy));
  return {};
}

Status corotational_joints(const Source& source, Terms& terms) {
  for (int j = 0; j < source.system.joint_count(); ++j) {
    const int edges = source.system.first_connection[j + 1] - source.system.first_connection[j];
    if (source.system.layout.rotation(j) < 0 && (edges < 2 || edges > kMaxCorotationalEdges)) {
      return Error{ErrorCode::kUnsupported, "joint at node " + std::to_string(source.system.structure.joints[j].node),
                   std::to_string(edges) + " rod ends meet in a corotational joint; 2 to 8 can",
                   "make this joint explicit"};
    }
  }
  append_corotational_joints(source.model, source.system, terms);
  return {};
}

Status membrane_stretch(const Source& source, Terms& terms) {
  const Structure& structure = source.system.structure;
  MembraneStretch energy;
  const bool proportional = source.pose != nullptr && source.pose->stretch_scaling == Scaling::kProportional;
  for (size_t t = 0; t < structure.triangles.size(); ++t) {
    const StructureTriangle& triangle = structure.triangles[t];
    const TriangleRest& rest = source.system.rest.triangles[t];
    MembraneStretch::Stencil stencil;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) stencil.dofs[3 * i + k] = 3 * triangle.node[i] + k;
      for (int k = 0; k < 2; ++k) stencil.rest[2 * i + k] = rest.corner[i][k];
    }
    stencil.rest[6] = rest.stiffness_1;
    stencil.rest[7] = rest.stiffness_2;
    stencil.rest[8] = rest.poisson_ratio;
    if (proportional) stencil.pre_stretch = structure.membranes[triangle.membrane].pre_stretch;
    energy.stencils.push_back(stencil);
  }
  energy.scaling = proportional ? Scaling::kProportional : Scaling::kConstant;
  add(terms, std::move(energy));
  return {};
}

Status membrane_bend(const Source& source, Terms& terms) {
  const Structure& structure = source.system.structure;
  MembraneBend energy;
  for (size_t h = 0; h < structure.hinges.size(); ++h) {
    const HingeRest& rest = source.system.rest.hinges[h];
    if (rest.stiffness == 0) continue;
    MembraneBend::Stencil stencil{{}, {rest.stiffness, rest.angle}};
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 3; ++k) stencil.dofs[3 * i + k] = 3 * structure.hinges[h].node[i] + k;
    }
    energy.stencils.push_back(stencil);
  }
  add(terms, std::move(energy));
  return {};
}

Status gravity(const Source& source, Terms& terms) {
  if (!source.pose->gravity) return {};
  NodeGravity energy;
  energy.acceleration = source.pose->gravity->acceleration;
  energy.scaling = source.pose->gravity->scaling;
  for (int i = 0; i < source.system.layout.nodes(); ++i) {
    energy.stencils.push_back({source.node_dofs(i), {source.system.rest.node_mass[i]}, source.drawn(i)});
  }
  add(terms, std::move(energy));
  return {};
}

Status line_loads(const Source& source, Terms& terms) {
  NodeLineLoad energy;
  for (size_t l = 0; l < source.pose->line_loads.size(); ++l) {
    const LineLoad& load = source.pose->line_loads[l];
    std::vector<double> length(source.system.structure.nodes.size(), 0);
    const auto take = [&](const StructureRod& rod) {
      for (const int e : rod.edges) {
        const double half = source.system.rest.edges[e].length / 2;
        length[source.system.structure.edges[e].node0] += half;
        length[source.system.structure.edges[e].node1] += half;
      }
    };
    if (load.rods.empty()) {
      for (const StructureRod& rod : source.system.structure.rods) take(rod);
    }
    for (const std::string& name : load.rods) {
      const int r = source.system.structure.rod_index(name);
      if (r < 0) {
        return Error{ErrorCode::kUnknown, source.place("line_loads", l), "there is no rod \"" + name + "\"",
                     "name one of the rods"};
      }
      take(source.system.structure.rods[r]);
    }
    for (int i = 0; i < static_cast<int>(length.size()); ++i) {
      if (length[i] == 0) continue;
      energy.stencils.push_back(
          {source.node_dofs(i), {length[i]}, source.drawn(i), load.force_per_length, load.scaling});
    }
  }
  add(terms, std::move(energy));
  return {};
}

Status edge_loads(const Source& source, Terms& terms) {
  const Structure& structure = source.system.structure;
  NodeLineLoad energy;
  for (size_t l = 0; l < source.pose->edge_loads.size(); ++l) {
    const EdgeLoad& load = source.pose->edge_loads[l];
    const Result<std::vector<int>> nodes = source.nodes(load.at, source.place("edge_loads", l));
    if (!nodes) return nodes.error();
    std::vector<bool> selected(structure.nodes.size(), false);
    for (const int node : nodes.value()) selected[node] = true;
    std::vector<double> length(structure.nodes.size(), 0);
    for (size_t m = 0; m < structure.membranes.size(); ++m) {
      for (const RimLoop& loop : rim_loops(structure, static_cast<int>(m))) {
        for (const RimEdge& edge : loop) {
          if (!selected[edge.node0] || !selected[edge.node1]) continue;
          const std::array<Vec2, 3>& corner = source.system.rest.triangles[edge.triangle].corner;
          const double half = 0.5 * (corner[(edge.corner + 1) % 3] - corner[edge.corner]).norm();
          length[edge.node0] += half;
          length[edge.node1] += half;
        }
      }
    }
    bool loaded = false;
    for (int i = 0; i < static_cast<int>(length.size()); ++i) {
      if (length[i] == 0) continue;
      loaded = true;
      energy.stencils.push_back(
          {source.node_dofs(i), {length[i]}, source.drawn(i), load.force_per_length, load.scaling});
    }
    if (!loaded) {
      return Error{ErrorCode::kGeometry, source.place("edge_loads", l) + "/at",
                   "no edge at the rim of a membrane has both its ends in this selection",
                   "select at least two neighbouring vertices of a rim"};
    }
  }
  add(terms, std::move(energy));
  return {};
}

Status forces(const Source& source, Terms& terms) {
  NodeForce energy;
  for (size_t i = 0; i < source.pose->forces.size(); ++i) {
    const PointForce& force = source.pose->forces[i];
    const Result<std::vector<int>> nodes = source.nodes(force.at, source.place("forces", i));
    if (!nodes) return nodes.error();
    const double share = force.shared ? 1.0 / static_cast<double>(nodes.value().size()) : 1.0;
    for (const int node : nodes.value()) {
      const Vec3 f = share * force.force;
      energy.stencils.push_back({source.node_dofs(node), {f.x(), f.y(), f.z()}, source.drawn(node), force.scaling});
    }
  }
  add(terms, std::move(energy));
  return {};
}

Status moments(const Source& source, Terms& terms) {
  JointMoment energy;
  for (size_t i = 0; i < source.pose->moments.size(); ++i) {
    const PointMoment& moment = source.pose->moments[i];
    const Result<std::vector<int>> nodes = source.nodes(moment.at, source.place("moments", i));
    if (!nodes) return nodes.error();
    for (const int node : nodes.value()) {
      const int joint = source.system.joint_of_node[node];
      const int r = joint < 0 ? -1 : source.system.layout.rotation(joint);
      if (r < 0) {
        return Error{ErrorCode::kConflict, source.place("moments", i) + "/at",
                     "node " + std::to_string(node) + " has no frame of its own to carry a moment",
                     "make the joint there explicit, or put the moment on a rod end"};
      }
      const Vec3& m = moment.moment;
      energy.stencils.push_back({{r, r + 1, r + 2}, {m.x(), m.y(), m.z()}, joint, moment.scaling});
    }
  }
  add(terms, std::move(energy));
  return {};
}

Status soft_pins(const Source& source, Terms& terms) {
  NodeSoftPin energy;
  for (size_t i = 0; i < source.pose->soft_pins.size(); ++i) {
    const SoftPin& pin = source.pose->soft_pins[i];
    const Result<std::vector<int>> nodes = source.nodes(pin.at, source.place("soft_pins", i));
    if (!nodes) return nodes.error();
    for (const int node : nodes.value()) {
      const Vec3 target = pin.target.value_or(source.drawn(node));
      energy.stencils.push_back({source.node_dofs(node), {pin.stiffness, target.x(), target.y(), target.z()}});
    }
  }
  add(terms, std::move(energy));
  return {};
}

using Builder = Status (*)(const Source&, Terms&);

/// One line per energy.
constexpr Builder kElastic[] = {stretch,          bend_twist,   explicit_joints, corotational_joints,
                                membrane_stretch, membrane_bend};
constexpr Builder kOfPose[] = {gravity, line_loads, edge_loads, forces, moments, soft_pins};

}  // namespace

Result<Terms> make_terms(const Model& model, const System& system, const Pose* pose, const std::string& where) {
  const Source source{model, system, pose, where};
  Terms terms;
  for (const Builder build : kElastic) {
    const Status status = build(source, terms);
    if (!status) return status.error();
  }
  if (pose == nullptr) return terms;
  for (const Builder build : kOfPose) {
    const Status status = build(source, terms);
    if (!status) return status.error();
  }
  return terms;
}

}  // namespace lissom
