#include "lissom/session/field_families.h"

namespace lissom {

namespace {

template <class Item, class Of>
std::vector<double> each(const std::vector<Item>& items, const Of& of) {
  std::vector<double> values;
  for (const Item& item : items) values.push_back(of(item));
  return values;
}

}  // namespace

std::vector<Vec3> node_positions(const FieldSource& source) {
  std::vector<Vec3> positions;
  for (int i = 0; i < source.system.layout.nodes(); ++i) positions.push_back(source.state.position(i));
  return positions;
}

std::vector<TriangleStretch> triangle_stretches(const FieldSource& source) {
  return triangle_stretches(source.system, source.state, source.stretch_share);
}

std::vector<TriangleTension> triangle_tensions(const FieldSource& source) {
  const std::vector<TriangleStretch> stretches = triangle_stretches(source);
  std::vector<TriangleTension> tensions;
  for (size_t t = 0; t < stretches.size(); ++t) {
    tensions.push_back(triangle_tension(source.system.rest.triangles[t], stretches[t]));
  }
  return tensions;
}

std::vector<double> largest_stretch(const FieldSource& source) {
  return each(triangle_stretches(source), [](const TriangleStretch& s) { return s.largest; });
}
std::vector<double> smallest_stretch(const FieldSource& source) {
  return each(triangle_stretches(source), [](const TriangleStretch& s) { return s.smallest; });
}
std::vector<double> slack(const FieldSource& source) {
  return each(triangle_stretches(source), [](const TriangleStretch& s) { return s.smallest < 1 ? 1.0 : 0.0; });
}
std::vector<double> largest_tension(const FieldSource& source) {
  return each(triangle_tensions(source), [](const TriangleTension& t) { return t.largest; });
}
std::vector<double> smallest_tension(const FieldSource& source) {
  return each(triangle_tensions(source), [](const TriangleTension& t) { return t.smallest; });
}
std::vector<double> membrane_energy_density(const FieldSource& source) {
  return each(triangle_tensions(source), [](const TriangleTension& t) { return t.energy; });
}

}  // namespace lissom
