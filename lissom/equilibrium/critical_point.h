#pragma once
/// Finds the load at which an equilibrium path loses (or regains) stability, between two points on it.

#include <optional>

#include "lissom/equilibrium/continuation.h"
#include "lissom/equilibrium/newton_workspace.h"

namespace lissom {

/// Lowest stiffness and mode of the pencil (H, mode metric) at a state in equilibrium; `negative` counts modes below
/// rounding. The Hessian of the workspace is left at this state.
struct PathStability {
  int negative = 0;
  double lowest = 0;   ///< N/m; for several negative modes that of the one nearest to 0 is in `nearest`
  double nearest = 0;  ///< N/m, stiffness of smallest size among those looked at
  VecX nearest_shape;  ///< free unknowns
  double band = 0;     ///< N/m
};
PathStability path_stability(NewtonWorkspace& workspace, const State& state);

/// Derivative of the free gradient by the load factor at fixed unknowns, plus what prescribed motion does to it.
VecX load_sensitivity(NewtonWorkspace& workspace, const State& state);

/// Corrector: brings a state at its load factor into equilibrium of any stability. False when it does not converge or
/// leaves the branch.
bool correct(NewtonWorkspace& workspace, State& state, double tolerance, const SolveOptions& options,
             int most_steps = 25);

/// Predictor along the tangent dq/dlambda, then corrector.
bool step_load(NewtonWorkspace& workspace, const State& from, double load_factor, double tolerance,
               const SolveOptions& options, State& to);

/// Bisects with secants on the stiffness that changes sign until the load factor is known to `width`.
std::optional<CriticalPoint> locate_critical(NewtonWorkspace& workspace, const State& before,
                                             const PathStability& at_before, const State& after,
                                             const PathStability& at_after, double width, double tolerance,
                                             const SolveOptions& options);

}  // namespace lissom
