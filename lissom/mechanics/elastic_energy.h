#pragma once
/// Elastic energy of a potential, without the loads and penalties of its pose, as a function of unknowns and rest numbers.

#include "lissom/mechanics/potential.h"

namespace lissom {

/// J.
double elastic_energy(const Potential& potential, const State& state);

/// dV/dq over all unknowns, global axes, and dV/d rest numbers, of the energy anchored at `state`. Vectors of the sizes of
/// the unknowns and of RestNumbers are overwritten.
void elastic_gradient(const Potential& potential, const State& state, VecX& by_q, VecX& by_numbers);

/// Adds `factor` times the change of both along (dq, dn).
void add_elastic_curvature(const Potential& potential, const State& state, double factor, const VecX& dq,
                           const VecX& dn, VecX& by_q, VecX& by_numbers);

}  // namespace lissom
