#pragma once
/// A shape in a few numbers: how large it is, and how its fabric is doing.

#include "lissom/mechanics/state.h"
#include "lissom/mechanics/system.h"

namespace lissom {

struct Totals {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  ///< m, bounding box of all nodes
  double height = 0;                             ///< m, of that box along z
  // Of all membranes.
  double area = 0, rest_area = 0;  ///< m^2, now and unstretched
  double slack_area = 0;           ///< m^2, now, of triangles whose smallest stretch is below 1
  double smallest_stretch = 0;     ///< 0 without membranes
};

/// `stretch_share`: part of the pre-stretch that is there.
Totals totals(const System& system, const State& state, double stretch_share);

}  // namespace lissom
