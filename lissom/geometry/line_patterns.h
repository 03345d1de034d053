#pragma once
/// Regular patterns of lines: sheets of hexagons, squares and triangles.

#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/geometry/obj_lines.h"
#include "lissom/geometry/surface.h"

namespace lissom {

/// Line networks of one cell shape with sides of `edge` (m), centred at the origin in the x-y plane.
ObjLines hexagon_pattern(double edge, int columns, int rows);
ObjLines square_pattern(double edge, int columns, int rows);
ObjLines triangle_pattern(double edge, int columns, int rows);

enum class PatternCell { kHexagon, kSquare, kTriangle };

/// The cells of a pattern that fit wholly on a sheet: the pattern lies in the plane across the sheet's mean normal, its rows
/// along x (along y where the sheet stands across x), shifted such that most cells fit, and each point is moved along the normal
/// to the sheet. Sides of `edge`, m. kGeometry at `where` for surfaces without a mean normal and where no cell fits.
Result<ObjLines> pattern_on_sheet(const Surface& surface, PatternCell cell, double edge, const std::string& where);

}  // namespace lissom
