#pragma once
/// Shapes that are to stay stable, or to snap: the stiffness of the softest mode.

#include <memory>

#include "lissom/design/objective.h"

namespace lissom {

/// One component, N/m: smallest eigenvalue of the Hessian over the free unknowns in the metric of
/// StaticProblem::mode_metric; negative where the equilibrium is not stable. Modes in which straight rods turn about
/// themselves and nothing moves do not count. First derivatives are exact at equilibria where the eigenvalue is single and no
/// roll carries a torque that supports hold, but for what a change of the radius of gyration does to the metric of rolls,
/// which counts as fixed: the metric does not say it in rest numbers, and it vanishes with the margin. Second derivatives
/// would need fourth ones of the energy; there are none. Every evaluation factorises the Hessian.
std::shared_ptr<const Objective> make_stability_margin();

}  // namespace lissom
