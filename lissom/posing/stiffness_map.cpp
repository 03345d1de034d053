#include "lissom/posing/stiffness_map.h"

#include <cmath>

namespace lissom {

namespace {

double membership(const DeformerRegion& region, const Vec3& x, double darkness) {
  if (darkness < region.dark) return 0;
  if (!region.low) return 1;
  const Vec3 beyond = (*region.low - x).cwiseMax(x - *region.high).cwiseMax(0.0);
  const double distance = beyond.norm();
  if (distance == 0) return 1;
  if (distance >= region.blend) return 0;
  const double u = 1 - distance / region.blend;
  return u * u * (3 - 2 * u);
}

}  // namespace

PartFactors factors_at(const std::vector<DeformerRegion>& regions, const Vec3& x, double darkness) {
  PartFactors factors;
  for (const DeformerRegion& region : regions) {
    const double share = membership(region, x, darkness);
    factors.stiffness *= std::pow(region.stiffness, share);
    factors.density *= std::pow(region.density, share);
  }
  return factors;
}

}  // namespace lissom
