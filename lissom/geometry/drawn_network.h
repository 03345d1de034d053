#pragma once
/// Lines that somebody drew near a surface, as a network on it.

#include "lissom/geometry/obj_lines.h"
#include "lissom/geometry/surface_network.h"

namespace lissom {

/// Points move to the nearest place of the surface, segments become shortest paths on it, and what runs through points with
/// two segments is one line. A joint is where a line ends, or where more than two segments meet; a ring without any gets three.
/// m. kGeometry at `where` for no segment, and for points that end in the same place.
Result<SurfaceNetwork> drawn_network(const Surface& surface, const ObjLines& drawn, const std::string& where);

}  // namespace lissom
