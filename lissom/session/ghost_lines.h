#pragma once
/// Where the ghost rods of a plan run in the fabric: they are not in the structure, but pictures show them dashed.

#include <vector>

#include "lissom/mechanics/state.h"
#include "lissom/mechanics/system.h"

namespace lissom {

/// Points of each ghost rod in this state (m), the first again at the end of closed ones; nothing without a plan. The
/// system was made from the model without refinement.
std::vector<std::vector<Vec3>> ghost_lines(const Model& model, const System& system, const State& state);

}  // namespace lissom
