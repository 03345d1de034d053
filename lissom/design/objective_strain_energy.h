#pragma once
/// How much elastic energy a shape stores.

#include <memory>

#include "lissom/design/objective.h"

namespace lissom {

/// One component, J: energy of all rods, joints and membranes, without loads.
std::shared_ptr<const Objective> make_strain_energy();

}  // namespace lissom
