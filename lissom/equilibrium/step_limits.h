#pragma once
/// How far a step may go before frames and linearisations lose their meaning.

#include "lissom/equilibrium/options.h"
#include "lissom/mechanics/state.h"

namespace lissom {

/// Largest change of a roll or of a component of a joint rotation, rad.
double largest_roll(const System& system, const VecX& dq);

/// Largest change of the axial strain of an edge, to first order.
double largest_strain(const System& system, const State& state, const VecX& dq);

/// Fraction of a step, at most 1, at which the first limit on turns is met.
double step_reach(const System& system, const State& state, const VecX& dq, const SolveOptions& options);

}  // namespace lissom
