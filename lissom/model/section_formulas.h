#pragma once
/// Areas, second moments and stiffnesses of cross-sections by their half-extents: written once for doubles and duals.

#include <cmath>
#include <numbers>

#include "lissom/model/section.h"

namespace lissom {

/// `bend_b` is the integral of (coordinate along b)^2 over the section, m^4.
template <class T>
struct SectionMoments {
  T area = 0, bend_b = 0, bend_n = 0, torsion = 0;
};

/// Saint-Venant torsion constant of a rectangle with sides 2 r_n and 2 r_b (Timoshenko & Goodier, Theory of Elasticity):
/// J = a b^3 / 3 (1 - 192 b / (pi^5 a) sum over odd k of tanh(k pi a / 2b) / k^5), b the shorter side.
template <class T>
T rectangle_torsion(const T& r_n, const T& r_b) {
  using std::tanh;
  const bool flat = r_n < r_b;
  const T b = T(2) * (flat ? r_n : r_b), a = T(2) * (flat ? r_b : r_n), slenderness = a / b;
  T sum = 0;
  for (int k = 199; k >= 1; k -= 2) {  // rest below 1e-10
    sum += tanh(slenderness * T(k * std::numbers::pi / 2)) * T(1 / std::pow(k, 5));
  }
  return a * b * b * b * T(1.0 / 3) * (T(1) - T(192 / std::pow(std::numbers::pi, 5)) * sum / slenderness);
}

template <class T>
SectionMoments<T> section_moments(SectionShape shape, const T& r_n, const T& r_b, double wall) {
  constexpr double kPi = std::numbers::pi;
  SectionMoments<T> m;
  switch (shape) {
    case SectionShape::kEllipse: {
      const T rn2 = r_n * r_n, rb2 = r_b * r_b;
      m.area = T(kPi) * r_n * r_b;
      m.bend_b = m.area * rb2 * T(0.25);
      m.bend_n = m.area * rn2 * T(0.25);
      m.torsion = m.area * rn2 * rb2 / (rn2 + rb2);
      break;
    }
    case SectionShape::kRectangle:
      m.area = T(4) * r_n * r_b;
      m.bend_b = m.area * r_b * r_b * T(1.0 / 3);
      m.bend_n = m.area * r_n * r_n * T(1.0 / 3);
      m.torsion = rectangle_torsion(r_n, r_b);
      break;
    case SectionShape::kTube: {
      const T hollow = r_n - T(wall), outer = r_n * r_n, inner = hollow * hollow;
      m.area = T(kPi) * (outer - inner);
      m.bend_b = m.bend_n = T(kPi / 4) * (outer * outer - inner * inner);
      m.torsion = T(2) * m.bend_b;
      break;
    }
  }
  return m;
}

/// `youngs_modulus`: Pa, in place of that of the material.
template <class T>
SectionStiffnessT<T> section_stiffness(SectionShape shape, const T& r_n, const T& r_b, double wall,
                                       const T& youngs_modulus, const Material& material, TorsionModel torsion) {
  const SectionMoments<T> m = section_moments(shape, r_n, r_b, wall);
  const T polar = m.bend_b + m.bend_n;
  const T shear_modulus = youngs_modulus * T(0.5 / (1 + material.poisson_ratio));
  return {youngs_modulus * m.area,      youngs_modulus * m.bend_b,
          youngs_modulus * m.bend_n,    shear_modulus * (torsion == TorsionModel::kPolar ? polar : m.torsion),
          T(material.density) * m.area, T(material.density) * polar};
}

}  // namespace lissom
