#pragma once
/// Between plans and drawings (SVG, DXF): lines with widths on named layers. Lines that are drawn as splines, arcs or
/// straight pieces become rods of that kind; ends that meet and lines that cross share a point.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/geometry/planar_path.h"
#include "lissom/model/plan.h"

namespace lissom {

/// Layers of a drawing, by these names whatever the case. A line on no such layer is a rod.
inline constexpr std::string_view kRodLayer = "RODS", kGhostLayer = "GHOST", kFrameLayer = "FRAME",
                                  kMarkLayer = "MARKS";

struct DrawnLine {
  std::string name;
  PlanRole role = PlanRole::kRod;
  PlanarPath path;
  bool closed = false;
  std::optional<double> r_n, r_b;  ///< m, where the drawing says them
};

struct PlanDrawing {
  std::vector<DrawnLine> lines;
  int left_out = 0;  ///< lines on the layers of the frame and of marks
};

struct DrawingOptions {
  double tolerance = 5e-5;            ///< m: points nearer than this are one
  double straying = 2e-4;             ///< m: how far splines may stray from what is drawn
  double r_n = 0.5e-3, r_b = 0.5e-3;  ///< m, of lines that the drawing gives no width
  std::string material = "PLA", fabric = "elastane-cotton knit";
};

/// Box around the lines of a drawing and of the frame that is drawn around them, m.
struct DrawingFrame {
  Vec2 low, high;              ///< of the lines
  Vec2 frame_low, frame_high;  ///< 10 mm further out
};
DrawingFrame frame_of(const PlanDrawing& drawing);

/// The role of a layer; empty when its lines are left out.
std::optional<PlanRole> role_of_layer(std::string_view layer);

/// Refuses a drawing without lines. Notes say what was left out or could not be followed closely.
Result<Plan> plan_from_drawing(const PlanDrawing& drawing, const DrawingOptions& options, const std::string& where,
                               std::vector<std::string>& notes);

/// Every rod as a line, exactly; its radii are the means of those at its points.
PlanDrawing drawing_of_plan(const Plan& plan);

}  // namespace lissom
