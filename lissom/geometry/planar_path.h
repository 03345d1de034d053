#pragma once
/// Drawn lines of the plane: straight pieces, circular arcs and cubic Bezier curves in a row.

#include <vector>

#include "lissom/core/types.h"

namespace lissom {

struct PathPiece {
  enum class Kind { kLine, kArc, kCubic };
  Kind kind = Kind::kLine;
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();  ///< m
  /// m; of a cubic its control points; of an arc `a` is a point on it.
  Vec2 a = Vec2::Zero(), b = Vec2::Zero();

  static PathPiece line(const Vec2& from, const Vec2& to) { return {Kind::kLine, from, to, from, to}; }
  static PathPiece arc(const Vec2& from, const Vec2& middle, const Vec2& to) {
    return {Kind::kArc, from, to, middle, to};
  }
  static PathPiece cubic(const Vec2& from, const Vec2& a, const Vec2& b, const Vec2& to) {
    return {Kind::kCubic, from, to, a, b};
  }

  /// s from 0 to 1.
  Vec2 at(double s) const;
  /// Direction at its start and end, unit.
  Vec2 start_direction() const;
  Vec2 end_direction() const;
};

/// Each piece starts where the one before ends.
using PlanarPath = std::vector<PathPiece>;

/// Centre of the circle through three points; not finite when they lie in line.
Vec2 circle_centre(const Vec2& a, const Vec2& b, const Vec2& c);

/// Angle by which an arc turns, anticlockwise positive, rad.
double sweep_of(const PathPiece& arc);

/// Part of an ellipse with half axes rx, ry (m) along axes turned by `turn` (rad), from angle `start` on by `sweep` (rad,
/// of the circle before it is squeezed): arcs when it is a circle, else cubics of at most 45 degrees, which are off by
/// less than 4e-6 of the radius.
PlanarPath ellipse_path(const Vec2& centre, double rx, double ry, double turn, double start, double sweep);

}  // namespace lissom
