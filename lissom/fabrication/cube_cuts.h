#pragma once
/// How a surface passes through a cube when it is known which corners lie inside: closed loops over the cut edges.

#include <array>
#include <vector>

namespace lissom {

/// Corner c of a cube lies at x = c & 1, y = c >> 1 & 1, z = c >> 2 & 1.
struct CubeEdge {
  int from = 0, axis = 0;  ///< from this corner in the direction of this axis
};
constexpr int kCubeEdges = 12;
/// Edge 4 axis + k.
const std::array<CubeEdge, kCubeEdges>& cube_edges();

/// Triangles of one case: corners below 12 are cut edges, 12 + l is the centre of loop l.
struct CubeCuts {
  std::vector<std::vector<int>> centred;      ///< loops that need a point in their middle
  std::vector<std::array<int, 3>> triangles;  ///< anticlockwise seen from outside
};

/// Of all 256 cases; bit c of the case is set when corner c lies inside. Inside corners that face each other over a side of
/// the cube are kept apart, from both sides of it: then every segment on a side is seen by both cubes, and surfaces of
/// many cubes are closed. A diagonal of a loop never joins two edges of one side, where a diagonal of the neighbour could
/// be the same: every edge of the surface has two triangles. [after Lorensen, Cline 1987, with the tables computed]
const std::vector<CubeCuts>& cube_cuts();

}  // namespace lissom
