#include "lissom/fabrication/self_intersection.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace lissom {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

constexpr int kSlabs = 16;

/// Triangles that reach into the slabs of equal numbers of triangles along x. Two that intersect are in one slab.
std::vector<std::vector<Mesh::Face_index>> slabs_of(const Surface& surface) {
  const auto x = [&](const std::array<int, 3>& t, int k) { return surface.vertices[t[k]].x(); };
  std::vector<double> middles;
  for (const std::array<int, 3>& t : surface.triangles) middles.push_back(x(t, 0));
  std::sort(middles.begin(), middles.end());
  std::vector<double> border{-std::numeric_limits<double>::infinity()};
  for (int s = 1; s < kSlabs; ++s) border.push_back(middles[middles.size() * s / kSlabs]);
  std::vector<std::vector<Mesh::Face_index>> slabs(kSlabs);
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    const std::array<int, 3>& t = surface.triangles[f];
    const double low = std::min({x(t, 0), x(t, 1), x(t, 2)}), high = std::max({x(t, 0), x(t, 1), x(t, 2)});
    for (int s = 0; s < kSlabs; ++s) {
      const bool before_end = s + 1 == kSlabs || low <= border[s + 1];
      if (before_end && high >= border[s]) slabs[s].emplace_back(static_cast<Mesh::size_type>(f));
    }
  }
  return slabs;
}

using FacePair = std::pair<Mesh::Face_index, Mesh::Face_index>;

}  // namespace

std::optional<Vec3> self_intersection(const Surface& surface, const Context& context) {
  Mesh mesh;
  mesh.reserve(static_cast<Mesh::size_type>(surface.vertices.size()),
               static_cast<Mesh::size_type>(surface.triangles.size() * 3 / 2),
               static_cast<Mesh::size_type>(surface.triangles.size()));
  for (const Vec3& x : surface.vertices) mesh.add_vertex(Kernel::Point_3(x.x(), x.y(), x.z()));
  for (const std::array<int, 3>& t : surface.triangles) {
    mesh.add_face(Mesh::Vertex_index(static_cast<Mesh::size_type>(t[0])),
                  Mesh::Vertex_index(static_cast<Mesh::size_type>(t[1])),
                  Mesh::Vertex_index(static_cast<Mesh::size_type>(t[2])));
  }
  const std::vector<std::vector<Mesh::Face_index>> slabs = slabs_of(surface);
  std::vector<std::vector<FacePair>> found(kSlabs);
  parallel_for(context.threads, kSlabs, 1, [&](int begin, int end) {
    for (int s = begin; s < end; ++s) {
      CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(
          slabs[s], mesh, std::back_inserter(found[s]), CGAL::parameters::maximum_number(1));
    }
  });
  for (const std::vector<FacePair>& pairs : found) {
    if (pairs.empty()) continue;
    const std::array<int, 3>& t = surface.triangles[static_cast<Mesh::size_type>(pairs.front().first)];
    return Vec3((surface.vertices[t[0]] + surface.vertices[t[1]] + surface.vertices[t[2]]) / 3);
  }
  return std::nullopt;
}

}  // namespace lissom
