#pragma once
/// Surfaces in the files of other programs: OBJ, PLY, STL, OFF. The readers are our own because CGAL's only say whether
/// they succeeded, and a person with a damaged file has to be told the line.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/geometry/surface.h"
#include "lissom/geometry/surface_note.h"

namespace lissom {

/// Largest surfaces that are read: more than any scan that rods are laid on, and what repair takes seconds for.
constexpr int kMostSurfaceTriangles = 2'000'000;
constexpr int kMostSurfaceVertices = 3 * kMostSurfaceTriangles;
constexpr int kMostPolygonCorners = 256;

/// What a file holds, before it has a unit. Coordinates may be anything that a double can be, NaN included.
struct RawSurface {
  std::string file;                           ///< its name, for places
  std::string format;                         ///< "OBJ", "binary PLY", ...
  std::vector<Vec3> points;                   ///< in the unit of the file (n x 3)
  std::vector<std::array<int, 3>> triangles;  ///< all corners exist (t x 3)
  std::vector<double> darkness;               ///< as in Surface: 1 - luma (Rec. 709) of the colours; or empty
  std::vector<SurfaceNote> notes;             ///< what was split or left out
};

/// Reads a surface; the format follows from the ending of `file`: .obj, .ply, .stl, .off. Polygons are split into
/// triangles: quadrilaterals along the shorter diagonal that folds nothing, others by clipping ears. Points of an STL
/// file with the same coordinates are one. Errors name "file:line", or the element of a binary file. Time and memory
/// are bounded by the size of the file whatever its header announces.
Result<RawSurface> read_surface(std::string_view bytes, const std::string& file);

Result<RawSurface> read_surface_obj(std::string_view text, const std::string& file);
Result<RawSurface> read_surface_ply(std::string_view bytes, const std::string& file);
Result<RawSurface> read_surface_stl(std::string_view bytes, const std::string& file);
Result<RawSurface> read_surface_off(std::string_view text, const std::string& file);

/// Millimetres. Binary PLY (little endian, doubles; darkness as grey in 255 steps), and OBJ text with 17 digits
/// (darkness as grey behind the coordinates).
std::string write_surface_ply(const Surface& surface);
std::string write_surface_obj(const Surface& surface);

}  // namespace lissom
