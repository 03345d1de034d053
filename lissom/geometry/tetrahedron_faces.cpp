#include "lissom/geometry/tetrahedron_faces.h"

#include <algorithm>
#include <cstddef>

namespace lissom {

namespace {

/// Corners of the four faces, anticlockwise seen from outside.
constexpr std::array<std::array<std::size_t, 3>, 4> kFaces{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};

struct Face {
  std::array<int, 3> sorted;
  std::array<int, 3> corner;
  std::size_t place;
};

}  // namespace

std::vector<std::array<int, 3>> outer_faces(std::span<const std::array<int, 4>> tetrahedra) {
  std::vector<Face> faces;
  faces.reserve(4 * tetrahedra.size());
  for (const std::array<int, 4>& tetrahedron : tetrahedra) {
    for (const std::array<std::size_t, 3>& of : kFaces) {
      Face face{{}, {tetrahedron[of[0]], tetrahedron[of[1]], tetrahedron[of[2]]}, faces.size()};
      face.sorted = face.corner;
      std::sort(face.sorted.begin(), face.sorted.end());
      faces.push_back(face);
    }
  }
  const auto by_corners = [](const Face& a, const Face& b) {
    return a.sorted != b.sorted ? a.sorted < b.sorted : a.place < b.place;
  };
  std::sort(faces.begin(), faces.end(), by_corners);
  std::vector<Face> outer;
  for (std::size_t i = 0; i < faces.size();) {
    std::size_t end = i + 1;
    while (end < faces.size() && faces[end].sorted == faces[i].sorted) ++end;
    if (end == i + 1) outer.push_back(faces[i]);
    i = end;
  }
  std::sort(outer.begin(), outer.end(), [](const Face& a, const Face& b) { return a.place < b.place; });
  std::vector<std::array<int, 3>> triangles;
  triangles.reserve(outer.size());
  for (const Face& face : outer) triangles.push_back(face.corner);
  return triangles;
}

}  // namespace lissom
