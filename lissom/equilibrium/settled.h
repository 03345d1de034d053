#pragma once
/// The shape that a pose takes, for those who only want the shape.

#include <string>

#include "lissom/core/context.h"
#include "lissom/equilibrium/equilibrium.h"
#include "lissom/mechanics/system.h"
#include "lissom/model/model.h"

namespace lissom {

/// The equilibrium that is found from the start of the pose at load factor 1, without its modes. Its verdict says whether it is
/// stable. Errors are those of make_static_problem; `where`: the pose, for them.
Result<Equilibrium> settled(const Model& model, const System& system, const Pose& pose, const std::string& where,
                            const Context& context);

}  // namespace lissom
