#pragma once
/// How the cells of a surface grow from their sites over the vertices of a triangulation.

#include <span>
#include <vector>

#include "lissom/geometry/surface.h"

namespace lissom {

class CellGrowth {
 public:
  CellGrowth() = default;
  explicit CellGrowth(const Surface& surface);

  /// Per vertex the cell that reaches it: each grows from vertex start[i], over edges, nearer vertices (to site[i], m,
  /// through space) before farther ones. `start` without repeats. -1 for vertices that none reaches.
  std::vector<int> grow(const Surface& surface, std::span<const Vec3> site, std::span<const int> start) const;

  /// Per cell: its vertices minus its edges plus its triangles, which is 1 for a disc.
  std::vector<int> euler_numbers(const Surface& surface, std::span<const int> cell, int cells) const;

 private:
  std::span<const int> around(int vertex) const;

  std::vector<int> first_, neighbour_;  // lists of neighbours by vertex
};

}  // namespace lissom
