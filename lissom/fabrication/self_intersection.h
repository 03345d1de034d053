#pragma once
/// Triangles of a surface that pass through each other.

#include <optional>

#include "lissom/core/context.h"
#include "lissom/geometry/surface.h"

namespace lissom {

/// A point (m) near which two triangles intersect that are no neighbours, or neighbours overlap; nothing when there is none.
/// Decided with exact predicates. Every edge has to have two triangles that run along it in opposite directions.
std::optional<Vec3> self_intersection(const Surface& surface, const Context& context);

}  // namespace lissom
