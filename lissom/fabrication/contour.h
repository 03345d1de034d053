#pragma once
/// The surface of a field of rods as triangles: a lattice of cubes near the rods, each cut by the surface.

#include "lissom/core/context.h"
#include "lissom/core/result.h"
#include "lissom/fabrication/rod_field.h"
#include "lissom/geometry/surface.h"

namespace lissom {

/// Closed, and every edge has two triangles, whatever the field. Corners lie on the surface, except that none comes nearer
/// to a point of the lattice than a twenty-fifth of `cell` (m). kRange when the lattice would be too large.
Result<Surface> contour(const RodField& field, double cell, const Context& context);

}  // namespace lissom
