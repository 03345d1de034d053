#pragma once
/// Builds the terms of the corotational joints of a structure, one term per number of edges.

#include <memory>
#include <vector>

#include "lissom/mechanics/energy_term.h"
#include "lissom/model/model.h"

namespace lissom {

void append_corotational_joints(const Model& model, const System& system,
                                std::vector<std::unique_ptr<EnergyTerm>>& terms);

}  // namespace lissom
