#pragma once
/// Whether rods that are to be printed survive their poses.

#include <string>
#include <vector>

#include "lissom/fabrication/print_checks.h"
#include "lissom/session/study.h"

namespace lissom {

/// What a pose asks of the rod that is strained most, against the limit of its material.
struct PoseStrain {
  std::string pose;
  std::string place;  ///< rod and place, mm
  double strain = 0;  ///< as in lissom/design/section_strain.h
  double limit = 0;   ///< of the material; infinite when none is known
};

struct StrainChecks {
  std::vector<PoseStrain> poses;       ///< of those that come to rest
  std::vector<PrintFinding> findings;  ///< one per rod beyond its limit, with its worst pose, most pressing first; and
                                       ///< a warning for every pose that does not come to rest
};

/// Solves every pose of the model.
StrainChecks check_strains(const Model& model, const SolveOptions& options, const Context& context);

}  // namespace lissom
