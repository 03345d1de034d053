#include "lissom/view/solid_surface.h"

#include "lissom/geometry/tetrahedron_faces.h"

namespace lissom {

SolidSurface surface_of(const Structure& structure, const StructureSolid& solid) {
  std::vector<std::array<int, 4>> tetrahedra;
  for (int t = 0; t < solid.tetrahedra; ++t) {
    tetrahedra.push_back(structure.tetrahedra[solid.first_tetrahedron + t].node);
  }
  SolidSurface surface;
  surface.triangles = outer_faces(tetrahedra);
  std::vector<int> number(structure.nodes.size(), -1);
  for (std::array<int, 3>& triangle : surface.triangles) {
    for (int& corner : triangle) {
      if (number[corner] < 0) {
        number[corner] = static_cast<int>(surface.nodes.size());
        surface.nodes.push_back(corner);
      }
      corner = number[corner];
    }
  }
  return surface;
}

}  // namespace lissom
