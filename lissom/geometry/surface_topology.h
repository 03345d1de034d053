#pragma once
/// Which triangles of a surface meet where. A side is 3 t + i: of triangle t, from its corner i to the next.

#include <array>
#include <vector>

#include "lissom/geometry/surface.h"

namespace lissom {

using Triangles = std::vector<std::array<int, 3>>;

constexpr int kRim = -1;      ///< a side that no other triangle has
constexpr int kCrowded = -2;  ///< a side that two others or more have

inline int side_start(const Triangles& triangles, int side) { return triangles[side / 3][side % 3]; }
inline int side_end(const Triangles& triangles, int side) { return triangles[side / 3][(side % 3 + 1) % 3]; }

/// The side of the other triangle at each side, whichever way the two are turned; kRim or kCrowded (3 t). Triangles have
/// three different corners. Time n log n.
std::vector<int> side_mates(const Triangles& triangles);

/// Piece of each triangle: triangles of one piece are connected by sides that two triangles share. Pieces are numbered in
/// the order of their first triangle.
struct SurfacePieces {
  std::vector<int> of;  ///< by triangle (t)
  int count = 0;
};
SurfacePieces surface_pieces(const std::vector<int>& mates);

/// Fan of each corner (3 t + i): the first corner that sides connect it to around its vertex. Neighbours are turned alike.
std::vector<int> corner_fans(const std::vector<int>& mates);

/// Closed rings of rim sides, each in the order of its triangles, of a surface whose neighbours are turned alike. Where two
/// fans meet in a vertex a ring goes on along the other one, around the hole between them; where there are more, along
/// its own.
std::vector<std::vector<int>> rim_loops(const Triangles& triangles, const std::vector<int>& mates);

/// What people ask of a surface. For surfaces as repair_surface returns them.
struct SurfaceFacts {
  int pieces = 0, loops = 0;
  int genus = 0;                                 ///< summed over pieces; of a surface with loops closed by lids
  double area = 0;                               ///< m^2
  double volume = 0;                             ///< m^3, of a closed surface; 0 else
  double longest_loop = 0;                       ///< m
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  ///< m, corners of the box around it
};
SurfaceFacts surface_facts(const Surface& surface);

/// Signed, as if seen from the mean of the corners: positive when triangles are anticlockwise seen from outside (m^3).
double enclosed_volume(const Surface& surface);

}  // namespace lissom
