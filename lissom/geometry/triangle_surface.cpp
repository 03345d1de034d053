#include "lissom/geometry/triangle_surface.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <cmath>
#include <map>
#include <utility>

namespace lissom {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Places = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Places::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

/// Where on a triangle its nearest point lies: 0 inside, 1 on the edge from corner `at` to the next, 2 at corner `at`.
struct OnTriangle {
  Vec3 point = Vec3::Zero();
  int kind = 0, at = 0;
};

OnTriangle nearest_on(const std::array<Vec3, 3>& x, const Vec3& p) {
  // Inside the prism over the triangle?
  const Vec3 normal = (x[1] - x[0]).cross(x[2] - x[0]);
  bool inside = true;
  for (int i = 0; i < 3; ++i) inside = inside && normal.cross(x[(i + 1) % 3] - x[i]).dot(p - x[i]) >= 0;
  if (inside) return {p - normal * (normal.dot(p - x[0]) / normal.squaredNorm()), 0, 0};
  OnTriangle best;
  double least = INFINITY;
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3;
    const Vec3 edge = x[next] - x[i];
    const double s = edge.dot(p - x[i]) / edge.squaredNorm();
    const OnTriangle own = s <= 0   ? OnTriangle{x[i], 2, i}
                           : s >= 1 ? OnTriangle{x[next], 2, next}
                                    : OnTriangle{x[i] + s * edge, 1, i};
    const double distance = (p - own.point).squaredNorm();
    if (distance < least) {
      least = distance;
      best = own;
    }
  }
  return best;
}

}  // namespace

class TriangleSurface::Search {
 public:
  Search(const std::vector<Vec3>& vertices, const std::vector<std::array<int, 3>>& triangles) {
    const auto point = [&](int v) { return Kernel::Point_3(vertices[v].x(), vertices[v].y(), vertices[v].z()); };
    places_.reserve(triangles.size());
    for (const auto& t : triangles) places_.emplace_back(point(t[0]), point(t[1]), point(t[2]));
    tree_.insert(places_.cbegin(), places_.cend());
    tree_.build();
    tree_.accelerate_distance_queries();
  }
  int triangle(const Vec3& p) const {
    const auto found = tree_.closest_point_and_primitive(Kernel::Point_3(p.x(), p.y(), p.z()));
    return static_cast<int>(found.second - places_.cbegin());
  }

 private:
  Places places_;
  Tree tree_;
};

Result<TriangleSurface> TriangleSurface::make(std::vector<Vec3> vertices, std::vector<std::array<int, 3>> triangles,
                                              const std::string& where) {
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (vertices[v].allFinite()) continue;
    return Error{ErrorCode::kRange, where + "/vertices/" + std::to_string(v), "a coordinate is not finite",
                 "give three numbers"};
  }
  if (triangles.empty()) {
    return Error{ErrorCode::kGeometry, where, "the surface has no triangles", "give at least one"};
  }
  TriangleSurface surface;
  surface.corner_normals_.assign(vertices.size(), Vec3::Zero());
  std::map<std::array<int, 2>, Vec3> by_edge;
  const auto key = [](int a, int b) { return std::array<int, 2>{std::min(a, b), std::max(a, b)}; };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const std::array<int, 3>& own = triangles[t];
    const std::string place = where + "/triangles/" + std::to_string(t);
    for (const int v : own) {
      if (v >= 0 && v < static_cast<int>(vertices.size())) continue;
      return Error{ErrorCode::kRange, place, "there is no vertex " + std::to_string(v),
                   "number vertices from 0 to " + std::to_string(static_cast<int>(vertices.size()) - 1)};
    }
    const std::array<Vec3, 3> side = {vertices[own[1]] - vertices[own[0]], vertices[own[2]] - vertices[own[1]],
                                      vertices[own[0]] - vertices[own[2]]};
    const Vec3 twice = side[0].cross(side[1]);
    const double longest = std::max({side[0].squaredNorm(), side[1].squaredNorm(), side[2].squaredNorm()});
    if (!(twice.norm() > 1e-10 * longest)) {
      return Error{ErrorCode::kGeometry, place, "the triangle has no area", "leave it out"};
    }
    const Vec3 normal = twice.normalized();
    surface.normals_.push_back(normal);
    for (int i = 0; i < 3; ++i) {
      by_edge.try_emplace(key(own[i], own[(i + 1) % 3]), Vec3::Zero()).first->second += normal;
      const Vec3 &ahead = side[i], back = -side[(i + 2) % 3];
      surface.corner_normals_[own[i]] += std::atan2(ahead.cross(back).norm(), ahead.dot(back)) * normal;
    }
  }
  // Where normals cancel, as on both sides of a sheet folded flat, that of the triangle has to do.
  const auto unit_or = [](const Vec3& sum, const Vec3& other) {
    return sum.norm() > 1e-9 ? Vec3(sum.normalized()) : other;
  };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    std::array<Vec3, 3> edges;
    for (int i = 0; i < 3; ++i) {
      edges[i] = unit_or(by_edge.at(key(triangles[t][i], triangles[t][(i + 1) % 3])), surface.normals_[t]);
    }
    surface.edge_normals_.push_back(edges);
    for (const int v : triangles[t]) {
      surface.corner_normals_[v] = unit_or(surface.corner_normals_[v], surface.normals_[t]);
    }
  }
  surface.search_ = std::make_shared<const Search>(vertices, triangles);
  surface.vertices_ = std::move(vertices);
  surface.triangles_ = std::move(triangles);
  return surface;
}

NearestPoint TriangleSurface::nearest(const Vec3& p) const {
  NearestPoint found;
  found.triangle = search_->triangle(p);
  const std::array<int, 3>& own = triangles_[found.triangle];
  const Vec3& normal = normals_[found.triangle];
  const OnTriangle on = nearest_on({vertices_[own[0]], vertices_[own[1]], vertices_[own[2]]}, p);
  found.point = on.point;
  found.normal = on.kind == 0   ? normal
                 : on.kind == 1 ? edge_normals_[found.triangle][on.at]
                                : corner_normals_[own[on.at]];
  // Over an edge between two triangles of a plane, or at the surface itself, there is no wedge to be in.
  const Vec3 away = p - on.point, along = away - normal * normal.dot(away);
  if (on.kind == 0 || along.norm() <= 1e-9 * away.norm()) {
    found.across = normal * normal.transpose();
  } else if (on.kind == 1) {
    const Vec3 t = (vertices_[own[(on.at + 1) % 3]] - vertices_[own[on.at]]).normalized();
    found.across = Mat3::Identity() - t * t.transpose();
  } else {
    found.across = Mat3::Identity();
  }
  return found;
}

}  // namespace lissom
