#include "lissom/model/section.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace lissom {

namespace {

constexpr double kPi = std::numbers::pi;

/// Area and second moments: `bend_b` is the integral of (coordinate along b)^2 over the section, m^4.
struct Moments {
  double area = 0, bend_b = 0, bend_n = 0, torsion = 0;
};

/// Saint-Venant torsion constant of a rectangle with sides 2 r_n and 2 r_b (Timoshenko & Goodier, Theory of Elasticity):
/// J = a b^3 / 3 (1 - 192 b / (pi^5 a) sum over odd k of tanh(k pi a / 2b) / k^5), b the shorter side.
double rectangle_torsion(double r_n, double r_b) {
  const double b = 2 * std::min(r_n, r_b), a = 2 * std::max(r_n, r_b);
  double sum = 0;
  for (int k = 199; k >= 1; k -= 2) sum += std::tanh(k * kPi * a / (2 * b)) / std::pow(k, 5);  // rest below 1e-10
  return a * b * b * b / 3 * (1 - 192 * b / (std::pow(kPi, 5) * a) * sum);
}

Moments moments(const Section& s) {
  Moments m;
  switch (s.shape) {
    case SectionShape::kEllipse: {
      const double rn2 = s.r_n * s.r_n, rb2 = s.r_b * s.r_b;
      m.area = kPi * s.r_n * s.r_b;
      m.bend_b = m.area * rb2 / 4;
      m.bend_n = m.area * rn2 / 4;
      m.torsion = m.area * rn2 * rb2 / (rn2 + rb2);
      break;
    }
    case SectionShape::kRectangle:
      m.area = 4 * s.r_n * s.r_b;
      m.bend_b = m.area * s.r_b * s.r_b / 3;
      m.bend_n = m.area * s.r_n * s.r_n / 3;
      m.torsion = rectangle_torsion(s.r_n, s.r_b);
      break;
    case SectionShape::kTube: {
      const double outer = s.r_n * s.r_n, inner = (s.r_n - s.wall) * (s.r_n - s.wall);
      m.area = kPi * (outer - inner);
      m.bend_b = m.bend_n = kPi * (outer * outer - inner * inner) / 4;
      m.torsion = 2 * m.bend_b;
      break;
    }
  }
  return m;
}

Error refuse(const std::string& where, std::string message, std::string hint) {
  return {ErrorCode::kRange, where, std::move(message), std::move(hint)};
}

}  // namespace

Status Section::validate(const std::string& where) const {
  if (!(r_n > 0) || !(r_b > 0) || !std::isfinite(r_n) || !std::isfinite(r_b)) {
    return refuse(where, fmt::format("the half-extents are {:g} m along n and {:g} m along b", r_n, r_b),
                  "both must be positive and finite");
  }
  if (shape != SectionShape::kTube) return {};
  if (std::abs(r_n - r_b) > 1e-9 * r_n) {
    return refuse(where, fmt::format("the tube has two outer radii, {:g} m and {:g} m", r_n, r_b),
                  "tubes are round: give one radius, or use an ellipse");
  }
  if (!(wall > 0) || !(wall < r_n)) {
    return refuse(where, fmt::format("the wall is {:g} m thick at an outer radius of {:g} m", wall, r_n),
                  "the wall must be positive and thinner than the radius; use an ellipse for a solid rod");
  }
  return {};
}

SectionStiffness section_stiffness(const Section& section, const Material& material, TorsionModel torsion) {
  const Moments m = moments(section);
  const double polar = m.bend_b + m.bend_n;
  SectionStiffness k;
  k.stretch = material.youngs_modulus * m.area;
  k.bend_b = material.youngs_modulus * m.bend_b;
  k.bend_n = material.youngs_modulus * m.bend_n;
  k.twist = material.shear_modulus() * (torsion == TorsionModel::kPolar ? polar : m.torsion);
  k.mass = material.density * m.area;
  k.roll_inertia = material.density * polar;
  return k;
}

}  // namespace lissom
