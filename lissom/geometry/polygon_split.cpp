#include <cmath>

#include "lissom/geometry/surface_reading.h"

namespace lissom {

namespace {

/// Twice the area, anticlockwise positive.
double doubled_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Newell's mean normal: the vector area of the polygon.
Vec3 vector_area(const std::vector<Vec3>& points, std::span<const int> corners) {
  Vec3 sum = Vec3::Zero();
  const Vec3& origin = points[corners[0]];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += (points[corners[i]] - origin).cross(points[corners[i + 1]] - origin);
  }
  return sum;
}

std::vector<Vec2> flattened(const std::vector<Vec3>& points, std::span<const int> corners, const Vec3& normal) {
  const Vec3 along = normal.unitOrthogonal(), across = normal.normalized().cross(along);
  std::vector<Vec2> flat;
  for (const int c : corners) {
    const Vec3 from = points[c] - points[corners[0]];
    flat.emplace_back(along.dot(from), across.dot(from));
  }
  return flat;
}

/// Whether the corner at `at` of the ring sticks out and no other corner of the ring lies in its triangle.
bool is_ear(const std::vector<Vec2>& flat, const std::vector<int>& ring, std::size_t at) {
  const std::size_t n = ring.size(), before = (at + n - 1) % n, after = (at + 1) % n;
  const Vec2 &a = flat[ring[before]], &b = flat[ring[at]], &c = flat[ring[after]];
  if (!(doubled_area(a, b, c) > 1e-12 * (c - a).squaredNorm())) return false;
  for (std::size_t i = 0; i < n; ++i) {
    if (i == before || i == at || i == after) continue;
    const Vec2& p = flat[ring[i]];
    if (p == a || p == b || p == c) continue;
    if (doubled_area(a, b, p) >= 0 && doubled_area(b, c, p) >= 0 && doubled_area(c, a, p) >= 0) return false;
  }
  return true;
}

/// Along the shorter diagonal, unless a triangle would fold back there.
void split_quadrilateral(const std::vector<Vec3>& points, std::span<const int> q,
                         std::vector<std::array<int, 3>>& triangles) {
  const auto normal = [&](int a, int b, int c) { return (points[b] - points[a]).cross(points[c] - points[a]); };
  const double from_first = normal(q[0], q[1], q[2]).dot(normal(q[0], q[2], q[3]));
  const double from_second = normal(q[1], q[2], q[3]).dot(normal(q[1], q[3], q[0]));
  const bool shorter = (points[q[2]] - points[q[0]]).squaredNorm() <= (points[q[3]] - points[q[1]]).squaredNorm();
  const bool first = (from_first > 0) != (from_second > 0) ? from_first > 0 : shorter;
  if (first) {
    triangles.push_back({q[0], q[1], q[2]});
    triangles.push_back({q[0], q[2], q[3]});
  } else {
    triangles.push_back({q[1], q[2], q[3]});
    triangles.push_back({q[1], q[3], q[0]});
  }
}

}  // namespace

void split_polygon(const std::vector<Vec3>& points, std::span<const int> corners,
                   std::vector<std::array<int, 3>>& triangles) {
  if (corners.size() == 3) {
    triangles.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  if (corners.size() == 4) return split_quadrilateral(points, corners, triangles);
  const Vec3 normal = vector_area(points, corners);
  const bool plane = std::isfinite(normal.squaredNorm()) && normal.squaredNorm() > 0;
  const std::vector<Vec2> flat = plane ? flattened(points, corners, normal) : std::vector<Vec2>();
  std::vector<int> ring(corners.size());
  for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = static_cast<int>(i);
  std::size_t at = 1;
  while (ring.size() > 3) {
    // Where no ear is left (the polygon crosses itself, or has no area) any
    // corner has to do; repair looks at the result.
    std::size_t tried = 0;
    while (plane && tried < ring.size() && !is_ear(flat, ring, at % ring.size())) ++at, ++tried;
    at %= ring.size();
    const std::size_t n = ring.size();
    triangles.push_back({corners[ring[(at + n - 1) % n]], corners[ring[at]], corners[ring[(at + 1) % n]]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at));
  }
  triangles.push_back({corners[ring[0]], corners[ring[1]], corners[ring[2]]});
}

}  // namespace lissom
