#pragma once
/// Starts that no rod can take: edges stretched to three times their length or squeezed to a third of it, rods folded back between
/// two edges or turned against themselves by a third of a turn. The discrete curvature 2 tan(angle / 2) has its pole at a fold;
/// beside it, with half a turn of twist, lie valleys that have no counterpart in the rod and from which descent does not
/// return. Noise of this kind carries nothing that is worth keeping, so it is smoothed away before a solve begins.

#include "lissom/equilibrium/static_problem.h"

namespace lissom {

bool is_crumpled(const System& system, const State& state);

/// The drawn shape moved by the displacements of `state`, smoothed just enough (a diffusion along the rods) that it is not
/// crumpled; held unknowns stay where they are in `state`. Frames are those of the drawn shape, carried along.
State smoothed_start(const StaticProblem& problem, const State& state);

}  // namespace lissom
