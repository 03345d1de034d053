#pragma once
/// Shares of a mode's kinetic energy by direction and kind. Part of natural_modes.cpp.

#include "lissom/motion/natural_modes.h"

namespace lissom {

/// Fills the shares of a mode from its shape.
void measure_shares(const System& system, const State& state, RollInertia roll_inertia, NaturalMode& mode);

/// The kinetic energy that belongs to a filter, as a symmetric bilinear form of two shapes. With an axis: motion along it
/// (across the rods for kBending, along them for kAxial).
double filter_product(const System& system, const State& state, RollInertia roll_inertia, const ModeFilter& filter,
                      const VecX& u, const VecX& v);

}  // namespace lissom
