#pragma once
/// Steps of plan_from_drawing that share data; nobody else includes this.

#include <vector>

#include "lissom/model/plan_drawing.h"

namespace lissom {

/// A stretch of a drawn line that one rod can follow: pieces of one kind, and no corners between cubics. Places on it are
/// numbers: 2.5 is the middle of the third piece.
struct Run {
  int line = 0;  ///< of the drawing
  PlanarPath path;
  bool closed = false;
  std::vector<double> stops;  ///< places that have to be points of the plan, ascending; an open run has its ends

  PathPiece::Kind kind() const { return path.front().kind; }
  double length() const { return double(path.size()); }
  Vec2 at(double place) const;
};

std::vector<Run> runs_of(const PlanDrawing& drawing, double tolerance);

/// Adds the stops where runs cross, touch, or end on each other.
void find_meetings(std::vector<Run>& runs, double tolerance);

/// Places of the points through which a spline follows the run: its own nodes if that is close enough, else as few evenly
/// spread ones as needed. `strays` (m) is how far it leaves the run.
std::vector<double> spline_places(const Run& run, double tolerance, double& strays);

}  // namespace lissom
