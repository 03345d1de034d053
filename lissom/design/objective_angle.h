#pragma once
/// Angles between directions.

#include <array>
#include <memory>
#include <optional>

#include "lissom/design/objective.h"

namespace lissom {

/// Angle, rad, from the direction of nodes[0] -> nodes[1] to that of nodes[2] -> nodes[3]; nodes may repeat. Without an axis
/// it lies in [0, pi], and where the directions are parallel it has a kink, at which its derivatives are taken as 0. About an
/// axis (any length) it is the signed angle, in (-pi, pi], of what is across the axis, which is smooth through 0; for targets
/// near pi swap the nodes of one direction.
std::shared_ptr<const Objective> make_angle(const std::array<int, 4>& nodes, const std::optional<Vec3>& axis = {});

}  // namespace lissom
