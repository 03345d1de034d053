#pragma once
/// Newton's method on the forces with the norm of the forces as merit [thesis 3.4.1; mathematics 4, erratum E17]: finds
/// equilibria of any stability. Also the corrector of path following.

#include "lissom/equilibrium/minimizer.h"

namespace lissom {

Descent find_root(NewtonWorkspace& workspace, State& state, double tolerance, const SolveOptions& options,
                  int max_iterations, std::vector<IterationRecord>& records);

}  // namespace lissom
