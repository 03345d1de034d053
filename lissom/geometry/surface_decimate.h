#pragma once
/// Fewer triangles for about the same surface.

#include "lissom/geometry/surface.h"

namespace lissom {

/// Collapses short edges first, to points that keep volume and boundary [Lindstrom, Turk 1998, through CGAL], until
/// `triangles` are left or no edge may be collapsed; then moves vertices along the surface to make triangles alike. Manifold surfaces.
Surface decimate(const Surface& surface, int triangles);

}  // namespace lissom
