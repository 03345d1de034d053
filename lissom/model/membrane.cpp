#include "lissom/model/membrane.h"

#include <cmath>
#include <fmt/format.h>

#include "lissom/model/membrane_formulas.h"

namespace lissom {

namespace {

constexpr const char* kThesis =
    "Computational Design of Flexible Structures, chapter 6; its unit kPa is a slip for MPa, ";

/// Built once on first use: the materials own strings, so the list cannot be constexpr.
std::vector<MembraneMaterial> make_library() {
  return {
      {"elastane-cotton knit", 47.2, 47.2, 0.30, 1e-3, 0.122, std::string(kThesis) + "thickness taken as 1 mm"},
      {"soft knit", 0.3, 0.3, 0.30, 1e-3, 0.122,
       "the knit at the stiffness with which the figures of the thesis come out for rods of 0.2 to 0.4 mm"},
  };
}

Error refuse(const std::string& where, std::string message, std::string hint) {
  return {ErrorCode::kRange, where, std::move(message), std::move(hint)};
}

}  // namespace

double MembraneMaterial::shear() const { return std::sqrt(stiffness_1 * stiffness_2) / (2 * (1 + poisson_ratio)); }

double MembraneMaterial::bend() const { return sheet_bend(stiffness_1, stiffness_2, poisson_ratio, thickness); }

Status MembraneMaterial::validate(const std::string& where) const {
  for (const double stiffness : {stiffness_1, stiffness_2}) {
    if (stiffness > 0 && std::isfinite(stiffness)) continue;
    return refuse(where, fmt::format("the stiffness of the fabric is {:g} N/m", stiffness),
                  "give a positive finite stiffness: Young's modulus times thickness");
  }
  if (!(std::abs(poisson_ratio) < 1)) {
    return refuse(where, fmt::format("the Poisson ratio is {:g}", poisson_ratio),
                  "a sheet has a ratio between -1 and 1, knits about 0.3");
  }
  if (!(thickness >= 0) || !std::isfinite(thickness)) {
    return refuse(where, fmt::format("the thickness is {:g} m", thickness), "give zero or a positive finite thickness");
  }
  if (!(area_density >= 0) || !std::isfinite(area_density)) {
    return refuse(where, fmt::format("the fabric weighs {:g} kg/m^2", area_density),
                  "give zero or a positive finite density");
  }
  return {};
}

std::span<const MembraneMaterial> membrane_library() {
  static const std::vector<MembraneMaterial> library = make_library();
  return library;
}

const MembraneMaterial* find_membrane_material(std::string_view name) {
  for (const MembraneMaterial& material : membrane_library()) {
    if (material.name == name) return &material;
  }
  return nullptr;
}

}  // namespace lissom
