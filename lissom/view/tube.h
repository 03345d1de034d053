#pragma once
/// Surfaces of rods: rings of section points along a strip. Pictures and surface meshes are both cut from them.

#include <span>
#include <vector>

#include "lissom/view/rod_drawing.h"

namespace lissom {

/// A cross-section in space. At a kink the section is cut by the bisecting plane, so that the tube keeps its width.
struct Ring {
  Vec3 centre = Vec3::Zero();  ///< m
  Vec3 b, n;                   ///< unit, perpendicular to the tube
  double r_n = 0, r_b = 0;     ///< m
  double wall = 0;             ///< m
  Vec3 mitre = Vec3::Zero();   ///< direction of stretching at a kink, length = 1/cos(half the turning angle) - 1
  int edge = 0;                ///< of the strip, edge that follows (the last one at the end)
  double along = 0;            ///< 0..1 between the two points of `edge`
};

/// Rings at all points of a strip and `pieces[edge] - 1` more inside each edge. Inside, centres follow a C1 curve
/// through the points (Hermite; kinks above 35 degrees stay kinks): one piece per edge is the computed polyline itself.
/// Closed strips repeat the first ring at the end, turned by half a turn when the frames come back reversed.
std::vector<Ring> tube_rings(const RodStrip& strip, std::span<const int> pieces);

/// Unit section outline, counter-clockwise seen against the tangent, (cos, sin) of b and n: `sides` points for ellipses
/// and tubes, the four corners for rectangles. Sides must be even.
std::vector<Vec2> section_outline(SectionShape shape, int sides);

/// Point of the outline in space; `scale` 1 is the outer surface.
Vec3 ring_point(const Ring& ring, const Vec2& outline, double scale_b = 1, double scale_n = 1);

}  // namespace lissom
