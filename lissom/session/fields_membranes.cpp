#include "lissom/session/field_families.h"

namespace lissom {

namespace {

template <class Of>
std::vector<double> per_stretch(const FieldSource& source, const Of& of) {
  const std::vector<Vec3> positions = node_positions(source);
  std::vector<double> values;
  for (const StructureTriangle& triangle : source.system.structure.triangles) {
    values.push_back(of(triangle_stretch(source.system.structure, triangle, positions)));
  }
  return values;
}

template <class Of>
std::vector<double> per_tension(const FieldSource& source, const Of& of) {
  std::vector<double> values;
  for (const TriangleTension& tension : triangle_tensions(source, node_positions(source)))
    values.push_back(of(tension));
  return values;
}

}  // namespace

std::vector<Vec3> node_positions(const FieldSource& source) {
  std::vector<Vec3> positions;
  for (int i = 0; i < source.system.layout.nodes(); ++i) positions.push_back(source.state.position(i));
  return positions;
}

std::vector<TriangleTension> triangle_tensions(const FieldSource& source, const std::vector<Vec3>& positions) {
  const Structure& structure = source.system.structure;
  std::vector<const MembraneMaterial*> material;
  for (const StructureMembrane& membrane : structure.membranes) {
    material.push_back(source.model.membrane_material(membrane.material));
    LISSOM_ASSERT(material.back() != nullptr);  // the model was validated before it was cut into triangles
  }
  std::vector<TriangleTension> tensions;
  for (const StructureTriangle& triangle : structure.triangles) {
    const TriangleStretch stretch = triangle_stretch(structure, triangle, positions);
    tensions.push_back(triangle_tension(*material[triangle.membrane], stretch));
  }
  return tensions;
}

std::vector<double> largest_stretch(const FieldSource& source) {
  return per_stretch(source, [](const TriangleStretch& s) { return s.largest; });
}
std::vector<double> smallest_stretch(const FieldSource& source) {
  return per_stretch(source, [](const TriangleStretch& s) { return s.smallest; });
}
std::vector<double> slack(const FieldSource& source) {
  return per_stretch(source, [](const TriangleStretch& s) { return s.smallest < 1 ? 1.0 : 0.0; });
}
std::vector<double> largest_tension(const FieldSource& source) {
  return per_tension(source, [](const TriangleTension& t) { return t.largest; });
}
std::vector<double> smallest_tension(const FieldSource& source) {
  return per_tension(source, [](const TriangleTension& t) { return t.smallest; });
}
std::vector<double> membrane_energy(const FieldSource& source) {
  return per_tension(source, [](const TriangleTension& t) { return t.energy; });
}

}  // namespace lissom
