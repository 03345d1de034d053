#include "lissom/design/bound_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "lissom/core/assert.h"

namespace lissom {

namespace {
constexpr double kPi = std::numbers::pi;
}

BoundMap::BoundMap(VecX lower, VecX upper) : lower_(std::move(lower)), upper_(std::move(upper)) {
  LISSOM_ASSERT(lower_.size() == upper_.size());
  for (int i = 0; i < size(); ++i) {
    LISSOM_ASSERT(lower_[i] < upper_[i] && std::isfinite(lower_[i]) == std::isfinite(upper_[i]));
  }
}

bool BoundMap::bounded(int i) const { return std::isfinite(lower_[i]); }

VecX BoundMap::parameters(const VecX& u) const {
  VecX p = u;
  for (int i = 0; i < size(); ++i) {
    if (!bounded(i)) continue;
    const double range = upper_[i] - lower_[i];
    p[i] = 0.5 * (lower_[i] + upper_[i]) + range / kPi * std::atan(kPi * u[i] / range);
  }
  return p;
}

VecX BoundMap::unbounded(const VecX& p) const {
  VecX u = p;
  for (int i = 0; i < size(); ++i) {
    if (!bounded(i)) continue;
    LISSOM_ASSERT(p[i] > lower_[i] && p[i] < upper_[i]);
    const double range = upper_[i] - lower_[i];
    u[i] = range / kPi * std::tan(kPi * (p[i] - 0.5 * (lower_[i] + upper_[i])) / range);
  }
  return u;
}

VecX BoundMap::slope(const VecX& u) const {
  VecX slope = VecX::Ones(size());
  for (int i = 0; i < size(); ++i) {
    if (!bounded(i)) continue;
    const double x = kPi * u[i] / (upper_[i] - lower_[i]);
    slope[i] = 1 / (1 + x * x);
  }
  return slope;
}

VecX BoundMap::curvature(const VecX& u) const {
  VecX curvature = VecX::Zero(size());
  for (int i = 0; i < size(); ++i) {
    if (!bounded(i)) continue;
    const double per_range = kPi / (upper_[i] - lower_[i]), x = per_range * u[i], slope = 1 / (1 + x * x);
    curvature[i] = -2 * per_range * x * slope * slope;
  }
  return curvature;
}

VecX BoundMap::inside(const VecX& p, double share) const {
  VecX moved = p;
  for (int i = 0; i < size(); ++i) {
    if (!bounded(i)) continue;
    const double margin = share * (upper_[i] - lower_[i]);
    moved[i] = std::clamp(p[i], lower_[i] + margin, upper_[i] - margin);
  }
  return moved;
}

}  // namespace lissom
