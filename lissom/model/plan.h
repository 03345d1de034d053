#pragma once
/// The flat plan of a Kirchhoff-Plateau surface: rods drawn on pre-stretched fabric through shared control points
/// [thesis chapter 6; mathematics 6.2]. A plan is expanded into ordinary rods and one membrane before anything else
/// happens (expand_plan); the control points are the design parameters.

#include <string>
#include <vector>

#include "lissom/core/types.h"

namespace lissom {

/// A point of the plan that rods run through. Rods that share one are joined there.
struct PlanPoint {
  std::string name;
  Vec2 at = Vec2::Zero();   ///< m
  double r_n = 0, r_b = 0;  ///< m, out-of-plane and in-plane radius of the rods here
  /// Every rod is cut here and its parts hold together at the point only: no moment passes, the shape may kink.
  bool split = false;
};

enum class PlanCurve {
  kSpline,    ///< Catmull-Rom through the points, uniform parameter, one-sided quadratic end tangents
  kStraight,  ///< straight pieces
  kArc,       ///< circular arc through three points (closed: circle through them); more points: arcs in turn
};

enum class PlanRole {
  kRod,    ///< printed
  kGhost,  ///< not printed: only its control points, and the fabric edge that it may be, remain
};

struct PlanRod {
  std::string name;
  std::vector<int> points;  ///< into Plan::points, in order
  PlanCurve curve = PlanCurve::kSpline;
  PlanRole role = PlanRole::kRod;
  bool closed = false;
};

/// The fabric of a plan. Its edge is the outer loop of the rods, ghosts included, unless `outline` names rods.
struct Fabric {
  std::string material;
  Vec2 pre_stretch = Vec2(1.4, 1.4);  ///< along axes 1 and 2
  double warp_angle = 0;              ///< rad, from x to axis 1
  double edge_length = 0;             ///< m, of triangles; 0: as long as the edges of the rods
  double min_angle = 0.436;           ///< rad (25 degrees), smallest angle asked of the triangles
  double bending = 1;                 ///< multiplies the bending stiffness of the material
  std::vector<std::string> outline;   ///< rods that form the edge; empty: found
  std::vector<Vec2> holes;            ///< m, one point inside each hole, which reaches up to the rods around it
};

struct Plan {
  std::vector<PlanPoint> points;
  std::vector<PlanRod> rods;
  std::string material;     ///< of the rods
  double edge_length = 0;   ///< m, of rod edges; 0: from max_turn alone
  double max_turn = 0.175;  ///< rad (10 degrees), largest turn of a rod from edge to edge; shorter edges where needed
  Fabric fabric;
};

}  // namespace lissom
