#include "lissom/design/one_sided_cg.h"

#include <algorithm>

namespace lissom {

namespace {

constexpr int kRounds = 16;
constexpr int kParts = 4;  // of the products, for a round whose step may bring more to count
constexpr int kHalvings = 30;

VecX counts(const VecX& t) {
  return t.unaryExpr([](double v) { return v > 0 ? 1.0 : 0.0; });
}

/// k but for a constant, and its gradient over t.
double correction(const VecX& t, const VecX& at_start) {
  return 0.5 * (t.cwiseMax(0).squaredNorm() - at_start.dot(t.cwiseAbs2()));
}
VecX correction_slope(const VecX& t, const VecX& at_start) { return t.cwiseMax(0) - at_start.cwiseProduct(t); }

/// Where something convex that falls at 0 is least between 0 and 1.
template <class Rises>
double least_along(const Rises& rises) {
  if (!rises(1)) return 1;
  double low = 0, high = 1;
  for (int i = 0; i < kHalvings; ++i) (rises(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
  return low;
}

}  // namespace

BoxCgSolution solve_one_sided_cg(const std::function<VecX(const VecX&)>& times, const VecX& g, const OneSided& sided,
                                 const VecX& lower, const VecX& upper, double tolerance, int max_products) {
  if (sided.value.size() == 0) return solve_box_cg(times, g, lower, upper, {}, tolerance, max_products);
  const VecX at_start = counts(sided.value);
  VecX t = sided.value, smooth = g;  // smooth: g + H x
  BoxCgSolution all;
  all.x = VecX::Zero(g.size());
  int most = std::max(max_products / kParts, 1);  // of a round
  for (int round = 0; round < kRounds && all.products < max_products; ++round) {
    const VecX now = counts(t), weight = now - at_start;
    const VecX gradient = smooth + sided.rows.transpose() * correction_slope(t, at_start);
    const std::function<VecX(const VecX&)> times_now = [&](const VecX& v) -> VecX {
      return times(v) + sided.rows.transpose() * weight.cwiseProduct(sided.rows * v);
    };
    const VecX room_below = (lower - all.x).cwiseMin(0), room_above = (upper - all.x).cwiseMax(0);
    BoxCgSolution part = solve_box_cg(times_now, gradient, room_below, room_above, {}, tolerance,
                                      std::clamp(max_products - all.products, 1, most));
    all.products += part.products + 1;
    all.gradient_left = part.gradient_left;
    all.negative_curvature = all.negative_curvature || part.negative_curvature;
    if ((part.x.array() == 0).all()) break;
    const VecX image = times(part.x), change_of_t = sided.rows * part.x;
    const double slope = smooth.dot(part.x), curvature = part.x.dot(image);
    const auto rises = [&](double a) {
      return slope + a * curvature + change_of_t.dot(correction_slope(t + a * change_of_t, at_start)) > 0;
    };
    const double a = least_along(rises);
    const double change =
        a * slope + 0.5 * a * a * curvature + correction(t + a * change_of_t, at_start) - correction(t, at_start);
    if (!(change < 0)) break;
    all.x = (all.x + a * part.x).cwiseMax(lower).cwiseMin(upper);
    // What ended at a bound ends there exactly.
    if (a == 1) all.x = (part.x.array() == room_below.array() && room_below.array() < 0).select(lower, all.x);
    if (a == 1) all.x = (part.x.array() == room_above.array() && room_above.array() > 0).select(upper, all.x);
    smooth += a * image;
    t += a * change_of_t;
    all.decrease -= change;
    const bool whole = a == 1 && counts(t) == now;
    if (whole && part.gradient_left <= tolerance) break;
    most = whole ? max_products : std::max(max_products / kParts, 1);
  }
  return all;
}

}  // namespace lissom
