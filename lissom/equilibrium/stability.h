#pragma once
/// Is an equilibrium stable? Inertia of the unshifted Hessian and its lowest modes.

#include <vector>

#include "lissom/equilibrium/equilibrium.h"
#include "lissom/equilibrium/newton_workspace.h"

namespace lissom {

struct Stability {
  int negative = 0;         ///< modes that release energy, beyond rounding
  bool critical = false;    ///< some mode costs no energy within rounding, spins aside
  int spins = 0;            ///< modes without energy in which straight rods turn about their own axis: nothing moves
  double band = 0;          ///< N/m, stiffnesses below this in size count as zero
  std::vector<Mode> modes;  ///< lowest, ascending; shapes in global axes
  MatX free_shapes;         ///< the same over the free unknowns, one column each
};

/// Of the Hessian last assembled in the workspace. Leaves the workspace's factor unusable for the unshifted system when
/// that is not positive definite.
Stability examine_stability(NewtonWorkspace& workspace, int modes);

}  // namespace lissom
