#include "lissom/posing/stiffness_map.h"

#include <algorithm>
#include <cmath>

namespace lissom {

namespace {

double membership(const DeformerRegion& region, const PartPlace& place) {
  if (place.darkness < region.dark) return 0;
  Vec3 beyond = Vec3::Zero();
  if (region.low) beyond = (*region.low - place.at).cwiseMax(place.at - *region.high).cwiseMax(0.0);
  const double distance = std::hypot(beyond.norm(), std::max(region.depth - place.depth, 0.0));
  if (distance == 0) return 1;
  if (distance >= region.blend) return 0;
  const double u = 1 - distance / region.blend;
  return u * u * (3 - 2 * u);
}

}  // namespace

PartFactors factors_at(const std::vector<DeformerRegion>& regions, const PartPlace& place) {
  PartFactors factors;
  for (const DeformerRegion& region : regions) {
    const double share = membership(region, place);
    factors.stiffness *= std::pow(region.stiffness, share);
    factors.density *= std::pow(region.density, share);
  }
  return factors;
}

}  // namespace lissom
