#pragma once
/// What the ParaView exporters share: names of arrays and numbers derived from the sections.

#include <cmath>
#include <cstdint>
#include <limits>
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

/// Fills up with NaN, or -1, to one value per cell or point of rods and membranes together.
inline std::vector<double> padded(std::vector<double> values, size_t count) {
  values.resize(count, std::numeric_limits<double>::quiet_NaN());
  return values;
}
inline std::vector<int64_t> padded(std::vector<int64_t> values, size_t count) {
  values.resize(count, -1);
  return values;
}

/// Number of the membrane of every point or triangle of the drawing, after `before` that are not of a membrane.
template <class Items>
std::vector<int64_t> membrane_numbers(const Drawing& drawing, size_t before, const Items& items) {
  std::vector<int64_t> numbers(before, -1);
  for (size_t m = 0; m < drawing.membranes.size(); ++m) {
    numbers.insert(numbers.end(), (drawing.membranes[m].*items).size(), static_cast<int64_t>(m));
  }
  return numbers;
}

}  // namespace lissom
