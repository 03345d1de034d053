#pragma once
/// How stiff and heavy the parts of a deformer are.

#include <vector>

#include "lissom/model/rod_mesh.h"

namespace lissom {

struct PartFactors {
  double stiffness = 1, density = 1;
};

/// Where in a deformer.
struct PartPlace {
  Vec3 at = Vec3::Zero();  ///< m
  double darkness = 0;     ///< of the surface there, 0 to 1
  double depth = 0;        ///< m below the surface
};

/// Factors at a place: those of all regions multiplied, each to the power of how much it is there: 1 inside its box and at
/// its depth, fading to 0 outside over the width of its blend; 0 where the surface is not dark enough.
PartFactors factors_at(const std::vector<DeformerRegion>& regions, const PartPlace& place);

}  // namespace lissom
