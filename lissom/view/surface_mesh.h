#pragma once
/// Triangle surfaces, closed ones of rods and open ones of membranes: for files, printing previews and other programs.

#include <array>
#include <vector>

#include "lissom/view/rod_drawing.h"

namespace lissom {

/// Triangles are counter-clockwise seen from outside. Rods that meet overlap; they are not united.
struct SurfaceMesh {
  std::vector<Vec3> vertices;                 ///< m, (vertices x 3)
  std::vector<int> source;                    ///< point of the drawing that each vertex belongs to
  std::vector<std::array<int, 3>> triangles;  ///< (triangles x 3)
  std::vector<int> first_triangle;            ///< of each rod, then of each membrane
};

/// Whether a rod can have this many sides: even, 4 to 512.
Status check_sides(int sides);

/// `sides` (as check_sides wants) around ellipses and tubes; rectangles have their four. Tubes are hollow; ends are flat.
SurfaceMesh rod_surfaces(const Drawing& drawing, int sides);

/// The same with the membranes after the rods, as they are: without thickness.
SurfaceMesh all_surfaces(const Drawing& drawing, int sides);

}  // namespace lissom
