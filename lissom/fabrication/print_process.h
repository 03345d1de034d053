#pragma once
/// What a way of printing can make, and what its material costs.

#include <span>
#include <string_view>

#include "lissom/core/types.h"

namespace lissom {

struct PrintProcess {
  std::string_view name;  ///< "sls"
  std::string_view description;
  double diameter = 0;      ///< m, of the thinnest rod
  double gap = 0;           ///< m, between rods that are not to fuse
  Vec3 bed;                 ///< m, what it can print at most along x, y, z
  double cost = 0;          ///< euro per kg of material; powder or resin that is lost on the way is in it
  std::string_view source;  ///< of all these numbers
};

/// Selective laser sintering, fused deposition, stereolithography.
std::span<const PrintProcess> print_processes();

/// Null when unknown.
const PrintProcess* find_process(std::string_view name);

}  // namespace lissom
