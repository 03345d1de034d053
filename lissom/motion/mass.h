#pragma once
/// Lumped masses of the unknowns [mathematics 1.4, erratum E7].
///
/// Half of the mass of an edge sits in each of its nodes, in all directions alike; an edge has the polar moment of inertia
/// of its section about its centreline. Rotary inertia about the other two axes is left out (for bending at the n-th mode
/// of a slender rod it matters by (n pi r / 2 L)^2), and joint rotations have no mass.

#include "lissom/mechanics/system.h"

namespace lissom {

enum class RollInertia {
  kLumped,  ///< rho A l (r_n^2 + r_b^2) / 4 per edge of elliptic section
  kNone,    ///< rolls have no mass: they follow the shape without delay
};

/// One entry per unknown of the layout: kg, kg m^2, and 0 where there is no mass. The same in global and local axes.
VecX lumped_mass(const System& system, RollInertia roll_inertia);

}  // namespace lissom
