#pragma once
/// Tubes of rods that run alone: rings of section points, and how they are joined to surfaces that were looked for.

#include <span>
#include <vector>

#include "lissom/fabrication/solid_plan.h"
#include "lissom/geometry/surface.h"

namespace lissom {

/// A closed line of vertices around a rod, anticlockwise seen against its tangent, with their angles: of (u / r_b, v / r_n)
/// from b to n, rad, ascending within one turn.
struct VertexRing {
  std::vector<int> vertices;
  std::vector<double> angles;
};

/// How many sides tubes have between these stations: polygons of the area of the ellipse are within the tolerance of it.
int ring_sides(const RodPiece& piece, int first, int last, double tolerance);

/// Adds a ring of the same area as the section: `sides` points, the four corners of rectangles.
VertexRing add_ring(const RodStation& station, SectionShape shape, int sides, Surface& surface);

/// Joins two rings, `upper` further along the rod. They may have different numbers of vertices.
void add_band(const VertexRing& lower, const VertexRing& upper, Surface& surface);

/// Closes a ring by a flat cap, `step` +1 at the end of a rod, -1 at its start.
void add_cap(const VertexRing& ring, int step, Surface& surface);

}  // namespace lissom
