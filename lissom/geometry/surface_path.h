#pragma once
/// Lines on a surface: shortest paths between two places, and points at even distances along them.

#include <optional>
#include <span>
#include <vector>

#include "lissom/geometry/surface.h"

namespace lissom {

/// A straight piece of a line, inside one triangle.
struct SurfaceSegment {
  int triangle = -1;
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< barycentric
};
using SurfacePath = std::vector<SurfaceSegment>;  ///< each piece begins where the one before ends

double path_length(const Surface& surface, const SurfacePath& path);  ///< m

SurfacePath reversed(const SurfacePath& path);

/// `edges` + 1 places at equal distances along the path, both ends included.
std::vector<SurfacePlace> sample_path(const Surface& surface, const SurfacePath& path, int edges);

/// The shortest path from `from` to `to` that stays on the triangles of `patch` [Xin, Wang 2009, through CGAL]. Nothing
/// when the patch does not connect them. Ends on edges and vertices are met to within a millionth of a triangle. `from` and `to` lie on triangles of the patch; the patch is manifold.
std::optional<SurfacePath> shortest_path(const Surface& surface, std::span<const int> patch, const SurfacePlace& from,
                                         const SurfacePlace& to);

}  // namespace lissom
