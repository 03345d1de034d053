#pragma once
/// Builds the terms of the corotational joints of a structure, one term per number of edges.

#include "lissom/mechanics/energy_builders.h"

namespace lissom {

void append_corotational_joints(const EnergySource& source, EnergyTerms& terms);

}  // namespace lissom
