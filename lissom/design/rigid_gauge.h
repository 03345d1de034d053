#pragma once
/// Where a structure that nothing holds is said to be. Equilibria are laid over the drawn shape (lay_down); pinned nodes,
/// which a designer wants to stay, then bring the whole back to where they were, by the rigid motion that does it best. The
/// same to first order for responses to design parameters.

#include <vector>

#include "lissom/core/types.h"
#include "lissom/equilibrium/static_problem.h"
#include "lissom/mechanics/state.h"

namespace lissom {

/// A node that is to stay where it is said to be.
struct PinnedNode {
  int node = -1;
  Vec3 at = Vec3::Zero();  ///< m
};

/// `state`, laid down, moved as one piece so that the pinned nodes come nearest to their places; of several ways to do so,
/// as with fewer than three of them, the one that moves the structure least. As it was where something holds the structure.
State pinned_down(const StaticProblem& problem, const State& state, const std::vector<PinnedNode>& pins);

/// Takes the rigid motions out of responses (unknowns x m, global axes) at a state that `pinned_down` has returned: they
/// become those of laid and pinned down shapes. `drawn`: how the nodes of the drawn shape move along,
/// (3 per node x m). What nodes count when a shape is laid down is taken as fixed.
void pin_down_response(const StaticProblem& problem, const State& state, const std::vector<PinnedNode>& pins,
                       const SparseMatrix& drawn, MatX& response);

}  // namespace lissom
