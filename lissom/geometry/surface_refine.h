#pragma once
/// A surface cut finer without a change of its shape: what is traced on the small triangles lies on the given ones.

#include <functional>
#include <vector>

#include "lissom/geometry/surface.h"

namespace lissom {

struct RefinedSurface {
  Surface surface;
  std::vector<int> origin;                          ///< per triangle: the given triangle that it is a part of
  std::vector<std::array<Vec3, 3>> corner_weights;  ///< per triangle and corner: barycentric in that triangle

  /// A place on a small triangle as one on the given surface.
  SurfacePlace on_given(const SurfacePlace& place) const;
};

/// Longest wanted edge (m) at a point of the surface that is `darkness` dark.
using EdgeLimit = std::function<double(double darkness)>;

/// Halves edges, the longest first, until none is longer than wanted at its middle. Same input, same triangles.
RefinedSurface refine_surface(const Surface& surface, const EdgeLimit& limit);

}  // namespace lissom
