#include "lissom/mechanics/rest_state.h"

#include <algorithm>

namespace lissom {

Result<RestState> make_rest_state(const Model& model, const Structure& structure) {
  RestState rest;
  rest.edges.reserve(structure.edges.size());
  rest.node_mass.assign(structure.nodes.size(), 0);
  rest.node_length.assign(structure.nodes.size(), 0);
  std::vector<SectionStiffness> stiffness;
  stiffness.reserve(structure.edges.size());
  for (const StructureEdge& edge : structure.edges) {
    const StructureRod& rod = structure.rods[edge.rod];
    const Material* material = model.material(rod.material);
    if (material == nullptr) {
      return Error{ErrorCode::kUnknown, "rod " + rod.name, "there is no material \"" + rod.material + "\"",
                   "add it to materials or use one of the library"};
    }
    const SectionStiffness s = section_stiffness(edge.section, *material, model.torsion);
    stiffness.push_back(s);
    const double l = edge.rest_length;
    rest.edges.push_back({l, s.stretch, s.mass * l, s.roll_inertia * l, (s.bend_b + s.bend_n) / s.stretch});
    for (const int node : {edge.node0, edge.node1}) {
      rest.node_mass[node] += s.mass * l / 2;
      rest.node_length[node] += l / 2;
    }
    rest.total_mass += s.mass * l;
    rest.mean_edge_length += l;
    rest.max_stretch = std::max(rest.max_stretch, s.stretch);
  }
  if (!rest.edges.empty()) rest.mean_edge_length /= static_cast<double>(rest.edges.size());

  rest.pairs.reserve(structure.pairs.size());
  for (const StructurePair& pair : structure.pairs) {
    // Length-weighted means at a vertex where the section changes [mathematics 1.4].
    const double l0 = structure.edges[pair.edge0].rest_length, l1 = structure.edges[pair.edge1].rest_length;
    const SectionStiffness &s0 = stiffness[pair.edge0], &s1 = stiffness[pair.edge1];
    const auto mean = [&](double a, double b) { return (l0 * a + l1 * b) / (l0 + l1); };
    rest.pairs.push_back({pair.rest_kappa_1, pair.rest_kappa_2, pair.rest_twist, mean(s0.bend_b, s1.bend_b),
                          mean(s0.bend_n, s1.bend_n), mean(s0.twist, s1.twist), (l0 + l1) / 2});
  }
  for (const StructureJoint& joint : structure.joints) {
    for (const JointConnection& connection : joint.connections) {
      const SectionStiffness& s = stiffness[connection.edge];
      const double half = structure.edges[connection.edge].rest_length / 2;
      rest.connections.push_back({0, 0, 0, s.bend_b, s.bend_n, s.twist, half});
    }
  }
  return rest;
}

}  // namespace lissom
