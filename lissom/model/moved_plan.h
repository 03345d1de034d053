#pragma once
/// An expanded plan whose control points have moved, or have other radii, on the same edges and triangles.

#include "lissom/model/expand_plan.h"
#include "lissom/model/plan_map.h"

namespace lissom {

/// Control points of a plan as the maps take them.
MatX control_positions(const Plan& plan);                              ///< m, (points x 2)
VecX control_radii(const Plan& plan, double PlanPoint::*half_extent);  ///< m, (points)

/// `base` with the places, radii and fabric of `plan`, which has the same points and rods; `map` is that of `base`. An error
/// where the plan as it is now cannot be built: rods that cross, points that coincide.
Result<ExpandedPlan> moved_plan(const Model& model, const ExpandedPlan& base, const PlanMap& map);

}  // namespace lissom
