#include "lissom/geometry/surface_path.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <algorithm>
#include <unordered_map>

#include "lissom/core/assert.h"

namespace lissom {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Shortest = CGAL::Surface_mesh_shortest_path<Traits>;

constexpr double kNothing = 1e-12;  // barycentric weight
constexpr double kInside = 1e-6;    // least barycentric weight of the ends of a search

Vec3 point_in(const Surface& surface, int triangle, const Vec3& weights) {
  return position(surface, {triangle, weights});
}

double length_of(const Surface& surface, const SurfaceSegment& s) {
  return (point_in(surface, s.triangle, s.to) - point_in(surface, s.triangle, s.from)).norm();
}

/// A part of a surface as CGAL's mesh; faces and vertices of the mesh know the numbers that they have on the surface.
struct Patch {
  Mesh mesh;
  std::vector<int> triangle_of, vertex_of;
  std::unordered_map<int, int> face_of;

  Patch(const Surface& surface, std::span<const int> triangles) {
    std::unordered_map<int, Mesh::Vertex_index> added;
    for (const int triangle : triangles) {
      std::array<Mesh::Vertex_index, 3> corner;
      for (std::size_t i = 0; i < 3; ++i) {
        const int v = surface.triangles[static_cast<std::size_t>(triangle)][i];
        const auto [entry, fresh] = added.try_emplace(v);
        if (fresh) {
          const Vec3& x = surface.vertices[static_cast<std::size_t>(v)];
          entry->second = mesh.add_vertex({x[0], x[1], x[2]});
          vertex_of.push_back(v);
        }
        corner[i] = entry->second;
      }
      const Mesh::Face_index face = mesh.add_face(corner[0], corner[1], corner[2]);
      if (face == Mesh::null_face()) continue;  // touches the rest of the patch in a vertex only
      face_of[triangle] = static_cast<int>(triangle_of.size());
      triangle_of.push_back(triangle);
    }
  }

  /// Barycentric weights in CGAL's order of corners: from the source of the face's halfedge on.
  Traits::Barycentric_coordinates weights(const Surface& surface, const SurfacePlace& place) const {
    const std::array<int, 3> corners = turned(surface, place.triangle);
    // On edges and in corners the search looks to one side only, which at a boundary may be the outside, and a rounding away
    // from them it sees wedges that are too thin: it is told of places just inside.
    Vec3 w = place.weights;
    if (w.minCoeff() < kInside) w = (1 - 3 * kInside) * w.cwiseMax(0.0) + Vec3::Constant(kInside);
    return {w[corners[0]], w[corners[1]], w[corners[2]]};
  }

  /// Which corner of the surface's triangle is the first, second and third one of the face.
  std::array<int, 3> turned(const Surface& surface, int triangle) const {
    const Mesh::Face_index face(static_cast<Mesh::size_type>(face_of.at(triangle)));
    const std::array<int, 3>& corner = surface.triangles[static_cast<std::size_t>(triangle)];
    const int first = vertex_of[mesh.source(mesh.halfedge(face))];
    const int shift = static_cast<int>(std::find(corner.begin(), corner.end(), first) - corner.begin());
    return {shift, (shift + 1) % 3, (shift + 2) % 3};
  }
};

/// Where a path meets the triangulation: weights of at most three vertices, and the triangles that it may go on in.
struct Waypoint {
  std::vector<std::pair<int, double>> weights;
  std::vector<int> triangles;
};

/// What CGAL calls for each step of a path.
class Collector {
 public:
  Collector(const Surface& surface, const Patch& patch) : surface_(surface), patch_(patch) {}

  void operator()(Mesh::Halfedge_index edge, double at) {
    const int a = patch_.vertex_of[patch_.mesh.source(edge)], b = patch_.vertex_of[patch_.mesh.target(edge)];
    Waypoint& point = points.emplace_back();
    point.weights = {{a, 1 - at}, {b, at}};
    for (const Mesh::Halfedge_index side : {edge, patch_.mesh.opposite(edge)}) add_face(point, patch_.mesh.face(side));
  }

  void operator()(Mesh::Vertex_index vertex) {
    Waypoint& point = points.emplace_back();
    point.weights = {{patch_.vertex_of[vertex], 1.0}};
    for (const Mesh::Face_index face : patch_.mesh.faces_around_target(patch_.mesh.halfedge(vertex))) {
      add_face(point, face);
    }
  }

  void operator()(Mesh::Face_index face, const Traits::Barycentric_coordinates& weights) {
    const int triangle = patch_.triangle_of[face];
    const std::array<int, 3> turned = patch_.turned(surface_, triangle);
    Waypoint& point = points.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      if (weights[i] <= kNothing) continue;
      const auto corner = static_cast<std::size_t>(turned[i]);
      point.weights.emplace_back(surface_.triangles[static_cast<std::size_t>(triangle)][corner], weights[i]);
    }
    add_face(point, face);
  }

  std::vector<Waypoint> points;

 private:
  void add_face(Waypoint& point, Mesh::Face_index face) const {
    if (face != Mesh::null_face()) point.triangles.push_back(patch_.triangle_of[face]);
  }

  const Surface& surface_;
  const Patch& patch_;
};

/// Barycentric weights of a waypoint in a triangle; nothing when it is not a point of it.
std::optional<Vec3> weights_in(const Surface& surface, int triangle, const Waypoint& point) {
  const std::array<int, 3>& corner = surface.triangles[static_cast<std::size_t>(triangle)];
  Vec3 weights = Vec3::Zero();
  for (const auto& [vertex, weight] : point.weights) {
    const auto at = std::find(corner.begin(), corner.end(), vertex);
    if (at != corner.end()) weights[static_cast<int>(at - corner.begin())] = weight;
    if (at == corner.end() && weight > kNothing) return {};
  }
  return weights;
}

std::optional<SurfaceSegment> between(const Surface& surface, const Waypoint& a, const Waypoint& b) {
  for (const std::vector<int>* triangles : {&a.triangles, &b.triangles}) {
    for (const int triangle : *triangles) {
      const std::optional<Vec3> from = weights_in(surface, triangle, a), to = weights_in(surface, triangle, b);
      if (from && to) return SurfaceSegment{triangle, *from, *to};
    }
  }
  return {};
}

}  // namespace

double path_length(const Surface& surface, const SurfacePath& path) {
  double length = 0;
  for (const SurfaceSegment& s : path) length += length_of(surface, s);
  return length;
}

SurfacePath reversed(const SurfacePath& path) {
  SurfacePath back(path.rbegin(), path.rend());
  for (SurfaceSegment& s : back) std::swap(s.from, s.to);
  return back;
}

std::vector<SurfacePlace> sample_path(const Surface& surface, const SurfacePath& path, int edges) {
  LISSOM_ASSERT(!path.empty() && edges >= 1);
  const double step = path_length(surface, path) / edges;
  std::vector<SurfacePlace> places{{path.front().triangle, path.front().from}};
  double passed = 0;
  for (const SurfaceSegment& s : path) {
    const double length = length_of(surface, s);
    while (static_cast<int>(places.size()) < edges && static_cast<double>(places.size()) * step <= passed + length) {
      const double share = (static_cast<double>(places.size()) * step - passed) / length;
      places.push_back({s.triangle, s.from + share * (s.to - s.from)});
    }
    passed += length;
  }
  while (static_cast<int>(places.size()) <= edges) places.push_back({path.back().triangle, path.back().to});
  return places;
}

std::optional<SurfacePath> shortest_path(const Surface& surface, std::span<const int> patch, const SurfacePlace& from,
                                         const SurfacePlace& to) {
  const Patch part(surface, patch);
  if (part.face_of.count(from.triangle) == 0 || part.face_of.count(to.triangle) == 0) return {};
  Shortest search(part.mesh);
  const auto face = [&](int triangle) {
    return Mesh::Face_index(static_cast<Mesh::size_type>(part.face_of.at(triangle)));
  };
  search.add_source_point(face(to.triangle), part.weights(surface, to));
  Collector collector(surface, part);
  const auto found =
      search.shortest_path_sequence_to_source_points(face(from.triangle), part.weights(surface, from), collector);
  if (found.first < 0) return {};
  SurfacePath path;
  for (std::size_t i = 1; i < collector.points.size(); ++i) {
    const std::optional<SurfaceSegment> piece = between(surface, collector.points[i - 1], collector.points[i]);
    if (!piece) return {};
    if ((piece->to - piece->from).norm() > kNothing) path.push_back(*piece);
  }
  if (path.empty()) return {};
  if (path.front().triangle == from.triangle) path.front().from = from.weights;
  if (path.back().triangle == to.triangle) path.back().to = to.weights;
  return path;
}

}  // namespace lissom
