#pragma once
/// Makes a surface that somebody brought one that can be computed on: one piece, at most two triangles at a side, one
/// fan of triangles at a vertex, all turned alike (outward when closed), none without area. What can be mended without
/// changing the shape is mended and noted; the rest is refused with its place.

#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/geometry/surface.h"
#include "lissom/geometry/surface_note.h"

namespace lissom {

struct SurfaceRepairOptions {
  enum class Holes { kKeep, kFill };            ///< small ones; larger loops always stay the rim of an open surface
  enum class Pieces { kRefuse, kKeepLargest };  ///< more than one, debris aside
  enum class Crossings { kKeep, kRefuse };      ///< triangles that run through others

  Holes holes = Holes::kKeep;
  Pieces pieces = Pieces::kRefuse;
  /// Kept by default: rods are laid along the surface and never ask what else is near in space, so a crossing spoils
  /// nothing but nearest points close to it; and people seldom have the means to remove one.
  Crossings crossings = Crossings::kKeep;

  double merge = 1e-6;       ///< of the largest extent: vertices at rims that are nearer than this are one
  double thin = 1e-5;        ///< of its longest side: a triangle that is less high over it than this is mended away
  double small_hole = 0.05;  ///< of the largest extent: the diagonal of the box around a hole that counts as small
  double debris = 1e-3;      ///< of the area of the largest piece: smaller pieces are left out

  Status validate() const;
};

struct RepairedSurface {
  Surface surface;
  std::vector<SurfaceNote> notes;  ///< in the order in which things were found; empty: nothing was wrong
};

/// `where` begins the places of errors: "hat.obj" gives "hat.obj/triangles/7". Vertices and triangles in notes have the
/// numbers that they have in `surface`. What is returned comes back the same, without a word of mending, when it is
/// given again. Same input, same bytes out; time n log n, for defects in number of the triangles too. Errors: kRange
/// for coordinates and corners that do not exist, kGeometry for what cannot be mended, kUnsupported for more than
/// kMostSurfaceTriangles.
Result<RepairedSurface> repair_surface(Surface surface, const SurfaceRepairOptions& options, const std::string& where);

}  // namespace lissom
