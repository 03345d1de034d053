#include "lissom/geometry/surface_locate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lissom/core/assert.h"
#include "lissom/geometry/triangle_point.h"

namespace lissom {

namespace {

constexpr double kReach = 0.75;  // of the distance of two places: how far about their middle a path may run

std::size_t at(int i) { return static_cast<std::size_t>(i); }

const Vec3& corner_of(const Surface& surface, int triangle, int i) {
  return surface.vertices[at(surface.triangles[at(triangle)][at(i % 3)])];
}

/// Everything connected to a triangle that touches a ball.
std::vector<int> connected_in_ball(const Surface& surface, const std::vector<int>& mates, int first, const Vec3& centre,
                                   double radius) {
  std::vector<int> found{first};
  std::vector<char> seen(surface.triangles.size(), 0);
  seen[at(first)] = 1;
  for (std::size_t k = 0; k < found.size(); ++k) {
    for (int i = 0; i < 3; ++i) {
      const int mate = mates[at(3 * found[k] + i)], next = mate / 3;
      if (mate < 0 || seen[at(next)] != 0) continue;
      seen[at(next)] = 1;
      const Vec3 w = nearest_in_triangle(corner_of(surface, next, 0), corner_of(surface, next, 1),
                                         corner_of(surface, next, 2), centre);
      if ((position(surface, {next, w}) - centre).norm() < radius) found.push_back(next);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

SurfacePlace nearest_place(const Surface& surface, const Vec3& x, const std::optional<Vec3>& normal) {
  SurfacePlace nearest;
  double best = std::numeric_limits<double>::infinity();
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    if (normal && area_vector(surface, t).dot(*normal) <= 0) continue;
    const Vec3 w = nearest_in_triangle(corner_of(surface, t, 0), corner_of(surface, t, 1), corner_of(surface, t, 2), x);
    const double distance = (position(surface, {t, w}) - x).squaredNorm();
    if (distance >= best) continue;
    best = distance;
    nearest = {t, w};
  }
  return nearest.triangle >= 0 || !normal ? nearest : nearest_place(surface, x);
}

std::vector<int> triangles_near(const Surface& surface, const std::vector<int>& mates, const SurfacePlace& from,
                                const SurfacePlace& to) {
  const Vec3 a = position(surface, from), b = position(surface, to), middle = 0.5 * (a + b);
  std::vector<int> found;
  for (double radius = kReach * (b - a).norm(); true; radius *= 1.5) {
    found = connected_in_ball(surface, mates, from.triangle, middle, radius);
    if (std::binary_search(found.begin(), found.end(), to.triangle)) return found;
    if (radius > 1e3 * (b - a).norm() || found.size() == surface.triangles.size()) break;
  }
  found.push_back(to.triangle);
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Vec3> vertex_normals(const Surface& surface) {
  std::vector<Vec3> normals(surface.vertices.size(), Vec3::Zero());
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    const Vec3 normal = area_vector(surface, t).normalized();
    for (int i = 0; i < 3; ++i) {
      const Vec3& x = corner_of(surface, t, i);
      const Vec3 to_next = (corner_of(surface, t, i + 1) - x).normalized();
      const Vec3 to_last = (corner_of(surface, t, i + 2) - x).normalized();
      normals[at(surface.triangles[at(t)][at(i)])] += std::acos(std::clamp(to_next.dot(to_last), -1.0, 1.0)) * normal;
    }
  }
  for (Vec3& normal : normals) normal.normalize();
  return normals;
}

Vec3 smooth_normal(const Surface& surface, const std::vector<Vec3>& vertex_normals, const SurfacePlace& place) {
  Vec3 normal = Vec3::Zero();
  for (int i = 0; i < 3; ++i)
    normal += place.weights[i] * vertex_normals[at(surface.triangles[at(place.triangle)][at(i)])];
  if (normal.norm() < 1e-6) normal = area_vector(surface, place.triangle);
  return normal.normalized();
}

}  // namespace lissom
