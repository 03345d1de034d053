#pragma once
/// Maps of meshes: one multiplier of a material number for each triangle or tetrahedron, as painted by region or texture.

#include <cstddef>
#include <string>
#include <vector>

#include "lissom/core/result.h"

namespace lissom {

/// Multiplier of one element; 1 where nothing is painted.
inline double multiplier(const std::vector<double>& map, std::size_t element) { return map.empty() ? 1 : map[element]; }

/// What elements are called: "triangle" and "triangles".
struct ElementWords {
  const char* one;
  const char* many;
};
inline constexpr ElementWords kTriangleWords{"triangle", "triangles"};
inline constexpr ElementWords kTetrahedronWords{"tetrahedron", "tetrahedra"};

enum class ZeroMultiplier { kRefused, kAllowed };

/// Refuses a map that has not one finite positive (or zero, where allowed) number for each of `elements` elements;
/// `where`: place of the map.
Status check_element_map(const std::vector<double>& map, std::size_t elements, const ElementWords& element,
                         ZeroMultiplier zero, const std::string& where);

/// Both maps of a mesh at `where`, "stiffness" (positive) and "density" (zero allowed).
Status check_element_maps(const std::vector<double>& stiffness, const std::vector<double>& density,
                          std::size_t elements, const ElementWords& element, const std::string& where);

}  // namespace lissom
