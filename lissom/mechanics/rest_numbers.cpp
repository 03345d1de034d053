#include "lissom/mechanics/rest_numbers.h"

namespace lissom {

VecX rest_input_values(const Model& model, const System& system) {
  const Structure& structure = system.structure;
  const RestInputs layout(structure);
  VecX inputs(layout.size());
  for (int i = 0; i < system.layout.nodes(); ++i) inputs.segment<3>(layout.position(i)) = structure.nodes[i];
  for (int e = 0; e < system.edge_count(); ++e) {
    inputs[layout.extent_n(e)] = structure.edges[e].section.r_n;
    inputs[layout.extent_b(e)] = structure.edges[e].section.r_b;
  }
  for (int r = 0; r < static_cast<int>(structure.rods.size()); ++r) {
    inputs[layout.youngs_modulus(r)] = model.material(structure.rods[r].material)->youngs_modulus;
    inputs[layout.length_factor(r)] = structure.rods[r].length_factor;
    inputs.segment<3>(layout.natural_rate(r, 0)) = structure.rods[r].natural_rates.value_or(Vec3::Zero());
  }
  for (int m = 0; m < static_cast<int>(structure.membranes.size()); ++m) {
    const MembraneMaterial& material = *model.membrane_material(structure.membranes[m].material);
    for (int axis = 0; axis < 2; ++axis) {
      inputs[layout.pre_stretch(m, axis)] = structure.membranes[m].pre_stretch[axis];
    }
    inputs[layout.sheet_stiffness(m, 0)] = material.stiffness_1;
    inputs[layout.sheet_stiffness(m, 1)] = material.stiffness_2;
    inputs[layout.sheet_poisson(m)] = material.poisson_ratio;
    inputs[layout.thickness(m)] = material.thickness;
  }
  for (int s = 0; s < static_cast<int>(structure.solids.size()); ++s) {
    inputs[layout.solid_modulus(s)] = model.material(structure.solids[s].material)->youngs_modulus;
  }
  return inputs;
}

VecX rest_number_values(const System& system) {
  const RestNumbers layout(system.structure);
  const RestState& rest = system.rest;
  VecX numbers = VecX::Zero(layout.size());
  for (int e = 0; e < system.edge_count(); ++e) {
    numbers[layout.edge(e, kEdgeLength)] = rest.edges[e].length;
    numbers[layout.edge(e, kEdgeStretch)] = rest.edges[e].stretch;
    numbers[layout.edge(e, kEdgeMass)] = rest.edges[e].mass;
  }
  for (int p = 0; p < static_cast<int>(rest.pairs.size()); ++p) write_pair(rest.pairs[p], &numbers[layout.pair(p, 0)]);
  for (int k = 0; k < static_cast<int>(rest.connections.size()); ++k) {
    write_pair(rest.connections[k], &numbers[layout.connection(k, 0)]);
  }
  for (int t = 0; t < static_cast<int>(rest.triangles.size()); ++t) {
    const TriangleRest& own = rest.triangles[t];
    for (int i = 0; i < 3; ++i) {
      numbers.segment<2>(layout.triangle(t, kCorner + 2 * i)) = own.corner[i];
      numbers[layout.triangle(t, kSide + i)] = (own.corner[(i + 1) % 3] - own.corner[i]).norm();
    }
    numbers[layout.triangle(t, kSheetStiffness1)] = own.stiffness_1;
    numbers[layout.triangle(t, kSheetStiffness2)] = own.stiffness_2;
    numbers[layout.triangle(t, kSheetPoisson)] = own.poisson_ratio;
    numbers[layout.triangle(t, kTriangleArea)] = own.area;
  }
  for (int h = 0; h < static_cast<int>(rest.hinges.size()); ++h) {
    numbers[layout.hinge(h, kHingeStiffness)] = rest.hinges[h].stiffness;
    numbers[layout.hinge(h, kHingeAngle)] = rest.hinges[h].angle;
  }
  for (int t = 0; t < static_cast<int>(rest.tetrahedra.size()); ++t) {
    write_tetrahedron(rest.tetrahedra[t], &numbers[layout.tetrahedron(t, 0)]);
  }
  return numbers;
}

}  // namespace lissom
