#pragma once
/// The constraints that a document keeps for its tools, on the nodes of a shape and on design parameters.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "lissom/design/hard_constraints.h"
#include "lissom/design/parameter.h"
#include "lissom/design/rigid_gauge.h"
#include "lissom/model/model.h"
#include "lissom/studio/shape_packs.h"

namespace lissom {

/// Nodes of pinned points, of attached pairs and of points that keep in a plane; a tie for every parameter that has a mirror
/// image. Points on the line of symmetry keep on it.
HardConstraints hard_constraints(const Model& model, const PlanParts& parts, std::span<const Parameter> parameters);

/// Pinned points whose places are known.
std::vector<PinnedNode> pinned_nodes(const Model& model, const PlanParts& parts,
                                     const std::map<std::string, Vec3>& places);

}  // namespace lissom
