#pragma once
/// How far a step may go before frames and linearisations lose their meaning.

#include "lissom/equilibrium/options.h"
#include "lissom/mechanics/state.h"

namespace lissom {

/// Largest change of a roll or of a component of a joint rotation, rad.
double largest_roll(const System& system, const VecX& dq);

/// Largest change of the axial strain of an edge, to first order.
double largest_strain(const System& system, const State& state, const VecX& dq);

/// Largest turn (rad) of a side, and largest change of a side over its length, of shells that resist bending and of solids,
/// to first order. Zero where there are rods: by these steps are limited already, and fabric follows them.
struct SideChange {
  double turn = 0, strain = 0;
};
SideChange largest_side_change(const System& system, const State& state, const VecX& dq);

/// Largest turn of whatever limits steps, rad: edges of rods, or sides where there are none.
double step_turn(const System& system, const State& state, const VecX& dq);

/// Fraction of a step, at most 1, at which the first limit on turns is met.
double step_reach(const System& system, const State& state, const VecX& dq, const SolveOptions& options);

}  // namespace lissom
