#pragma once
/// Points on the circle through three points of the plane, straight when these are in line.

#include <cmath>
#include <utility>

#include "lissom/core/dual.h"

namespace lissom {

/// x and y of T: double or a dual number.
template <class T>
using PlanarPoint = std::pair<T, T>;

/// Half of the angle by which the arc from a to b turns that does not pass through `other`; anticlockwise is positive
/// (inscribed angle at `other`).
template <class T>
T half_sweep(const PlanarPoint<T>& a, const PlanarPoint<T>& b, const PlanarPoint<T>& other) {
  using std::atan2;
  const T ux = a.first - other.first, uy = a.second - other.second;
  const T vx = b.first - other.first, vy = b.second - other.second;
  return atan2(ux * vy - uy * vx, ux * vx + uy * vy);
}

/// The point at the part s (0 to 1) of that arc. It is as far along as the chord from a, which is sin(s h) / sin(h) of
/// the whole one, turned back by (1 - s) h; h is the half sweep.
template <class T>
PlanarPoint<T> arc_point(const PlanarPoint<T>& a, const PlanarPoint<T>& b, const PlanarPoint<T>& other, double s) {
  using std::cos;
  using std::sin;
  const T h = half_sweep(a, b, other);
  // Near a straight line the quotient is taken from its series: sin(s h) / sin(h) = s (1 + (1 - s^2) h^2 / 6 + ...).
  const T ratio = std::abs(primal(h)) < 1e-4 ? T(s) * (T(1) + T((1 - s * s) / 6) * h * h) : sin(T(s) * h) / sin(h);
  const T back = T(s - 1) * h;
  const T c = cos(back), d = sin(back);
  const T x = b.first - a.first, y = b.second - a.second;
  return {a.first + ratio * (c * x - d * y), a.second + ratio * (d * x + c * y)};
}

}  // namespace lissom
