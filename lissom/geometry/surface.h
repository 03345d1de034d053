#pragma once
/// A surface in space as a value: what files hold, what is mended, what rods are laid on.

#include <array>
#include <vector>

#include "lissom/core/types.h"

namespace lissom {

struct Surface {
  std::vector<Vec3> vertices;                 ///< m, (n x 3)
  std::vector<std::array<int, 3>> triangles;  ///< (t x 3), anticlockwise seen from outside
  /// Per vertex, or empty: how dark the surface is painted, 0 (white) to 1 (black). From vertex colours or a texture.
  std::vector<double> darkness;
};

/// A point of a surface: corners of a triangle, weighted.
struct SurfacePlace {
  int triangle = -1;
  Vec3 weights = Vec3::Zero();  ///< barycentric, sum 1
};

inline Vec3 position(const Surface& surface, const SurfacePlace& place) {
  Vec3 x = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    x += place.weights[i] *
         surface.vertices[static_cast<std::size_t>(
             surface.triangles[static_cast<std::size_t>(place.triangle)][static_cast<std::size_t>(i)])];
  }
  return x;
}

/// Corner b minus a cross c minus a: its length is twice the area (m^2).
inline Vec3 area_vector(const Surface& surface, int triangle) {
  const std::array<int, 3>& corner = surface.triangles[static_cast<std::size_t>(triangle)];
  const Vec3& a = surface.vertices[static_cast<std::size_t>(corner[0])];
  return (surface.vertices[static_cast<std::size_t>(corner[1])] - a)
      .cross(surface.vertices[static_cast<std::size_t>(corner[2])] - a);
}

}  // namespace lissom
