#pragma once
/// Linear elastic, isotropic materials of rods, and the library of those we know with their sources.

#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "lissom/core/result.h"

namespace lissom {

struct Material {
  std::string name;
  double youngs_modulus = 0;                                      ///< Pa
  double poisson_ratio = 0;                                       ///< -1 < nu <= 0.5
  double density = 0;                                             ///< kg/m^3, 0 allowed (weightless)
  double strain_limit = std::numeric_limits<double>::infinity();  ///< largest strain in use (yield or fatigue)
  std::string source;                                             ///< where the numbers come from

  double shear_modulus() const { return youngs_modulus / (2 * (1 + poisson_ratio)); }  ///< Pa

  /// Refuses what no material can be: E <= 0, nu outside (-1, 0.5], negative density, non-finite numbers.
  Status validate(const std::string& where) const;
};

/// Materials that ship with lissom (TPU 92A, PLA, PETG, spring steel, GFRP, ...), each with its source.
std::span<const Material> material_library();

/// The library material of this name, or null.
const Material* find_material(std::string_view name);

}  // namespace lissom
