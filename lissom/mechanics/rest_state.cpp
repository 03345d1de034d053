#include "lissom/mechanics/rest_state.h"

#include <algorithm>
#include <cmath>

#include "lissom/mechanics/rest_formulas.h"

namespace lissom {

namespace {

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
    const double tension = drawn_tension(*material, membrane.pre_stretch);
    for (int t = membrane.first_triangle; t < membrane.first_triangle + membrane.triangles; ++t) {
      const StructureTriangle& triangle = structure.triangles[t];
      const TriangleRest out = triangle_rest<double>(
          triangle.corner, membrane.pre_stretch[0], membrane.pre_stretch[1], triangle.stiffness * material->stiffness_1,
          triangle.stiffness * material->stiffness_2, material->poisson_ratio);
      rest.max_tension = std::max(rest.max_tension, triangle.stiffness * tension);
      const double area_density = triangle.density * material->area_density;
      for (const int node : triangle.node) {
        rest.node_area[node] += out.area / 3;
        rest.node_mass[node] += area_density * out.area / 3;
      }
      rest.total_mass += area_density * out.area;
      rest.triangles.push_back(out);
    }
  }
  rest.hinges.reserve(structure.hinges.size());
  for (const StructureHinge& hinge : structure.hinges) {
    const StructureMembrane& membrane = structure.membranes[hinge.membrane];
    const TriangleRest &left = rest.triangles[hinge.triangle[0]], &right = rest.triangles[hinge.triangle[1]];
    const std::array<int, 3>& node = structure.triangles[hinge.triangle[0]].node;
    const int from = static_cast<int>(std::find(node.begin(), node.end(), hinge.node[0]) - node.begin());
    const double bend = membrane.bending * model.membrane_material(membrane.material)->bend();
    rest.hinges.push_back(hinge_rest(left, from, right, bend, multipliers(structure, hinge), hinge.rest_angle));
  }
  return {};
}

Status add_solids(const Model& model, const Structure& structure, RestState& rest) {
  rest.node_volume.assign(structure.nodes.size(), 0);
  rest.tetrahedra.reserve(structure.tetrahedra.size());
  for (const StructureTetrahedron& tetrahedron : structure.tetrahedra) {
    const StructureSolid& solid = structure.solids[tetrahedron.solid];
    const Material* material = model.material(solid.material);
    if (material == nullptr) {
      return Error{ErrorCode::kUnknown, "solid " + solid.name, "there is no material \"" + solid.material + "\"",
                   "add it to materials or use one of the library"};
    }
    std::array<Vec3, 4> corner;
    for (int i = 0; i < 4; ++i) corner[i] = structure.nodes[tetrahedron.node[i]];
    const TetrahedronRest out =
        tetrahedron_rest<double>(corner, tetrahedron.stiffness * material->youngs_modulus, material->poisson_ratio);
    const double mass = tetrahedron.density * material->density * out.volume;
    for (const int node : tetrahedron.node) {
      rest.node_volume[node] += out.volume / 4;
      rest.node_mass[node] += mass / 4;
    }
    rest.total_mass += mass;
    rest.tetrahedra.push_back(out);
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
    rest.edges.push_back(edge_rest(l, s));
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
    rest.pairs.push_back(pair_rest({pair.rest_kappa_1, pair.rest_kappa_2}, pair.rest_twist,
                                   structure.edges[pair.edge0].rest_length, structure.edges[pair.edge1].rest_length,
                                   stiffness[pair.edge0], stiffness[pair.edge1]));
  }
  for (const StructureJoint& joint : structure.joints) {
    for (const JointConnection& connection : joint.connections) {
      rest.connections.push_back(
          connection_rest(structure.edges[connection.edge].rest_length, stiffness[connection.edge]));
    }
  }
  if (Status status = add_membranes(model, structure, rest); !status) return status.error();
  if (Status status = add_solids(model, structure, rest); !status) return status.error();
  return rest;
}

}  // namespace lissom
