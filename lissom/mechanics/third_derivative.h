#pragma once
/// Exact third derivatives of the potential energy along two directions, as second-order products of inverse design need them
/// [mathematics 5.2].

#include "lissom/mechanics/potential.h"

namespace lissom {

/// With V(q, n) the energy anchored at `state`, n the numbers that the rest quantities hang on (RestLink), g = dV/dq:
///   by_q       = d/de (d2V/dq dq) lambda,
///   by_numbers = d/de (d2V/dn dq) lambda   at (q + e dq, n + e dn), e = 0.
/// lambda, dq, by_q: all unknowns, in global axes, whatever the local axes of the potential. dn, by_numbers: as many numbers
/// as are wanted; those beyond stay as they are. The same bytes for any number of threads.
void third_derivative(const Potential& potential, const State& state, const VecX& lambda, const VecX& dq,
                      const VecX& dn, VecX& by_q, VecX& by_numbers, ThreadPool* threads = nullptr);

}  // namespace lissom
