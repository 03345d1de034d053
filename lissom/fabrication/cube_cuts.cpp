#include "lissom/fabrication/cube_cuts.h"

#include <algorithm>
#include <cstddef>
#include <map>

namespace lissom {

namespace {

int edge_between(int a, int b) {
  const int from = std::min(a, b), axis = (a ^ b) == 1 ? 0 : (a ^ b) == 2 ? 1 : 2;
  const std::array<CubeEdge, kCubeEdges>& edges = cube_edges();
  for (int e = 0; e < kCubeEdges; ++e) {
    const CubeEdge& edge = edges[e];
    if (edge.from == from && edge.axis == axis) return e;
  }
  return -1;
}

/// Corners of the six sides, each anticlockwise seen from outside the cube.
constexpr std::array<std::array<int, 4>, 6> kSides{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

bool inside(int which, int corner) { return (which >> corner & 1) != 0; }

/// Whether two edges of the cube lie on one of its sides.
bool on_one_side(int a, int b) {
  for (const std::array<int, 4>& side : kSides) {
    int found = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const int e = edge_between(side[k], side[(k + 1) % 4]);
      found += (e == a ? 1 : 0) + (e == b ? 1 : 0);
    }
    if (found == 2) return true;
  }
  return false;
}

/// On each side, every run of inside corners is cut off by a segment; here from where the run begins to where it ends.
std::vector<std::vector<int>> loops_of(int which) {
  std::map<int, int> next;
  for (const std::array<int, 4>& side : kSides) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (inside(which, side[k]) || !inside(which, side[(k + 1) % 4])) continue;
      std::size_t end = (k + 1) % 4;
      while (inside(which, side[(end + 1) % 4])) end = (end + 1) % 4;
      next[edge_between(side[k], side[(k + 1) % 4])] = edge_between(side[end], side[(end + 1) % 4]);
    }
  }
  std::vector<std::vector<int>> loops;
  while (!next.empty()) {
    std::vector<int> loop;
    for (int e = next.begin()->first; next.count(e) > 0;) {
      loop.push_back(e);
      const int following = next[e];
      next.erase(e);
      e = following;
    }
    loops.push_back(loop);
  }
  return loops;
}

bool fan_is_safe(const std::vector<int>& loop, std::size_t start) {
  for (std::size_t k = 2; k + 1 < loop.size(); ++k) {
    if (on_one_side(loop[start], loop[(start + k) % loop.size()])) return false;
  }
  return true;
}

CubeCuts cuts_of(int which) {
  CubeCuts cuts;
  for (const std::vector<int>& loop : loops_of(which)) {
    const std::size_t n = loop.size();
    std::size_t start = 0;
    while (start < n && !fan_is_safe(loop, start)) ++start;
    if (start < n) {
      for (std::size_t k = 1; k + 1 < n; ++k) {
        cuts.triangles.push_back({loop[start], loop[(start + k) % n], loop[(start + k + 1) % n]});
      }
      continue;
    }
    const int centre = kCubeEdges + static_cast<int>(cuts.centred.size());
    for (std::size_t k = 0; k < n; ++k) cuts.triangles.push_back({centre, loop[k], loop[(k + 1) % n]});
    cuts.centred.push_back(loop);
  }
  return cuts;
}

}  // namespace

const std::array<CubeEdge, kCubeEdges>& cube_edges() {
  static constexpr std::array<CubeEdge, kCubeEdges> kEdges{
      {{0, 0}, {2, 0}, {4, 0}, {6, 0}, {0, 1}, {1, 1}, {4, 1}, {5, 1}, {0, 2}, {1, 2}, {2, 2}, {3, 2}}};
  return kEdges;
}

const std::vector<CubeCuts>& cube_cuts() {
  static const std::vector<CubeCuts> table = [] {
    std::vector<CubeCuts> made;
    for (int which = 0; which < 256; ++which) made.push_back(cuts_of(which));
    return made;
  }();
  return table;
}

}  // namespace lissom
