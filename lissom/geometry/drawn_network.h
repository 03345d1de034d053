#pragma once
/// Lines that somebody drew near a surface, as a network on it.

#include "lissom/geometry/obj_lines.h"
#include "lissom/geometry/surface_network.h"

namespace lissom {

/// Points move to the nearest place of the surface, segments become shortest paths on it, and what runs through points with
/// two segments is one line. A joint is where a line ends, where more than two segments meet, or where the drawing turns by more
/// than `corner` (rad; negative: everywhere); a ring without any gets three. m. kGeometry at `where` for no segment, and for
/// points that end in the same place.
Result<SurfaceNetwork> drawn_network(const Surface& surface, const ObjLines& drawn, double corner,
                                     const std::string& where);

}  // namespace lissom
