#include "lissom/geometry/cell_growth.h"

#include <algorithm>
#include <queue>
#include <tuple>

#include "lissom/core/assert.h"

namespace lissom {

CellGrowth::CellGrowth(const Surface& surface) {
  std::vector<std::pair<int, int>> edges;
  edges.reserve(6 * surface.triangles.size());
  for (const std::array<int, 3>& corner : surface.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      edges.emplace_back(corner[i], corner[(i + 1) % 3]);
      edges.emplace_back(corner[(i + 1) % 3], corner[i]);
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  first_.assign(surface.vertices.size() + 1, 0);
  for (const auto& [a, b] : edges) {
    ++first_[static_cast<std::size_t>(a) + 1];
    neighbour_.push_back(b);
  }
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
}

std::span<const int> CellGrowth::around(int vertex) const {
  const auto v = static_cast<std::size_t>(vertex);
  return std::span(neighbour_)
      .subspan(static_cast<std::size_t>(first_[v]), static_cast<std::size_t>(first_[v + 1] - first_[v]));
}

std::vector<int> CellGrowth::grow(const Surface& surface, std::span<const Vec3> site,
                                  std::span<const int> start) const {
  LISSOM_ASSERT(site.size() == start.size());
  using Reach = std::tuple<double, int, int>;  // squared distance, vertex, cell
  std::priority_queue<Reach, std::vector<Reach>, std::greater<>> front;
  const auto distance = [&](int vertex, int cell) {
    return (surface.vertices[static_cast<std::size_t>(vertex)] - site[static_cast<std::size_t>(cell)]).squaredNorm();
  };
  std::vector<int> cell_of(surface.vertices.size(), -1);
  // Starts first, whatever is near: every cell keeps at least one vertex.
  for (int c = 0; c < static_cast<int>(start.size()); ++c) {
    int& own = cell_of[static_cast<std::size_t>(start[static_cast<std::size_t>(c)])];
    LISSOM_ASSERT(own < 0);
    own = c;
  }
  const auto go_on = [&](int vertex, int cell) {
    for (const int next : around(vertex)) {
      if (cell_of[static_cast<std::size_t>(next)] < 0) front.emplace(distance(next, cell), next, cell);
    }
  };
  for (int c = 0; c < static_cast<int>(start.size()); ++c) go_on(start[static_cast<std::size_t>(c)], c);
  while (!front.empty()) {
    const auto [reach, vertex, cell] = front.top();
    front.pop();
    int& own = cell_of[static_cast<std::size_t>(vertex)];
    if (own >= 0) continue;
    own = cell;
    go_on(vertex, cell);
  }
  return cell_of;
}

std::vector<int> CellGrowth::euler_numbers(const Surface& surface, std::span<const int> cell, int cells) const {
  std::vector<int> number(static_cast<std::size_t>(cells), 0);
  const auto cell_of = [&](int vertex) { return cell[static_cast<std::size_t>(vertex)]; };
  for (int v = 0; v < static_cast<int>(surface.vertices.size()); ++v) {
    if (cell_of(v) < 0) continue;
    int& own = number[static_cast<std::size_t>(cell_of(v))];
    ++own;
    for (const int next : around(v)) own -= next > v && cell_of(next) == cell_of(v) ? 1 : 0;
  }
  for (const std::array<int, 3>& corner : surface.triangles) {
    const int c = cell_of(corner[0]);
    if (c >= 0 && cell_of(corner[1]) == c && cell_of(corner[2]) == c) ++number[static_cast<std::size_t>(c)];
  }
  return number;
}

}  // namespace lissom
