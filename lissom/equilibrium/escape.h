#pragma once
/// Leaving a saddle point of the energy: a finite step along a direction of negative curvature.

#include "lissom/equilibrium/newton_workspace.h"
#include "lissom/equilibrium/options.h"

namespace lissom {

/// Moves `state` along + or - `direction` (global axes) by that amplitude of a few, up to turns of 0.3 rad, whose energy is
/// lowest; of two mirror images the one on the positive side. False, with the state as it was, when none is lower.
bool escape(NewtonWorkspace& workspace, StepPath path, State& state, const VecX& direction);

}  // namespace lissom
