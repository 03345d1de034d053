#include "lissom/geometry/surface_boundary.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lissom/geometry/surface_note.h"
#include "lissom/geometry/surface_topology.h"

namespace lissom {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

int begin_vertex(const Surface& surface, const BoundaryEdge& e) {
  return surface.triangles[at(e.triangle)][at(e.edge)];
}
int end_vertex(const Surface& surface, const BoundaryEdge& e) {
  return surface.triangles[at(e.triangle)][at((e.edge + 1) % 3)];
}

Vec3 weights_on(const BoundaryEdge& e, double t) {
  Vec3 weights = Vec3::Zero();
  weights[e.edge] = 1 - t;
  weights[(e.edge + 1) % 3] = t;
  return weights;
}

/// A joint on a loop: how many of its edges come before, and how far along the next one.
struct Mark {
  double along = 0;
  int joint = -1;
};

/// Where on the loop a place lies; negative when elsewhere.
double along_loop(const BoundaryLoop& loop, const SurfacePlace& place) {
  for (std::size_t k = 0; k < loop.size(); ++k) {
    if (loop[k].triangle != place.triangle) continue;
    if (std::abs(place.weights[(loop[k].edge + 2) % 3]) > 1e-9) continue;
    return static_cast<double>(k) + std::clamp(place.weights[(loop[k].edge + 1) % 3], 0.0, 1.0);
  }
  return -1;
}

/// Loop edges from one mark to another, around the end if need be.
SurfacePath path_between(const BoundaryLoop& loop, double from, double to) {
  const auto count = static_cast<double>(loop.size());
  if (to <= from) to += count;
  SurfacePath path;
  while (from < to) {
    const double floor = std::floor(from), end = std::min(floor + 1, to);
    const BoundaryEdge& edge = loop[static_cast<std::size_t>(std::fmod(floor, count))];
    path.push_back({edge.triangle, weights_on(edge, from - floor), weights_on(edge, end - floor)});
    from = end;
  }
  return path;
}

/// Vertices at which the loop turns sharply become joints.
void add_corners(const Surface& surface, const BoundaryLoop& loop, double corner, SurfaceNetwork& network,
                 std::vector<Mark>& marks) {
  const auto direction = [&](const BoundaryEdge& e) {
    return (surface.vertices[at(end_vertex(surface, e))] - surface.vertices[at(begin_vertex(surface, e))]).normalized();
  };
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const BoundaryEdge& before = loop[(k + loop.size() - 1) % loop.size()];
    if (direction(before).dot(direction(loop[k])) >= std::cos(corner)) continue;
    const auto here = static_cast<double>(k);
    const auto taken = std::find_if(marks.begin(), marks.end(), [&](const Mark& m) {
      return std::abs(m.along - here) < 1e-9 || std::abs(m.along - here - static_cast<double>(loop.size())) < 1e-9;
    });
    if (taken != marks.end()) {
      network.joints[at(taken->joint)].kind = SurfaceJoint::Kind::kCorner;
      continue;
    }
    marks.push_back({here, static_cast<int>(network.joints.size())});
    network.joints.push_back({{loop[k].triangle, weights_on(loop[k], 0)}, SurfaceJoint::Kind::kCorner});
  }
}

}  // namespace

std::vector<BoundaryLoop> boundary_loops(const Surface& surface) {
  std::vector<std::vector<int>> rims = rim_loops(surface.triangles, side_mates(surface.triangles));
  for (std::vector<int>& rim : rims) std::rotate(rim.begin(), std::min_element(rim.begin(), rim.end()), rim.end());
  std::sort(rims.begin(), rims.end());
  std::vector<BoundaryLoop> loops;
  for (const std::vector<int>& rim : rims) {
    BoundaryLoop& loop = loops.emplace_back();
    for (const int side : rim) loop.push_back({side / 3, side % 3});
  }
  return loops;
}

SurfacePlace nearest_on_boundary(const Surface& surface, const std::vector<BoundaryLoop>& loops, const Vec3& x) {
  SurfacePlace nearest;
  double best = std::numeric_limits<double>::infinity();
  for (const BoundaryLoop& loop : loops) {
    for (const BoundaryEdge& e : loop) {
      const Vec3 &a = surface.vertices[at(begin_vertex(surface, e))], &b = surface.vertices[at(end_vertex(surface, e))];
      const double t = std::clamp((x - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
      if (const double d = (a + t * (b - a) - x).squaredNorm(); d < best) {
        best = d;
        nearest = {e.triangle, weights_on(e, t)};
      }
    }
  }
  return nearest;
}

Status add_boundary_lines(const Surface& surface, double corner, SurfaceNetwork& network, const std::string& where) {
  const int given = static_cast<int>(network.joints.size());
  for (const BoundaryLoop& loop : boundary_loops(surface)) {
    std::vector<Mark> marks;
    for (int j = 0; j < given; ++j) {
      if (network.joints[at(j)].kind == SurfaceJoint::Kind::kInside) continue;
      if (const double along = along_loop(loop, network.joints[at(j)].place); along >= 0) marks.push_back({along, j});
    }
    add_corners(surface, loop, corner, network, marks);
    std::sort(marks.begin(), marks.end(), [](const Mark& a, const Mark& b) { return a.along < b.along; });
    if (marks.size() < 2) {
      return Error{ErrorCode::kGeometry, where,
                   "the boundary at " + in_millimetres(surface.vertices[at(begin_vertex(surface, loop[0]))]) +
                       " meets fewer than two lines",
                   "close the hole, or ask for more cells"};
    }
    for (std::size_t k = 0; k < marks.size(); ++k) {
      const Mark &from = marks[k], &to = marks[(k + 1) % marks.size()];
      network.lines.push_back({{from.joint, to.joint}, path_between(loop, from.along, to.along), true, {}});
    }
  }
  return {};
}

}  // namespace lissom
