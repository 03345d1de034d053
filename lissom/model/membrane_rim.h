#pragma once
/// The edge of a membrane: sides of triangles that no other triangle shares, as closed lines.

#include <vector>

#include "lissom/model/structure.h"

namespace lissom {

/// A side of a triangle without a neighbour, with the triangle on its left.
struct RimEdge {
  int node0 = -1, node1 = -1;
  int triangle = -1;
  int corner = -1;  ///< of the triangle, at node0; the next corner is at node1
};

using RimLoop = std::vector<RimEdge>;

/// The longest in the drawn shape first (the outer edge of a flat membrane), the others in the order of their first
/// triangle. Empty for a closed surface.
std::vector<RimLoop> rim_loops(const Structure& structure, int membrane);

}  // namespace lissom
