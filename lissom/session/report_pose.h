#pragma once
/// The shapes of one pose for the report of an inverse design.

#include <span>

#include "lissom/mechanics/state.h"
#include "lissom/mechanics/system.h"
#include "lissom/session/design_report.h"
#include "lissom/view/camera.h"

namespace lissom {

/// Name of the field on `after`: distance of each node from its target, m; NaN without a target.
inline constexpr const char* kDeviation = "deviation";

/// `wanted` (m, one per node of the structure) has numbers that are not finite where a node has no target. `before` and
/// `after` are states of the systems of the first and the last design, which have the same rods and nodes.
DesignReport::Pose report_pose(const std::string& name, const System& start, const State& before, const System& found,
                               const State& after, std::span<const Vec3> wanted);

/// From where the deviations before are seen best, among directions from which shapes are easy to read.
Viewpoint view_of_deviations(const DesignReport::Pose& pose);

}  // namespace lissom
