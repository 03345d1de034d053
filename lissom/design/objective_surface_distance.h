#pragma once
/// How far nodes are from a surface.

#include <memory>
#include <vector>

#include "lissom/design/objective.h"
#include "lissom/geometry/triangle_surface.h"

namespace lissom {

enum class DistanceKind {
  kVector,  ///< x, y, z of the vector from the nearest point: for reaching the surface
  kSigned,  ///< its length, negative inside: for staying on one side, and for shapes at a distance
};

/// Three components, or one, per node. The vector is what point-to-plane registration takes, in space: over a triangle its
/// derivative is n n', over an edge I - t t', over a corner I. It is linear in the place as long as the same triangle, edge
/// or corner is nearest, so that Gauss-Newton steps see all of 1/2 d^2 that there is, and it needs no inside. Signed lengths
/// have a kink in the edges of the surface, where directions are not defined: there derivatives are those along the mean
/// normal. Beyond the rim of an open surface the sign jumps in its plane: use vectors there.
std::shared_ptr<const Objective> make_surface_distance(std::shared_ptr<const TriangleSurface> surface,
                                                       std::vector<int> nodes, DistanceKind kind);

}  // namespace lissom
