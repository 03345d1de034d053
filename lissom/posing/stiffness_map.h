#pragma once
/// How stiff and heavy the parts of a deformer are.

#include <vector>

#include "lissom/model/rod_mesh.h"

namespace lissom {

struct PartFactors {
  double stiffness = 1, density = 1;
};

/// Factors at a point: those of all regions multiplied, each to the power of how much it is there: 1 inside its box, fading to
/// 0 outside over the width of its blend; 0 where the surface is not dark enough. x in m, darkness 0 to 1.
PartFactors factors_at(const std::vector<DeformerRegion>& regions, const Vec3& x, double darkness);

}  // namespace lissom
