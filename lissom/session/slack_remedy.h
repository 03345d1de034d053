#pragma once
/// A first estimate of what makes slack fabric taut without changing the shape much. Solving says how good it is.

#include <optional>

#include "lissom/mechanics/rest_state.h"

namespace lissom {

struct SlackRemedy {
  Vec2 pre_stretch = Vec2::Ones();
  double radius_factor = 1;  ///< for all radii of the rods
};

/// Stretches of one shape are proportional to the pre-stretch, so that times wanted / smallest is the least that brings
/// `smallest_stretch` to `wanted`. Bending of rods grows with the fourth power of their radii: to keep its balance with
/// the membrane, radii grow with the fourth root of the tension of the flat sheet [mathematics 8]. Nothing when the
/// fabric is taut enough, or when the flat sheet does not pull at all (no pre-stretch).
std::optional<SlackRemedy> slack_remedy(const TriangleRest& fabric, const Vec2& pre_stretch, double smallest_stretch,
                                        double wanted);

/// Mean tension, N/m, of a flat sheet that rods hold at this pre-stretch: Y / (1 - mu) (s^2 - 1) / 2 when both axes are
/// alike [mathematics 3.1].
double flat_tension(const TriangleRest& fabric, const Vec2& pre_stretch);

}  // namespace lissom
