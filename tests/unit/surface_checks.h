#pragma once
/// What a mended surface promises, checked without the code that mends.

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "lissom/geometry/surface.h"

namespace lissom::samples {

/// Number of sides without a neighbour.
struct Soundness {
  std::string
      fault;  ///< empty: one fan per vertex, at most two triangles at an edge, turned alike, none thin, one piece
  int rims = 0;
};

/// Whether the triangles at v form one fan: walking over shared edges reaches all of them.
inline bool one_fan(const std::vector<std::array<int, 3>>& around, int v) {
  std::set<int> ends;  // neighbours of v reached so far
  std::vector<char> seen(around.size(), 0);
  bool grown = true;
  std::size_t count = 0;
  while (grown) {
    grown = false;
    for (std::size_t k = 0; k < around.size(); ++k) {
      bool touches = count == 0;
      for (const int w : around[k]) touches = touches || (w != v && ends.count(w));
      if (seen[k] || !touches) continue;
      seen[k] = 1;
      ++count;
      grown = true;
      for (const int w : around[k]) {
        if (w != v) ends.insert(w);
      }
    }
  }
  return count == around.size();
}

inline Soundness soundness(const Surface& s) {
  Soundness result;
  const auto fault = [&](const std::string& text) {
    if (result.fault.empty()) result.fault = text;
  };
  if (s.triangles.empty()) fault("no triangles");
  if (!s.darkness.empty() && s.darkness.size() != s.vertices.size()) fault("darkness of the wrong size");
  std::map<std::pair<int, int>, int> directed;
  std::vector<std::vector<std::array<int, 3>>> around(s.vertices.size());
  for (std::size_t k = 0; k < s.triangles.size(); ++k) {
    const auto& t = s.triangles[k];
    for (int i = 0; i < 3; ++i) {
      if (t[i] < 0 || t[i] >= static_cast<int>(s.vertices.size())) return {"a vertex that does not exist", 0};
      if (++directed[{t[i], t[(i + 1) % 3]}] > 1) fault("an edge that two triangles run along the same way");
      around[t[i]].push_back(t);
    }
    const Vec3 a = s.vertices[t[1]] - s.vertices[t[0]], b = s.vertices[t[2]] - s.vertices[t[0]];
    const double longest = std::max({a.norm(), b.norm(), (a - b).norm()});
    if (!(a.cross(b).norm() > 1e-5 * longest * longest)) fault("triangle " + std::to_string(k) + " is thin");
  }
  for (const auto& [edge, count] : directed) result.rims += directed.count({edge.second, edge.first}) == 0;
  for (std::size_t v = 0; v < around.size(); ++v) {
    if (!s.vertices[v].allFinite()) fault("a vertex that is no place");
    if (around[v].empty()) fault("a vertex without triangles");
    if (!one_fan(around[v], static_cast<int>(v))) fault("vertex " + std::to_string(v) + " has several fans");
  }
  std::vector<int> open = {0};
  std::set<int> reached = {0};
  while (!open.empty() && !s.triangles.empty()) {
    const int v = open.back();
    open.pop_back();
    for (const auto& t : around[v]) {
      for (const int w : t) {
        if (reached.insert(w).second) open.push_back(w);
      }
    }
  }
  if (reached.size() != s.vertices.size()) fault("several pieces");
  return result;
}

/// Six times the enclosed volume.
inline double six_volumes(const Surface& s) {
  double sum = 0;
  for (const auto& t : s.triangles) sum += s.vertices[t[0]].dot(s.vertices[t[1]].cross(s.vertices[t[2]]));
  return sum;
}

}  // namespace lissom::samples
