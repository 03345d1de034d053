#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "lissom/model/discretize_parts.h"

namespace lissom {

namespace {

constexpr double kParallel = 1e-3;  // sine of the angle below which a direction gives no normal
constexpr double kFlip = std::numbers::pi / 3;

/// Carries a frame to another tangent without twist, clean of rounding.
Frame carried(const Frame& frame, const Vec3& tangent) {
  return frame_from_normal(tangent, parallel_transport(frame.t, tangent, frame.n));
}

/// Frames from one direction per edge. Where it is parallel to the rod the frame of the edge before (or, at the start, the
/// first one after that has a normal) is carried over without twist; a rod that is parallel throughout starts from the
/// coordinate axis that its first tangent is least aligned with.
template <class Direction>
int frames_from_directions(RodShape& shape, const Direction& direction) {
  const int n = shape.edges();
  const auto tangent = [&](int i) -> const Vec3& { return shape.edge_tangents[static_cast<size_t>(i)]; };
  const auto frame = [&](int i) -> Frame& { return shape.frames[static_cast<size_t>(i)]; };
  int first = 0, without = 0;
  while (first < n && parallel(tangent(first), direction(first))) ++first;
  const bool none = first == n;
  if (none) {
    first = 0;
    frame(0) = frame_from_normal(tangent(0), tangent(0));
  } else {
    frame(first) = frame_from_normal(tangent(first), direction(first));
  }
  for (int i = first - 1; i >= 0; --i, ++without) frame(i) = carried(frame(i + 1), tangent(i));
  for (int i = first + 1; i < n; ++i) {
    const bool lost = none || parallel(tangent(i), direction(i));
    frame(i) = lost ? carried(frame(i - 1), tangent(i)) : frame_from_normal(tangent(i), direction(i));
    without += lost;
  }
  return none ? n : without;
}

Vec3 interpolated(const std::vector<Vec3>& normals, double place, bool closed) {
  const size_t n = normals.size();
  if (n == 1) return normals[0];
  const double u = place * double(closed ? n : n - 1);
  const size_t i = std::min(static_cast<size_t>(u), closed ? n - 1 : n - 2);
  const double s = u - double(i);
  return (1 - s) * normals[i].normalized() + s * normals[(i + 1) % n].normalized();
}

void frames_by_transport(RodShape& shape, const Vec3& normal) {
  shape.frames[0] = frame_from_normal(shape.edge_tangents[0], normal);
  for (size_t i = 1; i < shape.frames.size(); ++i) {
    shape.frames[i] = carried(shape.frames[i - 1], shape.edge_tangents[i]);
  }
}

/// First frame from the normal at the start, transported, then turned evenly so that the last one fits the end.
void frames_from_joints(RodShape& shape, const Vec3& start, const Vec3& end) {
  const size_t n = shape.frames.size();
  if (n == 1) {
    const Frame first = frame_from_normal(shape.edge_tangents[0], start), last = frame_from_normal(first.t, end);
    const double angle = signed_angle(first.t, first.n, last.n);
    shape.frames[0] = rotated(rotation_from_vector(angle / 2 * first.t), first);
    return;
  }
  frames_by_transport(shape, start);
  const Frame &last = shape.frames.back(), wanted = frame_from_normal(last.t, end);
  const double angle = signed_angle(last.t, last.n, wanted.n);
  for (size_t j = 1; j < n; ++j) {
    Frame& f = shape.frames[j];
    f = frame_from_normal(f.t, rotation_from_vector(angle * double(j) / double(n - 1) * f.t) * f.n);
  }
}

}  // namespace

std::vector<Vec3> directions_of_normals(const RodShape& shape, const MaterialAxes& axes) {
  const bool per_point = axes.kind == MaterialAxes::Kind::kPerPoint && !axes.normals.empty();
  if (!per_point && axes.kind != MaterialAxes::Kind::kDirection && axes.kind != MaterialAxes::Kind::kPerPoint)
    return {};
  const int n = shape.edges();
  std::vector<Vec3> directions;
  directions.reserve(static_cast<size_t>(n));
  for (int i = 0; i < n; ++i) {
    directions.push_back(per_point ? interpolated(axes.normals, (i + 0.5) / n, shape.closed) : axes.normal);
  }
  return directions;
}

bool parallel(const Vec3& tangent, const Vec3& normal) {
  return !(tangent.cross(normal).norm() > kParallel * normal.norm());
}

void set_frames(RodShape& shape, const MaterialAxes& axes, const Vec3& start, const Vec3& end, const std::string& label,
                std::vector<std::string>& notes) {
  shape.frames.resize(shape.lengths.size());
  const int n = shape.edges();
  switch (axes.kind) {
    case MaterialAxes::Kind::kDirection:
    case MaterialAxes::Kind::kPerPoint: {
      const std::vector<Vec3> directions = directions_of_normals(shape, axes);
      const auto direction = [&](int i) -> const Vec3& { return directions[static_cast<size_t>(i)]; };
      if (const int without = frames_from_directions(shape, direction); without > 0) {
        notes.push_back(fmt::format(
            "{}: the direction of the normal is parallel to {} of {} edges, where the normal is carried over from the "
            "neighbours{}",
            label, without, n, without == n ? ", starting from a coordinate axis: name another direction" : ""));
        return;
      }
      break;
    }
    case MaterialAxes::Kind::kTransport:
      if (parallel(shape.edge_tangents[0], axes.normal)) {
        notes.push_back(
            fmt::format("{}: the normal is parallel to the first edge, a coordinate axis is used instead", label));
      }
      frames_by_transport(shape, axes.normal);
      return;
    case MaterialAxes::Kind::kJoints:
      if (shape.closed) {
        frames_by_transport(shape, axes.normal);
      } else {
        frames_from_joints(shape, start, end);
      }
      return;
  }
  for (int i = 1; i < n; ++i) {
    const double twist =
        pair_strain(shape.frames[static_cast<size_t>(i - 1)], shape.frames[static_cast<size_t>(i)]).twist;
    if (std::abs(twist) <= kFlip) continue;
    notes.push_back(fmt::format(
        "{}: the drawn normal turns by {:.0f} degrees between edges {} and {}; carry it along without twist (axes "
        "\"transport\") or name another direction",
        label, std::abs(twist) * 180 / std::numbers::pi, i - 1, i));
    return;
  }
}

Frame node_frame(const RodShape& shape, int edge, bool at_end) {
  const int n = shape.edges();
  const auto e = static_cast<size_t>(edge);
  const Frame& frame = shape.frames[e];
  // The twist of the neighbouring pair is shared in proportion to the lengths; at the ends of a rod that of the one pair.
  double twist = 0;
  int other = edge + (at_end ? 1 : -1);
  bool after = at_end;
  if (shape.closed) {
    other = (other + n) % n;
  } else if (other < 0 || other >= n) {
    other = edge + (at_end ? -1 : 1);
    after = !at_end;
  }
  if (other >= 0 && other < n && other != edge) {
    const auto o = static_cast<size_t>(other);
    const double whole = (after ? pair_strain(frame, shape.frames[o]) : pair_strain(shape.frames[o], frame)).twist;
    twist = whole * shape.lengths[e] / (shape.lengths[e] + shape.lengths[o]);
  }
  const size_t node = (e + (at_end ? 1 : 0)) % shape.points.size();
  const Vec3& tangent = shape.node_tangents.empty() ? frame.t : shape.node_tangents[node];
  const Frame moved = carried(frame, tangent);
  return rotated(rotation_from_vector((at_end ? twist : -twist) * moved.t), moved);
}

}  // namespace lissom
