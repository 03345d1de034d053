#include <algorithm>
#include <iterator>
#include <utility>

#include "lissom/mechanics/corotational_joints.h"
#include "lissom/mechanics/energies.h"
#include "lissom/mechanics/energy_builders.h"
#include "lissom/mechanics/joint_corotational.h"
#include "lissom/mechanics/joint_explicit.h"
#include "lissom/mechanics/membrane_bend.h"
#include "lissom/mechanics/membrane_stretch.h"
#include "lissom/mechanics/rod_bend_twist.h"
#include "lissom/mechanics/rod_stretch.h"
#include "lissom/mechanics/solid_stretch.h"

namespace lissom {

bool is_elastic(std::string_view name) {
  constexpr std::string_view kElastic[] = {RodStretch::kName,           RodBendTwist::kName,    JointExplicit::kName,
                                           JointCorotational<2>::kName, MembraneStretch::kName, MembraneBend::kName,
                                           SolidStretch::kName};
  return std::find(std::begin(kElastic), std::end(kElastic), name) != std::end(kElastic);
}

Status add_rod_stretch(const EnergySource& source, EnergyTerms& terms) {
  RodStretch energy;
  RestLinks links;
  for (int e = 0; e < source.system.edge_count(); ++e) {
    const StructureEdge& edge = source.system.structure.edges[e];
    const int a = 3 * edge.node0, b = 3 * edge.node1;
    const EdgeRest& rest = source.system.rest.edges[e];
    energy.stencils.push_back({{a, a + 1, a + 2, b, b + 1, b + 2}, {rest.length, rest.stretch}, e});
    links.push_back({2 * e, source.numbers.edge(e, kEdgeLength)});
    links.push_back({2 * e + 1, source.numbers.edge(e, kEdgeStretch)});
  }
  add_term(terms, std::move(energy), std::move(links));
  return {};
}

Status add_rod_bend_twist(const EnergySource& source, EnergyTerms& terms) {
  const Structure& structure = source.system.structure;
  RodBendTwist energy;
  RestLinks links;
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
    for (int i = 0; i < kPairRestCount; ++i) links.push_back({kPairRestCount * p + i, source.numbers.pair(p, i)});
  }
  add_term(terms, std::move(energy), std::move(links));
  return {};
}

Status add_explicit_joints(const EnergySource& source, EnergyTerms& terms) {
  const System& system = source.system;
  JointExplicit energy;
  RestLinks links;
  for (int k = 0; k < static_cast<int>(system.connections.size()); ++k) {
    const Connection& c = system.connections[k];
    const int r = system.layout.rotation(c.joint);
    if (r < 0) continue;
    const StructureEdge& edge = system.structure.edges[c.edge];
    const int a = 3 * edge.node0, b = 3 * edge.node1;
    const int first = kConnectionRestCount * static_cast<int>(energy.stencils.size());
    for (int i = 0; i < kConnectionRestCount; ++i) links.push_back({first + i, source.numbers.connection(k, i)});
    energy.stencils.push_back({{a, a + 1, a + 2, b, b + 1, b + 2, system.layout.roll(c.edge), r, r + 1, r + 2},
                               connection_rest_values(system.rest.connections[k]),
                               k,
                               c.edge,
                               c.joint,
                               c.direction,
                               c.rest});
  }
  add_term(terms, std::move(energy), std::move(links));
  return {};
}

Status add_corotational_joints(const EnergySource& source, EnergyTerms& terms) {
  for (int j = 0; j < source.system.joint_count(); ++j) {
    const int edges = source.system.first_connection[j + 1] - source.system.first_connection[j];
    if (source.system.layout.rotation(j) < 0 && (edges < 2 || edges > kMaxCorotationalEdges)) {
      return Error{ErrorCode::kUnsupported, "joint at node " + std::to_string(source.system.structure.joints[j].node),
                   std::to_string(edges) + " rod ends meet in a corotational joint; 2 to 8 can",
                   "make this joint explicit"};
    }
  }
  append_corotational_joints(source, terms);
  return {};
}

Status add_membrane_stretch(const EnergySource& source, EnergyTerms& terms) {
  const Structure& structure = source.system.structure;
  MembraneStretch energy;
  RestLinks links;
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
    for (int i = 0; i < MembraneStretch::kRest; ++i) {
      links.push_back(
          {MembraneStretch::kRest * static_cast<int>(t) + i, source.numbers.triangle(static_cast<int>(t), i)});
    }
    if (proportional) stencil.pre_stretch = structure.membranes[triangle.membrane].pre_stretch;
    energy.stencils.push_back(stencil);
  }
  energy.scaling = proportional ? Scaling::kProportional : Scaling::kConstant;
  add_term(terms, std::move(energy), std::move(links));
  return {};
}

Status add_membrane_bend(const EnergySource& source, EnergyTerms& terms) {
  const Structure& structure = source.system.structure;
  MembraneBend energy;
  RestLinks links;
  for (size_t h = 0; h < structure.hinges.size(); ++h) {
    const HingeRest& rest = source.system.rest.hinges[h];
    if (rest.stiffness == 0) continue;
    MembraneBend::Stencil stencil{{}, {rest.stiffness, rest.angle}};
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 3; ++k) stencil.dofs[3 * i + k] = 3 * structure.hinges[h].node[i] + k;
    }
    const int first = MembraneBend::kRest * static_cast<int>(energy.stencils.size());
    links.push_back({first, source.numbers.hinge(static_cast<int>(h), kHingeStiffness)});
    links.push_back({first + 1, source.numbers.hinge(static_cast<int>(h), kHingeAngle)});
    energy.stencils.push_back(stencil);
  }
  add_term(terms, std::move(energy), std::move(links));
  return {};
}

Status add_solid_stretch(const EnergySource& source, EnergyTerms& terms) {
  const Structure& structure = source.system.structure;
  SolidStretch energy;
  RestLinks links;
  for (int t = 0; t < static_cast<int>(structure.tetrahedra.size()); ++t) {
    SolidStretch::Stencil stencil;
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 3; ++k) stencil.dofs[3 * i + k] = 3 * structure.tetrahedra[t].node[i] + k;
    }
    std::array<double, kTetrahedronNumbers> rest;
    write_tetrahedron(source.system.rest.tetrahedra[t], rest.data());
    for (int i = 0; i < SolidStretch::kRest; ++i) {
      stencil.rest[i] = rest[i];
      links.push_back({SolidStretch::kRest * t + i, source.numbers.tetrahedron(t, i)});
    }
    energy.stencils.push_back(stencil);
  }
  add_term(terms, std::move(energy), std::move(links));
  return {};
}

}  // namespace lissom
