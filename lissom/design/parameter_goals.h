#pragma once
/// Wishes about parameters: few changes, and changes that are alike in neighbouring places.

#include <array>
#include <span>
#include <vector>

#include "lissom/design/goal.h"
#include "lissom/design/parameter.h"
#include "lissom/design/reduced_problem.h"
#include "lissom/design/rod_controls.h"

namespace lissom {

/// Stay near `start` (m): |r| is the root mean square of (p - start) over the scales of the parameters.
ParameterGoal make_closeness(std::span<const Parameter> parameters, VecX start, double weight = 1);

/// Differences of a parameter from the mean of its neighbours, the graph Laplacian with a diagonal of 1, over its scale; |r|
/// is their root mean square. Parameters without neighbours take no part. Along a rod, values that grow evenly count as
/// smooth but at its ends; where rods meet, the mean is that over all of them.
ParameterGoal make_smoothness(std::span<const Parameter> parameters, std::span<const std::array<int, 2>> neighbours,
                              double weight = 1);

/// Controls that follow each other along a rod, for every block of parameters that begins at one of `first` and has one
/// parameter per control in their order: {0, size} for both radii of NetworkRadii. Pairs of parameters, without repeats.
std::vector<std::array<int, 2>> neighbours_along_rods(const RodControls& controls, const Structure& structure,
                                                      std::span<const int> first);

/// Those of the wishes that are one-sided, at p (m), over a step in units of `scale` (m).
OneSided one_sided_wishes(std::span<const ParameterGoal> wishes, const VecX& p, const VecX& scale);

}  // namespace lissom
