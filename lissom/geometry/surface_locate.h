#pragma once
/// Where points in space belong on a surface.

#include <optional>
#include <vector>

#include "lissom/geometry/surface.h"

namespace lissom {

/// The nearest place on a surface among its triangles that face as `normal` does (within 90 degrees), so that the far side of
/// a thin part is not taken; among all triangles without a normal. Looks at every triangle.
SurfacePlace nearest_place(const Surface& surface, const Vec3& x, const std::optional<Vec3>& normal = {});

/// Triangles for a path between two places: all that are connected to the first one inside a ball about the middle that is
/// large enough to connect them, ascending. `mates` as side_mates() gives them.
std::vector<int> triangles_near(const Surface& surface, const std::vector<int>& mates, const SurfacePlace& from,
                                const SurfacePlace& to);

/// Unit normals at the vertices, weighted with the angles of the triangles.
std::vector<Vec3> vertex_normals(const Surface& surface);

/// Unit normal at a place, between those of the vertices.
Vec3 smooth_normal(const Surface& surface, const std::vector<Vec3>& vertex_normals, const SurfacePlace& place);

}  // namespace lissom
