#pragma once
/// Exact derivative of the gradient by the rest numbers of a structure: the mixed block of all energies, assembled.

#include "lissom/mechanics/potential.h"

namespace lissom {

/// d gradient / d rest numbers at the anchor `state`, (unknowns x numbers), rows in the local axes of the potential.
/// `numbers`: RestNumbers::size of the structure, or that and LoadNumbers::size of the pose; others are left out.
SparseMatrix gradient_by_rest(const Potential& potential, const State& state, int numbers);

}  // namespace lissom
