#pragma once
/// Boundaries of a surface, and the lines of a network along them.

#include <array>
#include <vector>

#include "lissom/geometry/surface_network.h"

namespace lissom {

/// An edge of a triangle without a neighbour: from its corner `edge` to the next one.
struct BoundaryEdge {
  int triangle = -1, edge = -1;
};
using BoundaryLoop = std::vector<BoundaryEdge>;  ///< the surface on the left

/// Boundaries of a manifold surface, each from its lowest triangle on.
std::vector<BoundaryLoop> boundary_loops(const Surface& surface);

/// Place on the boundary nearest to a point.
SurfacePlace nearest_on_boundary(const Surface& surface, const std::vector<BoundaryLoop>& loops, const Vec3& x);

/// Lines along all boundaries, between the joints of kind kBoundary that the network has there and new ones where a boundary
/// turns by more than `corner` (rad). kGeometry at `where` for a boundary without any joint.
Status add_boundary_lines(const Surface& surface, double corner, SurfaceNetwork& network, const std::string& where);

}  // namespace lissom
