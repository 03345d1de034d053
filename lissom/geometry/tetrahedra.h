#pragma once
/// Fills closed surfaces with tetrahedra: Delaunay refinement, then removal of flat ones [Jamin, Alliez, Yvinec, Boissonnat
/// 2015, CGAL Mesh_3]. Same input, same bytes.

#include <array>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/geometry/surface.h"

namespace lissom {

struct TetrahedralMesh {
  std::vector<Vec3> points;  ///< m, (n x 3); each belongs to a tetrahedron
  /// (t x 4), corners a, b, c, d with (b - a) x (c - a) towards d.
  std::vector<std::array<int, 4>> tetrahedra;
};

struct TetrahedralOptions {
  double cell_size = 0;        ///< m, largest radius of the sphere through the corners of a tetrahedron: about its side
  double facet_size = 0;       ///< m, the same of a triangle of the outer surface; 0: as cell_size
  double facet_distance = 0;   ///< m, largest distance from these triangles to the surface; 0: a tenth of cell_size
  double facet_angle = 0.436;  ///< rad, least angle of these triangles; refinement may not end above 30 degrees
  double edge_ratio = 2;       ///< largest radius of that sphere over the shortest side; may not end below 2
  int most_tetrahedra = 200'000;  ///< refused when the volume needs about more than that

  Status validate() const;
};

/// Errors, with the place in mm: numbers that are not finite, no triangle, an edge with one triangle (a hole) or with more than
/// two, neighbours that are turned differently, a surface that holds no volume, options that cannot be met.
Result<TetrahedralMesh> fill_surface(const Surface& surface, const TetrahedralOptions& options);

}  // namespace lissom
