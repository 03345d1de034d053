#pragma once
/// Regular triangulations of simple planar shapes. Triangles are anticlockwise.

#include <array>
#include <vector>

#include "lissom/core/types.h"

namespace lissom {

struct PlanarTriangles {
  std::vector<Vec2> points;                   ///< (n x 2)
  std::vector<std::array<int, 3>> triangles;  ///< (t x 3)
};

/// cells_x by cells_y rectangles, each cut along a diagonal whose direction alternates like a chessboard.
PlanarTriangles grid_triangles(const Vec2& corner, const Vec2& size, int cells_x, int cells_y);

/// `rings` of points about `centre`, the outermost of `sectors` points, the first of each ring in direction x. With an
/// inner radius every ring has that many; without one the number falls to the centre with the radius.
PlanarTriangles disc_triangles(const Vec2& centre, double inner_radius, double radius, int rings, int sectors);

/// Rows of equilateral triangles of side `edge`; every other line of points is shifted by half an edge.
PlanarTriangles equilateral_triangles(const Vec2& corner, double edge, int columns, int rows);

}  // namespace lissom
