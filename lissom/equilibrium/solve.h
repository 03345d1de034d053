#pragma once
/// Static equilibrium of a pose.

#include "lissom/core/context.h"
#include "lissom/equilibrium/equilibrium.h"
#include "lissom/equilibrium/options.h"
#include "lissom/equilibrium/static_problem.h"

namespace lissom {

/// Brings `start` to `load_factor` and into equilibrium. Never throws, never returns a state that is not finite.
Equilibrium solve(const StaticProblem& problem, const State& start, double load_factor, const SolveOptions& options,
                  const Context& context = {});

}  // namespace lissom
