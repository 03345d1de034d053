#pragma once
/// Largest strain in a section of a rod, from its axial strain, curvatures and twist: what breaks a rod.

#include <cmath>
#include <numbers>

#include "lissom/core/dual.h"
#include "lissom/model/section.h"

namespace lissom {

/// Absolute values and roots are rounded off over this strain: strains read up to a few of it too low.
inline constexpr double kStrainRounding = 1e-5;

template <class T>
T rounded_root(const T& square) {
  using std::sqrt;
  return sqrt(T(square + T(kStrainRounding * kStrainRounding))) - T(kStrainRounding);
}

inline double hyperbolic_secant(double x) { return 1 / std::cosh(x); }
template <AnyDual D>
D hyperbolic_secant(const D& x) {
  const double s = 1 / std::cosh(x.a), t = std::tanh(x.a);
  return D::chain(x, s, -s * t, s * (2 * t * t - 1), s * t * (5 - 6 * t * t));
}

/// State of a section. `axial`: strain; `bend_b`, `bend_n`: change of curvature with deflection along b and n, 1/m; `twist`:
/// change of the twist rate, rad/m; `r_b`, `r_n`: half-extents, m, the outer radius of tubes.
template <class T>
struct SectionState {
  T axial, bend_b, bend_n, twist, r_b, r_n;
};

/// Shear strain at the surface by the twist rate, m [Timoshenko and Goodier, Theory of Elasticity, torsion]: for ellipses
/// 2 a^2 b / (a^2 + b^2) at the ends of the shorter half-axis b; for rectangles at the middle of the longer side
/// 2 b (1 - 8/pi^2 sum over odd k of sech(k pi a / 2b) / k^2). Round sections are where a and b change places: there the
/// longer one is rounded off, and read up to 0.05 % too long.
template <class T>
T twist_lever(SectionShape shape, const T& r_b, const T& r_n) {
  using std::sqrt;
  if (shape == SectionShape::kTube) return r_n;
  const T sum = r_b + r_n, difference = r_b - r_n;
  const T longer = (sum + sqrt(T(difference * difference + T(1e-6) * sum * sum))) * T(0.5);
  if (shape == SectionShape::kEllipse) return T(2) * r_b * r_n * longer / (r_b * r_b + r_n * r_n);
  const T shorter = r_b * r_n / longer, slenderness = longer / shorter;
  T series(0);
  for (int k = 1; k <= 9; k += 2) {
    series += hyperbolic_secant(T(slenderness * T(k * std::numbers::pi / 2))) * T(1.0 / (k * k));
  }
  return T(2) * shorter * (T(1) - series * T(8 / (std::numbers::pi * std::numbers::pi)));
}

/// Von Mises stress over Young's modulus, where all largest strains are taken to meet: sqrt(e^2 + 3/4 (g / (1 + nu))^2) with
/// e the strain of the outer fibre, |axial| + bending, and g the shear strain at the surface.
template <class T>
T section_strain(SectionShape shape, const SectionState<T>& s, double poisson_ratio) {
  const T along_b = s.r_b * s.bend_b, along_n = s.r_n * s.bend_n;
  const T bending = shape == SectionShape::kRectangle
                        ? T(rounded_root(T(along_b * along_b)) + rounded_root(T(along_n * along_n)))
                        : rounded_root(T(along_b * along_b + along_n * along_n));
  const T fibre = rounded_root(T(s.axial * s.axial)) + bending;
  const T shear = twist_lever(shape, s.r_b, s.r_n) * s.twist * T(std::sqrt(0.75) / (1 + poisson_ratio));
  return rounded_root(T(fibre * fibre + shear * shear));
}

}  // namespace lissom
