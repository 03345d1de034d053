#pragma once
/// The network of lines between the cells of a surface.

#include "lissom/geometry/surface_cells.h"
#include "lissom/geometry/surface_network.h"

namespace lissom {

/// A joint where three cells meet or two meet at a boundary, a line between every two cells that touch, and lines along the
/// boundaries. kGeometry at `where` for a boundary that only one cell touches.
Result<SurfaceNetwork> cell_network(const Surface& surface, const SurfaceCells& cells, const std::string& where);

}  // namespace lissom
