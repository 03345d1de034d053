#include "lissom/model/section.h"

#include <cmath>
#include <fmt/format.h>

#include "lissom/model/section_formulas.h"

namespace lissom {

namespace {

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
  return section_stiffness<double>(section.shape, section.r_n, section.r_b, section.wall, material.youngs_modulus,
                                   material, torsion);
}

}  // namespace lissom
