#pragma once
/// A rod of a structure with another natural length, and another natural curvature and twist where these are constant.

#include "lissom/model/structure.h"

namespace lissom {

/// `rates`: curvatures towards b and n (1/m), twist (rad/m); of no effect on rods of another natural shape.
void reshape(Structure& structure, int rod, double length_factor, const Vec3& rates);

}  // namespace lissom
