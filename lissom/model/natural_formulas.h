#pragma once
/// Natural strains of rods with constant natural curvature and twist: written once, for doubles and duals.

#include <cmath>

#include "lissom/geometry/frame_strain.h"

namespace lissom {

/// tan(x) / x as a function of x^2, smooth at 0.
template <class T>
T tangent_over(const T& x2) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  constexpr double kSmall = 1e-3;  // the rest of the series is rounding
  if (primal(x2) < kSmall) {
    return T(1) + x2 * (T(1.0 / 3) + x2 * (T(2.0 / 15) + x2 * (T(17.0 / 315) + x2 * T(62.0 / 2835))));
  }
  const T x = sqrt(x2);
  return sin(x) / (cos(x) * x);
}

/// Integrated curvatures over a length (m) of a rod with constant curvatures (1/m): 2 tan(phi / 2) for the turning angle
/// phi, shared out on both axes.
template <class T>
Curvature<T> natural_curvature(const T& curvature_b, const T& curvature_n, const T& length) {
  const T half = length * T(0.5);
  const T factor = length * tangent_over<T>((curvature_b * curvature_b + curvature_n * curvature_n) * half * half);
  return {curvature_b * factor, curvature_n * factor};
}

}  // namespace lissom
