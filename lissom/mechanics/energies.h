#pragma once
/// The list of energies: which terms a structure has, and which a pose adds.

#include <memory>
#include <string_view>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/mechanics/energy_term.h"
#include "lissom/model/model.h"

namespace lissom {

/// Elastic terms of the structure and, unless null, the loads and penalties of a pose. `where` names the pose in errors.
Result<std::vector<std::unique_ptr<EnergyTerm>>> make_terms(const Model& model, const System& system, const Pose* pose,
                                                            const std::string& where);

/// Whether a term of this name (EnergyTerm::name) is elastic, and not a load or a penalty of a pose.
bool is_elastic(std::string_view name);

}  // namespace lissom
