#pragma once
/// Plans as DXF drawings (R2000, $INSUNITS 4: millimetres) with layers RODS, GHOST, FRAME and MARKS. Straight rods and
/// arcs are polylines with their width, splines are cubic splines; the names and radii of rods travel as extended data.

#include <string>
#include <string_view>

#include "lissom/model/plan_drawing.h"

namespace lissom {

/// The lines among the entities of a text DXF: LINE, LWPOLYLINE and POLYLINE with bulges, ARC, CIRCLE, ELLIPSE, SPLINE.
/// Lengths are in the unit of $INSUNITS, millimetres when that says nothing. `where` names the file in errors.
Result<PlanDrawing> read_dxf_drawing(std::string_view text, const std::string& where);

std::string write_dxf_drawing(const PlanDrawing& drawing);

}  // namespace lissom
