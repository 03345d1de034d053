#include "lissom/model/membrane_rim.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace lissom {

namespace {

double length(const Structure& structure, const RimLoop& loop) {
  double sum = 0;
  for (const RimEdge& edge : loop) sum += (structure.nodes[edge.node1] - structure.nodes[edge.node0]).norm();
  return sum;
}

}  // namespace

std::vector<RimLoop> rim_loops(const Structure& structure, int membrane) {
  const StructureMembrane& part = structure.membranes[membrane];
  const int begin = part.first_triangle, end = begin + part.triangles;
  std::set<std::pair<int, int>> sides;
  for (int t = begin; t < end; ++t) {
    const std::array<int, 3>& node = structure.triangles[t].node;
    for (int i = 0; i < 3; ++i) sides.emplace(node[i], node[(i + 1) % 3]);
  }
  std::vector<RimEdge> edges;
  std::multimap<int, size_t> leaving;  // edges by their first node; a node may be on the rim twice
  for (int t = begin; t < end; ++t) {
    const std::array<int, 3>& node = structure.triangles[t].node;
    for (int i = 0; i < 3; ++i) {
      const int a = node[i], b = node[(i + 1) % 3];
      if (sides.contains({b, a})) continue;
      leaving.emplace(a, edges.size());
      edges.push_back({a, b, t, i});
    }
  }
  std::vector<RimLoop> loops;
  std::vector<bool> taken(edges.size(), false);
  for (size_t first = 0; first < edges.size(); ++first) {
    if (taken[first]) continue;
    RimLoop& loop = loops.emplace_back();
    for (size_t next = first; next < edges.size() && !taken[next];) {
      taken[next] = true;
      loop.push_back(edges[next]);
      const auto [from, to] = leaving.equal_range(edges[next].node1);
      const auto free = std::find_if(from, to, [&](const auto& entry) { return !taken[entry.second]; });
      next = free == to ? edges.size() : free->second;
    }
  }
  const auto longest = std::max_element(loops.begin(), loops.end(), [&](const RimLoop& a, const RimLoop& b) {
    return length(structure, a) < length(structure, b);
  });
  if (longest != loops.end()) std::rotate(loops.begin(), longest, longest + 1);
  return loops;
}

}  // namespace lissom
