#pragma once
/// B-splines of the plane as Bezier pieces.

#include <vector>

#include "lissom/geometry/planar_path.h"

namespace lissom {

struct BSpline {
  int degree = 3;
  std::vector<double> knots;    ///< ascending, points + degree + 1 of them
  std::vector<Vec2> points;     ///< control points
  std::vector<double> weights;  ///< of a rational spline; empty: all the same
};

/// Straight pieces for degree 1, exact cubics for degrees 2 and 3 without weights; else eight cubics per span of knots
/// that agree with the curve and its direction at their ends (2e-5 of the radius off on a quarter of a circle). Empty when the numbers do not make up a spline.
PlanarPath bezier_pieces(const BSpline& spline);

}  // namespace lissom
