#pragma once
/// The line of one rod of a plan: places on it, the nearest one, lengths (as model/plan_sampling.h draws it).

#include <optional>
#include <vector>

#include "lissom/geometry/hermite_curve.h"
#include "lissom/model/plan.h"

namespace lissom {

/// A place on a rod: between point `piece` of its list and the next, at the parameter s from 0 to 1.
struct RodPlace {
  int piece = 0;
  double s = 0;
  Vec2 at = Vec2::Zero();  ///< m
  double distance = 0;     ///< m, from what was asked for
};

class RodCurve {
 public:
  /// Both outlive the curve. The rod has at least two points, an arc three.
  RodCurve(const Plan& plan, const PlanRod& rod);

  int pieces() const;
  Vec2 point(int piece, double s) const;  ///< m
  RodPlace nearest(const Vec2& to) const;
  double length(int piece) const;  ///< m
  double length() const;           ///< m
  /// m, from the start to a place.
  double length_to(const RodPlace& place) const;
  RodPlace at_length(double length) const;

 private:
  const Plan& plan_;
  const PlanRod& rod_;
  std::optional<HermiteCurve<Vec2>> spline_;
};

/// Puts a point into the list of a rod. Helping points besides keep its line: in arcs one on the same circle, in splines,
/// which turn in loops where pieces of very different lengths meet, some that let the lengths grow step by step.
void put_on_rod(Plan& plan, std::size_t rod, const RodPlace& place, int point);

/// The point of a rod at its place nearest to `at`: a new one, or one that is there already, not further away than the rod
/// is wide or than a twentieth of the piece.
struct OnRod {
  int point = 0;
  bool made = false;
};
OnRod point_on_rod(Plan& plan, std::size_t rod, const Vec2& at);

/// Radius between the points of a piece, m.
double radius_at(const Plan& plan, const PlanRod& rod, const RodPlace& place, double PlanPoint::*radius);

/// Where two rods cross away from points that they share, first along `a`.
struct RodCrossing {
  RodPlace on_a, on_b;
};
std::optional<RodCrossing> first_crossing(const Plan& plan, std::size_t a, std::size_t b);

}  // namespace lissom
