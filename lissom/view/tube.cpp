#include "lissom/view/tube.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lissom {
namespace {

constexpr double kKinkCosine = 0.82;  // 35 degrees

Vec3 unit_or(const Vec3& v, const Vec3& fallback) {
  const double length = v.norm();
  return length > 1e-300 ? Vec3(v / length) : fallback;
}

/// Strip with what the rings need per edge and per point.
struct Spine {
  std::vector<Vec3> t;               // unit, per edge
  std::vector<double> length;        // m, per edge
  std::vector<double> sign;          // +-1 per edge: frames continue without half turns
  std::vector<Vec3> slope0, slope1;  // derivative of the curve at both ends of each edge, times its length
  bool reversed = false;             // closed strip whose frames come back after a half turn
};

Spine make_spine(const RodStrip& s) {
  const int edges = s.edge_count();
  Spine spine;
  for (int e = 0; e < edges; ++e) {
    const Vec3 d = s.points[s.end_point(e)] - s.points[e];
    spine.length.push_back(d.norm());
    spine.t.push_back(unit_or(d, unit_or(s.b[e].cross(s.n[e]), Vec3::UnitX())));
    const double previous = e > 0 ? spine.sign.back() : 1;
    spine.sign.push_back(e > 0 && s.n[e].dot(s.n[e - 1]) < 0 ? -previous : previous);
  }
  spine.reversed = s.closed && spine.sign.back() * s.n.back().dot(s.n.front()) < 0;
  const auto slope = [&](int e, int other) {
    if (other < 0 || other >= edges || spine.t[e].dot(spine.t[other]) < kKinkCosine) {
      return Vec3(spine.t[e] * spine.length[e]);
    }
    const double l0 = spine.length[e], l1 = spine.length[other];
    return Vec3((spine.t[e] * l1 + spine.t[other] * l0) * (l0 / std::max(l0 + l1, 1e-300)));
  };
  const auto neighbour = [&](int e) { return s.closed ? (e + edges) % edges : e; };
  for (int e = 0; e < edges; ++e) {
    spine.slope0.push_back(slope(e, neighbour(e - 1)));
    spine.slope1.push_back(slope(e, neighbour(e + 1)));
  }
  return spine;
}

void set_axes(Ring& ring, const Vec3& tangent, const Vec3& n, const Vec3& fallback) {
  const Vec3 flat = n - tangent * tangent.dot(n);
  ring.n = flat.norm() > 1e-6 ? Vec3(flat.normalized()) : fallback;
  ring.b = ring.n.cross(tangent);
}

/// Ring at the point between two edges (either may be the same at a free end).
Ring point_ring(const RodStrip& s, const Spine& spine, int before, int after, double sign_after) {
  Ring ring;
  const Vec3 t = unit_or(spine.t[before] + spine.t[after], spine.t[before]);
  set_axes(ring, t, spine.sign[before] * s.n[before] + sign_after * s.n[after], spine.sign[before] * s.n[before]);
  ring.r_n = (s.r_n[before] + s.r_n[after]) / 2;
  ring.r_b = (s.r_b[before] + s.r_b[after]) / 2;
  ring.wall = s.wall.empty() ? 0 : (s.wall[before] + s.wall[after]) / 2;
  const Vec3 turn = spine.t[after] - spine.t[before];
  const double half_cosine = std::max(0.5, t.dot(spine.t[before]));
  if (turn.norm() > 1e-9) ring.mitre = turn.normalized() * (1 / half_cosine - 1);
  return ring;
}

/// Ring inside an edge, between the rings at its two points.
Ring inner_ring(const RodStrip& s, const Spine& spine, int e, double u, const Ring& first, const Ring& last) {
  Ring ring;
  const Vec3& p0 = s.points[e];
  const Vec3& p1 = s.points[s.end_point(e)];
  const double v = 1 - u;
  ring.centre = p0 * (v * v * (1 + 2 * u)) + p1 * (u * u * (1 + 2 * v)) + spine.slope0[e] * (u * v * v) -
                spine.slope1[e] * (u * u * v);
  const Vec3 velocity =
      (p1 - p0) * (6 * u * v) + spine.slope0[e] * (v * (1 - 3 * u)) + spine.slope1[e] * (u * (1 - 3 * v));
  const Vec3 own = spine.sign[e] * s.n[e];
  const bool first_half = u < 0.5;
  const double w = first_half ? 2 * u : 2 - 2 * u;  // 0 at the near end, 1 in the middle of the edge
  const Ring& end = first_half ? first : last;
  const Vec3 end_n = first_half || end.n.dot(own) >= 0 ? end.n : Vec3(-end.n);
  set_axes(ring, unit_or(velocity, spine.t[e]), end_n * (1 - w) + own * w, own);
  ring.r_n = end.r_n * (1 - w) + s.r_n[e] * w;
  ring.r_b = end.r_b * (1 - w) + s.r_b[e] * w;
  ring.wall = end.wall * (1 - w) + (s.wall.empty() ? 0 : s.wall[e]) * w;
  ring.edge = e;
  ring.along = u;
  return ring;
}

}  // namespace

std::vector<Ring> tube_rings(const RodStrip& s, std::span<const int> pieces) {
  const int edges = s.edge_count();
  LISSOM_ASSERT(static_cast<int>(pieces.size()) == edges);
  const Spine spine = make_spine(s);
  std::vector<Ring> at_points;
  for (int i = 0; i <= edges; ++i) {
    const int before = i > 0 ? i - 1 : s.closed ? edges - 1 : 0;
    const int after = i < edges ? i : s.closed ? 0 : edges - 1;
    Ring ring;
    if (s.closed && i == 0) {  // seen from the first edge, whose sign is +1
      Spine wrapped = spine;
      if (spine.reversed) wrapped.sign[before] = -wrapped.sign[before];
      ring = point_ring(s, wrapped, before, after, 1);
    } else if (s.closed && i == edges) {
      ring = at_points.front();
      if (spine.reversed) ring.n = -ring.n, ring.b = -ring.b;
    } else {
      ring = point_ring(s, spine, before, after, spine.sign[after]);
    }
    ring.centre = s.points[s.closed ? i % edges : i];
    ring.edge = std::min(i, edges - 1);
    ring.along = i < edges ? 0 : 1;
    at_points.push_back(ring);
  }
  std::vector<Ring> rings;
  for (int e = 0; e < edges; ++e) {
    rings.push_back(at_points[e]);
    for (int k = 1; k < pieces[e]; ++k) {
      rings.push_back(inner_ring(s, spine, e, static_cast<double>(k) / pieces[e], at_points[e], at_points[e + 1]));
    }
  }
  rings.push_back(at_points.back());
  return rings;
}

std::vector<Vec2> section_outline(SectionShape shape, int sides) {
  if (shape == SectionShape::kRectangle) return {Vec2(1, 1), Vec2(-1, 1), Vec2(-1, -1), Vec2(1, -1)};
  LISSOM_ASSERT(sides >= 4 && sides % 2 == 0);
  std::vector<Vec2> outline;
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.5) / sides;
    outline.emplace_back(std::cos(angle), std::sin(angle));
  }
  return outline;
}

Vec3 ring_point(const Ring& ring, const Vec2& outline, double scale_b, double scale_n) {
  const Vec3 offset = ring.b * (outline.x() * ring.r_b * scale_b) + ring.n * (outline.y() * ring.r_n * scale_n);
  const double stretch = ring.mitre.norm();
  if (stretch < 1e-9) return ring.centre + offset;
  const Vec3 d = ring.mitre / stretch;
  return ring.centre + offset + d * (d.dot(offset) * stretch);
}

}  // namespace lissom
