#pragma once
/// From CGAL's surface meshes to ours. Knows no header of CGAL: only sources that use it include this.

#include <cstddef>

#include "lissom/geometry/surface.h"

namespace lissom {

/// Vertices and faces of a CGAL::Surface_mesh of triangles without garbage, in its order.
template <class Mesh>
Surface surface_of(const Mesh& mesh) {
  Surface surface;
  for (const auto vertex : mesh.vertices()) {
    const auto& x = mesh.point(vertex);
    surface.vertices.emplace_back(x.x(), x.y(), x.z());
  }
  for (const auto face : mesh.faces()) {
    std::array<int, 3> corner{};
    std::size_t i = 0;
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) {
      corner[i++] = static_cast<int>(static_cast<typename Mesh::size_type>(vertex));
    }
    surface.triangles.push_back(corner);
  }
  return surface;
}

}  // namespace lissom
