#pragma once
/// How solids are deformed.

#include <vector>

#include "lissom/mechanics/state.h"

namespace lissom {

/// Present over rest volume of every tetrahedron; negative: it is inside out.
std::vector<double> volume_ratios(const System& system, const State& state);

}  // namespace lissom
