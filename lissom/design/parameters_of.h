#pragma once
/// The parameters of a design that another space, or nobody, made: what lets one stage of a design go on where another ended.

#include "lissom/design/design_space.h"

namespace lissom {

/// p for which `space` makes `design`, a design of the same nodes, joints, triangles and poses: least squares in all numbers
/// that follow from p, the nearest to the start where several do. Parameters that would be outside of their bounds are put on
/// them: radii between few controls may be where controls may not. kConflict, with the number that differs most, where the
/// space has no such design, bounds or not.
Result<VecX> parameters_of(const DesignSpace& space, const Design& design);

}  // namespace lissom
