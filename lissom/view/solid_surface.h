#pragma once
/// The outer surface of a solid, which is all of it that can be seen.

#include <array>
#include <vector>

#include "lissom/model/structure.h"

namespace lissom {

struct SolidSurface {
  std::vector<int> nodes;                     ///< of the structure, in the order in which triangles name them first
  std::vector<std::array<int, 3>> triangles;  ///< (t x 3), into nodes, anticlockwise seen from outside
};

SolidSurface surface_of(const Structure& structure, const StructureSolid& solid);

}  // namespace lissom
