#pragma once
/// The steps of repair_surface, each on the surface as the step before leaves it.

#include <string>
#include <utility>
#include <vector>

#include "lissom/geometry/surface_repair.h"
#include "lissom/geometry/surface_topology.h"

namespace lissom {

/// Vertices keep their numbers until the end (some are added, some fall out of use), triangles remember theirs.
struct Mending {
  Surface surface;
  std::vector<int> origins;  ///< number of each triangle in the surface that was brought, -1 for lids of holes
  SurfaceRepairOptions options;
  std::string where;
  double extent = 0;  ///< m, largest
  /// From sew_rims to split_fans, if anything was sewn: the triangles with the vertices from before.
  Triangles unsewn = {};
  std::vector<SurfaceNote> notes;

  Vec3 middle(int triangle) const;
  std::string triangle_name(int triangle) const;
  std::string triangle_place(int triangle) const;  ///< for errors
  double height(int triangle) const;               ///< m, over the longest side
  bool is_thin(int triangle) const;
  bool is_thin(const Vec3& a, const Vec3& b, const Vec3& c) const;
  void turn_over(int triangle);
  /// Leaves out the triangles that are marked.
  void drop(const std::vector<char>& marked);
  /// Keeps the note if it counts something.
  void note(SurfaceNote note, SurfaceNote::Outcome outcome = SurfaceNote::Outcome::kMended);
};

/// Largest side of the box around the triangles (m).
double largest_extent(const Surface& surface);

/// Numbers that do not exist, extents that cannot be computed with; numbers the triangles.
Status check_numbers(Mending& mending);

/// Merges vertices at rims that are in one place, so that what was drawn side by side is connected. Vertices inside stay
/// apart: closed parts that only touch would be fused. What is merged is noted by split_fans, which parts some again.
void sew_rims(Mending& mending);
void drop_repeated_corners(Mending& mending);
/// Triangles over the same three places, whichever way they are turned.
void drop_duplicates(Mending& mending);

/// Leaves one piece without sides that more than two triangles have, or says why not.
Status leave_one_piece(Mending& mending);

/// Turns triangles like their neighbours, all outward when the surface is closed.
Status turn_alike(Mending& mending);
/// The whole surface, when it is closed and faces inward.
void turn_outward(Mending& mending);
/// Vertices where fans of triangles only touch become one vertex for each fan: those from before sewing, if they were.
void split_fans(Mending& mending);

Status mend_thin_triangles(Mending& mending);

/// Where options want it; also holes that meet in a vertex, before split_fans makes one of them.
void close_small_holes(Mending& mending);
/// Those that are there in the end.
void note_small_holes(Mending& mending);

Status look_for_crossings(Mending& mending);

}  // namespace lissom
