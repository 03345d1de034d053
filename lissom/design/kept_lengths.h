#pragma once
/// Edges that keep a part of their length in the rest shape, whatever it moves.

#include "lissom/design/design_space.h"
#include "lissom/design/goal.h"

namespace lissom {

/// Residuals of edges that are shorter than 0.8 of what they are as drawn, 0 for all others: what is missing, with a small
/// weight. Lengths are taken along the edges as drawn, which makes them linear in the places. The energy of an edge whose rest
/// length vanishes has no bound: one such edge ends a design, for then no step is short enough. No rows where no place changes.
ParameterGoal make_kept_lengths(const Design& base, const DesignSpace& space);

}  // namespace lissom
