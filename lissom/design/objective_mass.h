#pragma once
/// How heavy a design is, and how much material it takes.

#include <memory>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/design/objective.h"

namespace lissom {

/// Rods and membranes by their numbers in the structure; neither given: everything.
struct StructurePart {
  std::vector<int> rods, membranes;
  bool all() const { return rods.empty() && membranes.empty(); }
};

/// One component, kg. It hangs on rest numbers alone.
std::shared_ptr<const Objective> make_mass(StructurePart part = {});

/// One component, m^3: rods, by their mass, and fabric, by its area at rest times its thickness, which counts as fixed.
/// kConflict where a rod is of a material without density: rest numbers know masses only.
Result<std::shared_ptr<const Objective>> make_material_volume(const Model& model, const Structure& structure,
                                                              StructurePart part = {});

}  // namespace lissom
