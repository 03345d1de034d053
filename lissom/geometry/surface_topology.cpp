#include "lissom/geometry/surface_topology.h"

#include <algorithm>
#include <numeric>

#include "lissom/core/assert.h"

namespace lissom {

std::vector<int> side_mates(const Triangles& triangles) {
  struct Edge {
    int low, high, side;
    bool operator<(const Edge& other) const {
      return low != other.low ? low < other.low : high != other.high ? high < other.high : side < other.side;
    }
  };
  const int sides = 3 * static_cast<int>(triangles.size());
  std::vector<Edge> edges;
  edges.reserve(sides);
  for (int s = 0; s < sides; ++s) {
    const int a = side_start(triangles, s), b = side_end(triangles, s);
    edges.push_back({std::min(a, b), std::max(a, b), s});
  }
  std::sort(edges.begin(), edges.end());
  std::vector<int> mates(sides, kRim);
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high) ++end;
    if (end - begin == 2) {
      mates[edges[begin].side] = edges[begin + 1].side;
      mates[edges[begin + 1].side] = edges[begin].side;
    } else if (end - begin > 2) {
      for (std::size_t i = begin; i < end; ++i) mates[edges[i].side] = kCrowded;
    }
  }
  return mates;
}

SurfacePieces surface_pieces(const std::vector<int>& mates) {
  SurfacePieces pieces;
  pieces.of.assign(mates.size() / 3, -1);
  std::vector<int> open;
  for (int first = 0; first < static_cast<int>(pieces.of.size()); ++first) {
    if (pieces.of[first] >= 0) continue;
    pieces.of[first] = pieces.count;
    open.push_back(first);
    while (!open.empty()) {
      const int t = open.back();
      open.pop_back();
      for (int i = 0; i < 3; ++i) {
        const int mate = mates[3 * t + i];
        if (mate < 0 || pieces.of[mate / 3] >= 0) continue;
        pieces.of[mate / 3] = pieces.count;
        open.push_back(mate / 3);
      }
    }
    ++pieces.count;
  }
  return pieces;
}

std::vector<int> corner_fans(const std::vector<int>& mates) {
  std::vector<int> root(mates.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int c) {
    while (root[c] != c) c = root[c] = root[root[c]];
    return c;
  };
  const auto next = [](int side) { return side % 3 == 2 ? side - 2 : side + 1; };
  for (int s = 0; s < static_cast<int>(mates.size()); ++s) {
    if (mates[s] < s) continue;
    // Where one side starts the other ends.
    for (const auto& [a, b] : {std::pair(s, next(mates[s])), std::pair(next(s), mates[s])}) {
      const int low = std::min(find(a), find(b));
      root[find(a)] = low;
      root[find(b)] = low;
    }
  }
  for (int c = 0; c < static_cast<int>(root.size()); ++c) root[c] = find(c);
  return root;
}

std::vector<std::vector<int>> rim_loops(const Triangles& triangles, const std::vector<int>& mates) {
  std::vector<std::pair<int, int>> leaving;  // vertex, its rim side
  for (int s = 0; s < static_cast<int>(mates.size()); ++s) {
    if (mates[s] < 0) leaving.emplace_back(side_start(triangles, s), s);
  }
  if (leaving.empty()) return {};
  std::sort(leaving.begin(), leaving.end());
  const std::vector<int> fans = corner_fans(mates);
  const auto next = [&](int side) {
    const int end = side_end(triangles, side), fan = fans[side % 3 == 2 ? side - 2 : side + 1];
    const auto first = std::lower_bound(leaving.begin(), leaving.end(), std::pair(end, -1));
    auto last = first;
    while (last != leaving.end() && last->first == end) ++last;
    for (auto found = first; found != last; ++found) {
      if ((fans[found->second] == fan) != (last - first == 2)) return static_cast<std::size_t>(found - leaving.begin());
    }
    LISSOM_ASSERT(false);  // every fan that a rim reaches is left by one
    return leaving.size();
  };
  std::vector<char> taken(leaving.size(), 0);
  std::vector<std::vector<int>> loops;
  for (std::size_t first = 0; first < leaving.size(); ++first) {
    if (taken[first]) continue;
    loops.emplace_back();
    for (std::size_t at = first; !taken[at]; at = next(leaving[at].second)) {
      taken[at] = 1;
      loops.back().push_back(leaving[at].second);
    }
  }
  return loops;
}

double enclosed_volume(const Surface& surface) {
  Vec3 middle = Vec3::Zero();
  for (const auto& t : surface.triangles) {
    for (const int v : t) middle += surface.vertices[v] / (3.0 * static_cast<double>(surface.triangles.size()));
  }
  double volume = 0;
  for (const auto& t : surface.triangles) {
    const Vec3 a = surface.vertices[t[0]] - middle, b = surface.vertices[t[1]] - middle,
               c = surface.vertices[t[2]] - middle;
    volume += a.dot(b.cross(c)) / 6;
  }
  return volume;
}

SurfaceFacts surface_facts(const Surface& surface) {
  SurfaceFacts facts;
  const std::vector<int> mates = side_mates(surface.triangles);
  facts.pieces = surface_pieces(mates).count;
  const std::vector<std::vector<int>> loops = rim_loops(surface.triangles, mates);
  facts.loops = static_cast<int>(loops.size());
  for (const std::vector<int>& loop : loops) {
    double length = 0;
    for (const int s : loop) {
      length += (surface.vertices[side_end(surface.triangles, s)] - surface.vertices[side_start(surface.triangles, s)])
                    .norm();
    }
    facts.longest_loop = std::max(facts.longest_loop, length);
  }
  std::vector<char> used(surface.vertices.size(), 0);
  Eigen::AlignedBox3d box;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    facts.area += 0.5 * area_vector(surface, static_cast<int>(t)).norm();
    for (const int v : surface.triangles[t]) {
      used[v] = 1;
      box.extend(surface.vertices[v]);
    }
  }
  if (!box.isEmpty()) facts.low = box.min(), facts.high = box.max();
  const int rims = static_cast<int>(std::count_if(mates.begin(), mates.end(), [](int mate) { return mate < 0; }));
  const int edges = (static_cast<int>(mates.size()) + rims) / 2;
  const int vertices = static_cast<int>(std::count(used.begin(), used.end(), 1));
  // Euler's formula per piece: V - E + F = 2 - 2 genus - loops.
  facts.genus = (2 * facts.pieces - facts.loops - (vertices - edges + static_cast<int>(surface.triangles.size()))) / 2;
  if (facts.loops == 0) facts.volume = enclosed_volume(surface);
  return facts;
}

}  // namespace lissom
