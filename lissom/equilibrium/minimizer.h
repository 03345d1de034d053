#pragma once
/// Energy minimisation by Newton's method with exact Hessians [mathematics 4; convergence 4].

#include "lissom/equilibrium/equilibrium.h"
#include "lissom/equilibrium/newton_workspace.h"
#include "lissom/equilibrium/options.h"

namespace lissom {

/// How an iteration over states ended; the state and its records are in the caller's hands.
struct Descent {
  Verdict verdict = Verdict::kBadStart;  ///< kStable stands for "converged": stability has not been looked at yet
  int iterations = 0;
  double residual = 0;  ///< N
};

/// Lowers the energy of `state` at its load factor until the residual is below `tolerance` (N).
Descent minimize(NewtonWorkspace& workspace, State& state, double tolerance, const SolveOptions& options,
                 int max_iterations, std::vector<IterationRecord>& records);

/// Brings prescribed unknowns and loads of `state` to `load_factor`: steps of linear prediction, small enough in turns and
/// strains that the structure can follow, each but the last one relaxed roughly. Loads alone are set at once. kStable
/// stands for "arrived"; the residual is not looked at.
Descent move_to_load(NewtonWorkspace& workspace, State& state, double load_factor, double tolerance,
                     const SolveOptions& options, int max_iterations, std::vector<IterationRecord>& records);

}  // namespace lissom
