#pragma once
/// What the ParaView exporters share: names of arrays and numbers derived from the sections.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "lissom/view/rod_drawing.h"

namespace lissom {

/// "axial force (N)".
inline std::string array_name(const Field& field) {
  return field.unit.empty() ? field.name : field.name + " (" + field.unit + ")";
}

/// A value of every edge, over all rods.
template <class Value>
std::vector<double> per_edge(const Drawing& drawing, const Value& value) {
  std::vector<double> values;
  for (const RodStrip& rod : drawing.rods) {
    for (int e = 0; e < rod.edge_count(); ++e) values.push_back(value(rod, e));
  }
  return values;
}

/// Radius (m) of the round section of the same area of every edge.
inline std::vector<double> equal_area_radius(const Drawing& drawing) {
  return per_edge(drawing, [](const RodStrip& rod, int e) {
    const double ellipse = std::sqrt(rod.r_n[e] * rod.r_b[e]);
    return rod.shape == SectionShape::kRectangle ? 2 * std::numbers::inv_sqrtpi * ellipse : ellipse;
  });
}

inline std::vector<double> half_extent_n(const Drawing& drawing) {
  return per_edge(drawing, [](const RodStrip& rod, int e) { return rod.r_n[e]; });
}

inline std::vector<double> half_extent_b(const Drawing& drawing) {
  return per_edge(drawing, [](const RodStrip& rod, int e) { return rod.r_b[e]; });
}

}  // namespace lissom
