#pragma once
/// The list of energies: which terms a structure has, and which a pose adds.

#include <memory>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/mechanics/energy_term.h"
#include "lissom/model/model.h"

namespace lissom {

/// Elastic terms of the structure and, unless null, the loads and penalties of a pose. `where` names the pose in errors.
Result<std::vector<std::unique_ptr<EnergyTerm>>> make_terms(const Model& model, const System& system, const Pose* pose,
                                                            const std::string& where);

}  // namespace lissom
