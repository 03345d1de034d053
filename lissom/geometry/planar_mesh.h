#pragma once
/// Triangles for a flat region whose lines (rods) must appear edge for edge, uncut: constrained Delaunay triangulation
/// refined by circumcentres [Ruppert 1995, without the cutting of segments; CGAL's mesher], then smoothed.
///
/// Segments are never cut, so a triangle on a segment is no better than the segments near it allow: two rods closer to
/// each other than their edges are long leave triangles without an inner vertex. Everywhere else the angle asked for is
/// met when it is 30 degrees or less.

#include <array>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/core/types.h"

namespace lissom {

struct PlanarRegion {
  std::vector<Vec2> points;                  ///< m, (n x 2), all of them become vertices
  std::vector<std::array<int, 2>> segments;  ///< pairs of points, edges that the mesh must have
  std::vector<int> outline;                  ///< segments that bound the region from outside, closed loops
  std::vector<Vec2> holes;                   ///< m, one point in each hole, which reaches up to the segments around it
  double edge_length = 0;                    ///< m, mean edge of triangles away from the segments
  double min_angle = 0.436;                  ///< rad, asked for; at most 30 degrees are promised
};

struct PlanarMesh {
  std::vector<Vec2> points;                   ///< m, those of the region first, unchanged, then the inner ones
  std::vector<std::array<int, 3>> triangles;  ///< anticlockwise
  double smallest_angle = 0;                  ///< rad
  int worst_triangle = -1;                    ///< the one that has it
};

/// Same input, same mesh. Refuses at `where` what cannot be meshed (kGeometry, kRange): numbers that are not finite,
/// points that coincide, segments that cross or run through a point, an outline that is open or encloses nothing, a hole
/// outside of it (at where/holes/0, ...), holes that leave nothing, more triangles than kMostTriangles.
Result<PlanarMesh> mesh_planar_region(const PlanarRegion& region, const std::string& where);

constexpr int kMostTriangles = 2'000'000;

}  // namespace lissom
