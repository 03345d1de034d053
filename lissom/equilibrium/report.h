#pragma once
/// Fills in what people want to know about a finished solve: energies by term, reactions, worst elements, the sentence.

#include "lissom/equilibrium/equilibrium.h"
#include "lissom/equilibrium/newton_workspace.h"

namespace lissom {

void describe(const StaticProblem& problem, NewtonWorkspace& workspace, Equilibrium& result);

/// Forces and moments that held unknowns carry, exerted by the support on the structure; global axes, 0 at free ones.
VecX reactions(const StaticProblem& problem, const VecX& local_gradient);

}  // namespace lissom
