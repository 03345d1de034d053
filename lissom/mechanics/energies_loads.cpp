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

/// Three rest quantities from `entry` on that are the load numbers from `load` on.
void link_three(const EnergySource& source, RestLinks& links, int entry, int load, double factor = 1) {
  for (int i = 0; i < 3; ++i) links.push_back({entry + i, source.load_number(load + i), factor});
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

  /// Makes the stencils of the edges taken since the last load, whose numbers start at `load`; false when there are none.
  bool finish_load(const Vec3& force_per_length, Scaling scaling, int load) {
    bool any = false;
    for (int i = 0; i < static_cast<int>(length_.size()); ++i) {
      if (length_[i] == 0) continue;
      any = true;
      const int entry = NodeLineLoad::kRest * static_cast<int>(energy_.stencils.size());
      for (const int number : links_at_[i]) links_.push_back({entry, number, 0.5});
      link_three(source_, links_, entry + 1, load);
      const Vec3& w = force_per_length;
      energy_.stencils.push_back({source_.node_dofs(i), {length_[i], w.x(), w.y(), w.z()}, source_.drawn(i), scaling});
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
  const Vec3& g = source.pose->gravity->acceleration;
  energy.scaling = source.pose->gravity->scaling;
  const Structure& structure = source.system.structure;
  for (int i = 0; i < source.system.layout.nodes(); ++i) {
    energy.stencils.push_back(
        {source.node_dofs(i), {source.system.rest.node_mass[i], g.x(), g.y(), g.z()}, source.drawn(i)});
  }
  RestLinks links;
  constexpr int kRest = NodeGravity::kRest;
  for (int e = 0; e < source.system.edge_count(); ++e) {
    for (const int node : {structure.edges[e].node0, structure.edges[e].node1}) {
      links.push_back({kRest * node, source.numbers.edge(e, kEdgeMass), 0.5});
    }
  }
  for (int t = 0; t < static_cast<int>(structure.triangles.size()); ++t) {
    const StructureMembrane& membrane = structure.membranes[structure.triangles[t].membrane];
    const double density =
        structure.triangles[t].density * source.model.membrane_material(membrane.material)->area_density;
    for (const int node : structure.triangles[t].node) {
      links.push_back({kRest * node, source.numbers.triangle(t, kTriangleArea), density / 3});
    }
  }
  for (int t = 0; t < static_cast<int>(structure.tetrahedra.size()); ++t) {
    const StructureTetrahedron& own = structure.tetrahedra[t];
    const double density = own.density * source.model.material(structure.solids[own.solid].material)->density;
    for (const int node : own.node) {
      links.push_back({kRest * node, source.numbers.tetrahedron(t, kTetrahedronVolume), density / 4});
    }
  }
  for (int i = 0; i < source.system.layout.nodes(); ++i) {
    link_three(source, links, kRest * i + 1, source.loads.gravity());
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
    loads.finish_load(load.force_per_length, load.scaling, source.loads.line_load(static_cast<int>(l)));
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
    if (!loads.finish_load(load.force_per_length, load.scaling, source.loads.edge_load(static_cast<int>(l)))) {
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
  RestLinks links;
  for (size_t i = 0; i < source.pose->forces.size(); ++i) {
    const PointForce& force = source.pose->forces[i];
    const Result<std::vector<int>> nodes = source.nodes(force.at, source.place("forces", i));
    if (!nodes) return nodes.error();
    const double share = force.shared ? 1.0 / static_cast<double>(nodes.value().size()) : 1.0;
    for (const int node : nodes.value()) {
      const Vec3 f = share * force.force;
      link_three(source, links, NodeForce::kRest * static_cast<int>(energy.stencils.size()),
                 source.loads.force(static_cast<int>(i)), share);
      energy.stencils.push_back({source.node_dofs(node), {f.x(), f.y(), f.z()}, source.drawn(node), force.scaling});
    }
  }
  add_term(terms, std::move(energy), std::move(links));
  return {};
}

Status add_moments(const EnergySource& source, EnergyTerms& terms) {
  JointMoment energy;
  RestLinks links;
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
      link_three(source, links, JointMoment::kRest * static_cast<int>(energy.stencils.size()),
                 source.loads.moment(static_cast<int>(i)));
      energy.stencils.push_back({{r, r + 1, r + 2}, {m.x(), m.y(), m.z()}, joint, moment.scaling});
    }
  }
  add_term(terms, std::move(energy), std::move(links));
  return {};
}

Status add_soft_pins(const EnergySource& source, EnergyTerms& terms) {
  NodeSoftPin energy;
  RestLinks links;
  for (size_t i = 0; i < source.pose->soft_pins.size(); ++i) {
    const SoftPin& pin = source.pose->soft_pins[i];
    const Result<std::vector<int>> nodes = source.nodes(pin.at, source.place("soft_pins", i));
    if (!nodes) return nodes.error();
    for (const int node : nodes.value()) {
      const int entry = NodeSoftPin::kRest * static_cast<int>(energy.stencils.size());
      links.push_back({entry, source.load_number(source.loads.pin_stiffness(static_cast<int>(i)))});
      link_three(source, links, entry + 1,
                 pin.target ? source.loads.pin_target(static_cast<int>(i)) : source.loads.drawn_target(node));
      const Vec3 target = pin.target.value_or(source.drawn(node));
      energy.stencils.push_back({source.node_dofs(node), {pin.stiffness, target.x(), target.y(), target.z()}});
    }
  }
  add_term(terms, std::move(energy), std::move(links));
  return {};
}

}  // namespace lissom
