#include "lissom/mechanics/rest_state.h"

#include <algorithm>
#include <cmath>

namespace lissom {

namespace {

double area(const std::array<Vec2, 3>& p) {
  const Vec2 u = p[1] - p[0], v = p[2] - p[0];
  return 0.5 * (u.x() * v.y() - u.y() * v.x());
}

/// Larger of the two Cauchy tensions along the material axes of a sheet stretched by s, N/m [mathematics 3.1].
double drawn_tension(const MembraneMaterial& material, const Vec2& s) {
  const double gamma = 1 / (1 - material.poisson_ratio * material.poisson_ratio);
  const double mixed = material.poisson_ratio * std::sqrt(material.stiffness_1 * material.stiffness_2);
  const double e1 = 0.5 * (s[0] * s[0] - 1), e2 = 0.5 * (s[1] * s[1] - 1);
  return gamma * std::max((material.stiffness_1 * e1 + mixed * e2) * s[0] / s[1],
                          (material.stiffness_2 * e2 + mixed * e1) * s[1] / s[0]);
}

Status add_membranes(const Model& model, const Structure& structure, RestState& rest) {
  rest.node_area.assign(structure.nodes.size(), 0);
  rest.triangles.reserve(structure.triangles.size());
  for (const StructureMembrane& membrane : structure.membranes) {
    const MembraneMaterial* material = model.membrane_material(membrane.material);
    if (material == nullptr) {
      return Error{ErrorCode::kUnknown, "membrane " + membrane.name, "there is no fabric \"" + membrane.material + "\"",
                   "add it to membrane_materials or use one of the library"};
    }
    rest.max_tension = std::max(rest.max_tension, drawn_tension(*material, membrane.pre_stretch));
    for (int t = membrane.first_triangle; t < membrane.first_triangle + membrane.triangles; ++t) {
      const StructureTriangle& triangle = structure.triangles[t];
      TriangleRest out{{}, material->stiffness_1, material->stiffness_2, material->poisson_ratio, 0};
      for (int i = 0; i < 3; ++i) out.corner[i] = triangle.corner[i].cwiseQuotient(membrane.pre_stretch);
      out.area = area(out.corner);
      for (const int node : triangle.node) {
        rest.node_area[node] += out.area / 3;
        rest.node_mass[node] += material->area_density * out.area / 3;
      }
      rest.total_mass += material->area_density * out.area;
      rest.triangles.push_back(out);
    }
  }
  rest.hinges.reserve(structure.hinges.size());
  for (const StructureHinge& hinge : structure.hinges) {
    const StructureMembrane& membrane = structure.membranes[hinge.membrane];
    const TriangleRest &left = rest.triangles[hinge.triangle[0]], &right = rest.triangles[hinge.triangle[1]];
    const std::array<int, 3>& node = structure.triangles[hinge.triangle[0]].node;
    const size_t first = static_cast<size_t>(std::find(node.begin(), node.end(), hinge.node[0]) - node.begin());
    const Vec2 edge = left.corner[(first + 1) % 3] - left.corner[first];
    const double bend = membrane.bending * model.membrane_material(membrane.material)->bend();
    rest.hinges.push_back({bend * edge.squaredNorm() / (left.area + right.area), hinge.rest_angle});
  }
  return {};
}

}  // namespace

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
  rest.mean_edge_length =
      rest.edges.empty() ? structure.mean_edge_length : rest.mean_edge_length / static_cast<double>(rest.edges.size());

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
  if (Status status = add_membranes(model, structure, rest); !status) return status.error();
  return rest;
}

}  // namespace lissom
