#pragma once
/// Plans as SVG drawings: millimetres, with the numbers of the view box equal to them, y upwards on paper, strokes as wide
/// as the rods are in the plane, groups RODS, GHOST, FRAME and MARKS, and a ruler of 100 mm to check prints with.

#include <string>
#include <string_view>

#include "lissom/model/plan_drawing.h"

namespace lissom {

/// The lines of a drawing: path, line, polyline, polygon, rect, circle, ellipse, under all transforms. Lengths follow
/// width and viewBox, 96 pixels to the inch where these are missing. `where` names the file in errors.
Result<PlanDrawing> read_svg_drawing(std::string_view text, const std::string& where);

std::string write_svg_drawing(const PlanDrawing& drawing, const std::string& title);

}  // namespace lissom
