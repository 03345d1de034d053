#pragma once
/// What can be said against printing rods, before anything is written.

#include <string>
#include <vector>

#include "lissom/fabrication/print_process.h"
#include "lissom/fabrication/rod_solid.h"
#include "lissom/model/structure.h"

namespace lissom {

struct PrintFinding {
  enum class Weight {
    kError,    ///< the print will fail, or be another object
    kWarning,  ///< worth a look
  };
  Weight weight = Weight::kError;
  std::string what;   ///< "thin rod", "rods touch", "rods are close", "too large", ...
  std::string where;  ///< names of rods, with the place in mm: "rod-3 at (12.0, 4.5, 0.0) mm"
  double value = 0;  ///< SI, of what is named: a diameter, a gap (negative: how deep they overlap), an excess of length
  std::string remedy;  ///< a sentence
};

/// "rod-3 at (12.0, 4.5, 0.0) mm".
std::string print_place(const std::string& rods, const Vec3& place);

/// Thin rods, rods that touch or are close away from joints they share, and what is larger than the bed; most pressing first
/// within each kind, one per rod or pair of rods. `solids` are those of the structure.
std::vector<PrintFinding> print_checks(const Structure& structure, const std::vector<RodSolid>& solids,
                                       const PrintProcess& process, double tolerance);

/// Lowest and highest corner of solids, m.
struct SolidBox {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
};
SolidBox solid_box(const std::vector<RodSolid>& solids);

}  // namespace lissom
