#pragma once
/// Where the nodes of a structure end up: what wanted shapes are made from.

#include <vector>

#include "lissom/core/context.h"
#include "lissom/core/result.h"
#include "lissom/model/model.h"

namespace lissom::scene_models {

/// m, of every node in pose number `pose`, in its stable equilibrium from the drawn shape. kConflict where there is none.
Result<std::vector<Vec3>> settled_places(const Model& model, int pose, const Context& context);

}  // namespace lissom::scene_models
