#include <algorithm>
#include <utility>

#include "lissom/mechanics/energy_builders.h"
#include "lissom/mechanics/loads.h"
#include "lissom/model/membrane_rim.h"

namespace lissom {

namespace {

RestLinks ascending(RestLinks links) {
  std::stable_sort(links.begin(), links.end(), [](const RestLink& a, const RestLink& b) { return a.entry < b.entry; });
  return links;
}

/// Loads per length, lumped on nodes by half of each edge that they act on.
class LineLoadBuilder {
 public:
  explicit LineLoadBuilder(const EnergySource& source)
      : source_(source), length_(source.system.structure.nodes.size(), 0), links_at_(length_.size()) {}

  /// An edge of this length (m, the rest number `number`) carries the present load.
  void take(int node0, int node1, double length, int number) {
    for (const int node : {node0, node1}) {
      length_[node] += length / 2;
      links_at_[node].push_back(number);
    }
  }

  /// Makes the stencils of the edges taken since the last load; false when there are none.
  bool finish_load(const Vec3& force_per_length, Scaling scaling) {
    bool any = false;
    for (int i = 0; i < static_cast<int>(length_.size()); ++i) {
      if (length_[i] == 0) continue;
      any = true;
      const int entry = static_cast<int>(energy_.stencils.size());
      for (const int number : links_at_[i]) links_.push_back({entry, number, 0.5});
      energy_.stencils.push_back({source_.node_dofs(i), {length_[i]}, source_.drawn(i), force_per_length, scaling});
      length_[i] = 0;
      links_at_[i].clear();
    }
    return any;
  }

  void finish(EnergyTerms& terms) { add_term(terms, std::move(energy_), std::move(links_)); }

 private:
  const EnergySource& source_;
  NodeLineLoad energy_;
  RestLinks links_;
  std::vector<double> length_;              // by node, of the present load
  std::vector<std::vector<int>> links_at_;  // by node
};

}  // namespace

Status add_gravity(const EnergySource& source, EnergyTerms& terms) {
  if (!source.pose->gravity) return {};
  NodeGravity energy;
  energy.acceleration = source.pose->gravity->acceleration;
  energy.scaling = source.pose->gravity->scaling;
  const Structure& structure = source.system.structure;
  for (int i = 0; i < source.system.layout.nodes(); ++i) {
    energy.stencils.push_back({source.node_dofs(i), {source.system.rest.node_mass[i]}, source.drawn(i)});
  }
  RestLinks links;
  for (int e = 0; e < source.system.edge_count(); ++e) {
    for (const int node : {structure.edges[e].node0, structure.edges[e].node1}) {
      links.push_back({node, source.numbers.edge(e, kEdgeMass), 0.5});
    }
  }
  for (int t = 0; t < static_cast<int>(structure.triangles.size()); ++t) {
    const StructureMembrane& membrane = structure.membranes[structure.triangles[t].membrane];
    const double density = source.model.membrane_material(membrane.material)->area_density;
    for (const int node : structure.triangles[t].node) {
      links.push_back({node, source.numbers.triangle(t, kTriangleArea), density / 3});
    }
  }
  add_term(terms, std::move(energy), ascending(std::move(links)));
  return {};
}

Status add_line_loads(const EnergySource& source, EnergyTerms& terms) {
  LineLoadBuilder loads(source);
  for (size_t l = 0; l < source.pose->line_loads.size(); ++l) {
    const LineLoad& load = source.pose->line_loads[l];
    const auto take = [&](const StructureRod& rod) {
      for (const int e : rod.edges) {
        const StructureEdge& edge = source.system.structure.edges[e];
        loads.take(edge.node0, edge.node1, source.system.rest.edges[e].length, source.numbers.edge(e, kEdgeLength));
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
    loads.finish_load(load.force_per_length, load.scaling);
  }
  loads.finish(terms);
  return {};
}

Status add_edge_loads(const EnergySource& source, EnergyTerms& terms) {
  const Structure& structure = source.system.structure;
  LineLoadBuilder loads(source);
  for (size_t l = 0; l < source.pose->edge_loads.size(); ++l) {
    const EdgeLoad& load = source.pose->edge_loads[l];
    const Result<std::vector<int>> nodes = source.nodes(load.at, source.place("edge_loads", l));
    if (!nodes) return nodes.error();
    std::vector<bool> selected(structure.nodes.size(), false);
    for (const int node : nodes.value()) selected[node] = true;
    for (size_t m = 0; m < structure.membranes.size(); ++m) {
      for (const RimLoop& loop : rim_loops(structure, static_cast<int>(m))) {
        for (const RimEdge& edge : loop) {
          if (!selected[edge.node0] || !selected[edge.node1]) continue;
          const std::array<Vec2, 3>& corner = source.system.rest.triangles[edge.triangle].corner;
          const int from = edge.corner;
          loads.take(edge.node0, edge.node1, (corner[(from + 1) % 3] - corner[from]).norm(),
                     source.numbers.triangle(edge.triangle, kSide + from));
        }
      }
    }
    if (!loads.finish_load(load.force_per_length, load.scaling)) {
      return Error{ErrorCode::kGeometry, source.place("edge_loads", l) + "/at",
                   "no edge at the rim of a membrane has both its ends in this selection",
                   "select at least two neighbouring vertices of a rim"};
    }
  }
  loads.finish(terms);
  return {};
}

Status add_forces(const EnergySource& source, EnergyTerms& terms) {
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
  add_term(terms, std::move(energy));
  return {};
}

Status add_moments(const EnergySource& source, EnergyTerms& terms) {
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
  add_term(terms, std::move(energy));
  return {};
}

Status add_soft_pins(const EnergySource& source, EnergyTerms& terms) {
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
  add_term(terms, std::move(energy));
  return {};
}

}  // namespace lissom
