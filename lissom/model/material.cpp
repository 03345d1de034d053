#include "lissom/model/material.h"

#include <cmath>
#include <fmt/format.h>
#include <vector>

namespace lissom {

namespace {

constexpr const char* kThesis = "Computational Design of Flexible Structures, tables of material constants";

/// Built once on first use: `Material` owns strings, so it cannot be constexpr.
std::vector<Material> make_library() {
  return {
      {"TPU 92A", 32e6, 0.48, 1200, 0.20, kThesis},
      {"PLA", 3.31e9, 0.36, 1240, 0.015, std::string(kThesis) + "; its unit kPa is a slip for MPa"},
      {"PETG", 2.1e9, 0.38, 1270, 0.02, "typical filament data sheets"},
      {"ABS", 2.1e9, 0.37, 1050, 0.02, "typical filament data sheets"},
      {"PA12", 1.7e9, 0.39, 1000, 0.04, "typical data sheets of laser-sintered nylon 12"},
      {"PP", 1.3e9, 0.42, 905, 0.04, "plastics handbooks, homopolymer"},
      {"POM", 2.8e9, 0.37, 1410, 0.025, "plastics handbooks, copolymer"},
      {"polycarbonate", 2.35e9, 0.37, 1200, 0.025, "plastics handbooks"},
      {"silicone", 2e6, 0.49, 1150, 0.5, "typical data sheets, about Shore 50A, small-strain modulus"},
      {"spring steel", 206e9, 0.29, 7850, 0.006,
       "handbook values of hardened carbon and chromium-vanadium spring steel"},
      {"stainless steel", 193e9, 0.30, 7900, 0.005, "handbook values of 1.4310 (302) spring wire; lower if annealed"},
      {"mild steel", 210e9, 0.30, 7850, 0.0011, "handbook values of structural steel S235"},
      {"aluminium 6060", 69.5e9, 0.33, 2700, 0.002, "handbook values, temper T66"},
      {"brass", 100e9, 0.34, 8500, 0.002, "handbook values of CuZn37, half hard"},
      {"nitinol", 55e9, 0.33, 6450, 0.008, "typical data sheets, superelastic wire below its plateau"},
      {"GFRP", 25e9, 0.27, 1850, 0.012, "typical pultruded profile data sheets, along the fibres, isotropic reading"},
      {"CFRP", 120e9, 0.30, 1550, 0.008, "typical pultruded rod data sheets, along the fibres, isotropic reading"},
      {"spruce", 11e9, 0.37, 430, 0.005, "wood handbooks, along the grain, isotropic reading"},
      {"ash", 13e9, 0.37, 690, 0.008, "wood handbooks, along the grain, isotropic reading"},
      {"bamboo", 17e9, 0.30, 700, 0.007, "handbook values, along the culm, isotropic reading"},
  };
}

Error refuse(const std::string& where, std::string message, std::string hint) {
  return {ErrorCode::kRange, where, std::move(message), std::move(hint)};
}

}  // namespace

Status Material::validate(const std::string& where) const {
  if (!(youngs_modulus > 0) || !std::isfinite(youngs_modulus)) {
    return refuse(where, fmt::format("the Young's modulus is {:g} Pa", youngs_modulus),
                  "give a positive finite modulus");
  }
  if (!(poisson_ratio > -1 && poisson_ratio <= 0.5)) {
    return refuse(where, fmt::format("the Poisson ratio is {:g}", poisson_ratio),
                  "an isotropic material has a ratio above -1 and at most 0.5");
  }
  if (!(density >= 0) || !std::isfinite(density)) {
    return refuse(where, fmt::format("the density is {:g} kg/m^3", density), "give zero or a positive finite density");
  }
  if (!(strain_limit > 0)) {
    return refuse(where, fmt::format("the strain limit is {:g}", strain_limit),
                  "give a positive strain or leave it out");
  }
  return {};
}

std::span<const Material> material_library() {
  static const std::vector<Material> library = make_library();
  return library;
}

const Material* find_material(std::string_view name) {
  for (const Material& material : material_library()) {
    if (material.name == name) return &material;
  }
  return nullptr;
}

}  // namespace lissom
