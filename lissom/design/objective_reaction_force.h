#pragma once
/// What supports carry.

#include <memory>
#include <vector>

#include "lissom/design/objective.h"

namespace lissom {

/// One component, N, for each of `axes` (any length, made unit; (1,0,0), (0,1,0) and (0,0,1) for all of it): force of the
/// supports on these nodes together. Only directions in which the pose holds a node count; nodes that it does not hold, and
/// what was held because nothing resists it, carry nothing. Rigid motions change it, as they change the supports.
std::shared_ptr<const Objective> make_reaction_force(std::vector<int> nodes, std::vector<Vec3> axes);

}  // namespace lissom
