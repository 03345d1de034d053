#pragma once
/// Points and tangents along polylines, splines, arcs and helices [mathematics 6.1, 6.2].

#include <span>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/core/types.h"

namespace lissom {

/// A curve cut into edges. Open: edges + 1 points. Closed: as many points as edges, the last edge returns to point 0.
struct CurveSamples {
  std::vector<Vec3> points;    ///< m, (n x 3)
  std::vector<Vec3> tangents;  ///< unit, of the smooth curve at the points (n x 3); empty for polylines
  bool closed = false;

  int edges() const { return static_cast<int>(points.size()) - (closed ? 0 : 1); }
};

/// What decides how finely a curve is cut.
struct CurveMeasure {
  double length = 0;      ///< m
  double turning = 0;     ///< rad, total turning angle of the smooth pieces at the density of the most curved one
  int minimum_edges = 1;  ///< one per piece of a polyline, 3 when closed
};

/// A circular arc (rise 0) or helix: `start` turned about the axis by `angle` while rising by `rise` along it.
struct TurnedPoint {
  Vec3 centre = Vec3::Zero(), start = Vec3::Zero(), axis = Vec3::UnitZ();  ///< m, m, any length
  double angle = 0;                                                        ///< rad
  double rise = 0;                                                         ///< m in all
  bool closed = false;
};

/// All of these refuse (kGeometry or kRange, at `where`) numbers that are not finite, too few points, consecutive points
/// that coincide, a zero axis, a start on the axis, an angle of zero, and fewer edges than the curve needs.
Result<CurveMeasure> measure_polyline(std::span<const Vec3> points, bool closed, const std::string& where);
Result<CurveMeasure> measure_spline(std::span<const Vec3> points, bool closed, const std::string& where);
Result<CurveMeasure> measure_turn(const TurnedPoint& turn, const std::string& where);

/// Every point becomes a node; edges go to the pieces so that the longest edge is as short as possible.
Result<CurveSamples> sample_polyline(std::span<const Vec3> points, bool closed, int edges, const std::string& where);

/// C1 Hermite curve with central-difference tangents and one-sided quadratic end tangents; equidistant parameters.
Result<CurveSamples> sample_spline(std::span<const Vec3> points, bool closed, int edges, const std::string& where);

Result<CurveSamples> sample_turn(const TurnedPoint& turn, int edges, const std::string& where);

}  // namespace lissom
