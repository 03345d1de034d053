#pragma once
/// How heavy a design is, and how much material it takes.

#include <memory>
#include <vector>

#include "lissom/design/objective.h"

namespace lissom {

/// Rods and membranes by their numbers in the structure; neither given: everything.
struct StructurePart {
  std::vector<int> rods, membranes;
  bool all() const { return rods.empty() && membranes.empty(); }
};

/// One component, kg. It hangs on rest numbers alone.
std::shared_ptr<const Objective> make_mass(StructurePart part = {});

/// One component, m^3: rods, and fabric by its area at rest times its thickness, which counts as fixed. Rods of a material
/// without density take no volume here, since rest numbers know their mass only.
std::shared_ptr<const Objective> make_material_volume(StructurePart part = {});

}  // namespace lissom
