#include "lissom/geometry/planar_mesh.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_no_edge_refinement_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/spatial_sort.h>
#include <algorithm>
#include <cmath>
#include <exception>
#include <fmt/format.h>
#include <numbers>

#include "lissom/geometry/planar_smoothing.h"

namespace lissom {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
/// Of a vertex; those that the mesher adds have none yet.
struct Number {
  int value = -1;
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Number, Kernel>;
using FaceBase = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_tag>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;
using Mesher = CGAL::Delaunay_mesher_no_edge_refinement_2<Triangulation, Criteria>;
using Point = Kernel::Point_2;
using Vertex = Triangulation::Vertex_handle;
using Face = Triangulation::Face_handle;

constexpr double kMostAngle = std::numbers::pi / 6;  // circumcentres come no nearer than the shortest edge up to here
constexpr double kLongest = 1.5;                     // longest edge by the mean one, measured: 1.45 to 1.55
constexpr int kRounds = 4;                           // of smoothing, each followed by a new Delaunay triangulation

Error refuse(const std::string& where, std::string message, std::string hint) {
  return {ErrorCode::kGeometry, where, std::move(message), std::move(hint)};
}

/// A constrained Delaunay triangulation of numbered points.
class Mesh {
 public:
  explicit Mesh(const PlanarRegion& region, const std::string& where) : region_(region), where_(where) {}

  /// Replaces the triangulation by that of `points`, of which the first are those of the region.
  Status triangulate(const std::vector<Vec2>& points) {
    triangulation_.clear();
    std::vector<Point> places;
    std::vector<std::ptrdiff_t> order(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      places.emplace_back(points[i].x(), points[i].y());
      order[i] = static_cast<std::ptrdiff_t>(i);
    }
    CGAL::spatial_sort(order.begin(), order.end(),
                       CGAL::Spatial_sort_traits_adapter_2<Kernel, const Point*>(places.data()));
    std::vector<Vertex> vertices(points.size());
    Face near;
    for (const std::ptrdiff_t place : order) {
      const auto i = static_cast<std::size_t>(place);
      const std::size_t before = triangulation_.number_of_vertices();
      const Vertex vertex = triangulation_.insert(places[i], near);
      if (triangulation_.number_of_vertices() == before) {
        const auto [first, second] = std::minmax({vertex->info().value, static_cast<int>(i)});
        return refuse(where_, fmt::format("points {} and {} are at the same place", first, second),
                      "remove one of them");
      }
      vertex->info().value = static_cast<int>(i);
      vertices[i] = vertex;
      near = vertex->face();
    }
    for (std::size_t k = 0; k < region_.segments.size(); ++k) {
      const auto [a, b] = region_.segments[k];
      triangulation_.insert_constraint(vertices[static_cast<std::size_t>(a)], vertices[static_cast<std::size_t>(b)]);
    }
    for (std::size_t k = 0; k < region_.segments.size(); ++k) {
      const auto [a, b] = region_.segments[k];
      if (triangulation_.is_edge(vertices[static_cast<std::size_t>(a)], vertices[static_cast<std::size_t>(b)]))
        continue;
      return refuse(where_, fmt::format("the segment from point {} to point {} runs through another point", a, b),
                    "make it a point of the line as well");
    }
    return mark();
  }

  /// Adds inner points until the triangles are small and round enough; returns all points.
  std::vector<Vec2> refine() {
    const double sine = std::sin(std::min(region_.min_angle, kMostAngle));
    Mesher mesher(triangulation_, Criteria(sine * sine, kLongest * region_.edge_length));
    mesher.init(true);
    mesher.refine_mesh();
    std::vector<Vec2> points = region_.points;
    for (const Vertex vertex : triangulation_.finite_vertex_handles()) {
      if (vertex->info().value >= 0) continue;
      vertex->info().value = static_cast<int>(points.size());
      points.emplace_back(vertex->point().x(), vertex->point().y());
    }
    return points;
  }

  std::vector<std::array<int, 3>> triangles() const {
    std::vector<std::array<int, 3>> list;
    for (const Face face : triangulation_.finite_face_handles()) {
      if (!face->is_in_domain()) continue;
      list.push_back({number(face, 0), number(face, 1), number(face, 2)});
    }
    return list;
  }

 private:
  static int number(Face face, int corner) { return face->vertex(corner)->info().value; }

  /// Spreads `mark` from a face over everything that `wall(face, side)` does not bound.
  template <class Wall>
  static void spread(Face start, bool mark, const Wall& wall) {
    std::vector<Face> open{start};
    start->set_in_domain(mark);
    while (!open.empty()) {
      const Face face = open.back();
      open.pop_back();
      for (int side = 0; side < 3; ++side) {
        const Face next = face->neighbor(side);
        if (next->is_in_domain() == mark || wall(face, side)) continue;
        next->set_in_domain(mark);
        open.push_back(next);
      }
    }
  }

  /// The region: what the outline keeps from the outside, without the holes.
  Status mark() {
    std::vector<std::array<int, 2>> outline;
    for (const int k : region_.outline) {
      auto [a, b] = region_.segments[static_cast<std::size_t>(k)];
      outline.push_back({std::min(a, b), std::max(a, b)});
    }
    std::sort(outline.begin(), outline.end());
    for (const Face face : triangulation_.all_face_handles()) face->set_in_domain(true);
    spread(triangulation_.infinite_face(), false, [&](Face face, int side) {
      if (!face->is_constrained(side)) return false;
      const int a = number(face, Triangulation::cw(side)), b = number(face, Triangulation::ccw(side));
      return std::binary_search(outline.begin(), outline.end(), std::array<int, 2>{std::min(a, b), std::max(a, b)});
    });
    if (empty()) return refuse(where_, "the outline encloses nothing", "close a loop around the fabric");
    for (std::size_t i = 0; i < region_.holes.size(); ++i) {
      const Face face = triangulation_.locate(Point(region_.holes[i].x(), region_.holes[i].y()));
      if (!face->is_in_domain()) {
        return refuse(fmt::format("{}/holes/{}", where_, i), "the hole lies outside of the outline or in another hole",
                      "move its point into the opening, or remove it");
      }
      spread(face, false, [](Face at, int side) { return at->is_constrained(side); });
    }
    if (empty()) return refuse(where_, "nothing of the fabric is left between its holes", "remove a hole");
    return {};
  }

  bool empty() const {
    for (const Face face : triangulation_.finite_face_handles()) {
      if (face->is_in_domain()) return false;
    }
    return true;
  }

  const PlanarRegion& region_;
  const std::string& where_;
  Triangulation triangulation_;
};

Status check_numbers(const PlanarRegion& region, const std::string& where) {
  for (std::size_t i = 0; i < region.points.size(); ++i) {
    if (region.points[i].allFinite()) continue;
    return Error{ErrorCode::kRange, where, fmt::format("point {} is not a finite number", i), "give two numbers"};
  }
  if (region.points.size() < 3 || region.outline.size() < 3) {
    return refuse(where, "the outline has fewer than three segments", "close it around an area");
  }
  if (!(region.edge_length > 0) || !std::isfinite(region.edge_length)) {
    return Error{ErrorCode::kRange, where, fmt::format("the edge length is {:g} m", region.edge_length),
                 "give a positive number"};
  }
  Vec2 low = region.points[0], high = low;
  for (const Vec2& p : region.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double cells = (high - low).prod() / (0.4 * region.edge_length * region.edge_length);
  if (cells <= kMostTriangles) return {};
  return Error{ErrorCode::kRange, where, fmt::format("the region would be cut into {:.2g} triangles", cells),
               fmt::format("use longer edges: at most {} triangles", kMostTriangles)};
}

Result<PlanarMesh> make_mesh(const PlanarRegion& region, const std::string& where) {
  Mesh mesh(region, where);
  PlanarMesh out;
  if (Status s = mesh.triangulate(region.points); !s) return s.error();
  out.points = mesh.refine();
  out.triangles = mesh.triangles();
  for (int round = 0; round < kRounds && out.points.size() > region.points.size(); ++round) {
    even_out(out.points, region.points.size(), out.triangles);
    if (Status s = mesh.triangulate(out.points); !s) return s.error();
    out.triangles = mesh.triangles();
  }
  open_worst_angles(out.points, region.points.size(), out.triangles, region.min_angle);
  out.smallest_angle = std::numbers::pi;
  for (std::size_t t = 0; t < out.triangles.size(); ++t) {
    const auto& [a, b, c] = out.triangles[t];
    const double angle =
        smallest_angle(out.points[static_cast<std::size_t>(a)], out.points[static_cast<std::size_t>(b)],
                       out.points[static_cast<std::size_t>(c)]);
    if (angle >= out.smallest_angle) continue;
    out.smallest_angle = angle;
    out.worst_triangle = static_cast<int>(t);
  }
  return out;
}

}  // namespace

Result<PlanarMesh> mesh_planar_region(const PlanarRegion& region, const std::string& where) {
  if (Status s = check_numbers(region, where); !s) return s.error();
  try {
    return make_mesh(region, where);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return refuse(where, "two segments of the region cross or lie on each other", "let them meet at a common point");
  } catch (const std::exception& e) {
    return refuse(where, fmt::format("the region cannot be triangulated: {}", e.what()), "simplify it");
  }
}

}  // namespace lissom
