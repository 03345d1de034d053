#pragma once
/// Volume under a membrane: of rooms, cushions and vessels.

#include <memory>
#include <optional>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/design/objective.h"

namespace lissom {

/// One component, m^3: volume enclosed by these membranes (numbers in Structure::membranes; none: all) and a cap on every
/// rim, a fan from the mean of the rim's nodes, which is the flat piece that a plane rim bounds; or all rims by one fan from
/// `apex`, a place in space (m). Signed: positive where the normals of the membranes point outwards. The sum of the signed
/// volumes of what is enclosed, where a surface crosses itself. kUnsupported without triangles, or where more than two
/// triangles meet in an edge or neighbours are turned against each other.
Result<std::shared_ptr<const Objective>> make_enclosed_volume(const Structure& structure,
                                                              const std::vector<int>& membranes = {},
                                                              const std::optional<Vec3>& apex = {});

}  // namespace lissom
