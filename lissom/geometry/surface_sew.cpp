#include <algorithm>
#include <fmt/format.h>
#include <numeric>

#include "lissom/geometry/point_grid.h"
#include "lissom/geometry/surface_mending.h"

namespace lissom {

void drop_repeated_corners(Mending& mending) {
  const Triangles& triangles = mending.surface.triangles;
  std::vector<char> marked(triangles.size(), 0);
  SurfaceNote note{.what = "triangles with one corner twice", .places = {}, .done = "left out"};
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    if (a != b && b != c && c != a) continue;
    marked[t] = 1;
    note.add(mending.triangle_name(static_cast<int>(t)), mending.middle(static_cast<int>(t)));
  }
  if (note.count > 0) mending.drop(marked);
  mending.note(std::move(note));
}

void sew_rims(Mending& mending) {
  Surface& surface = mending.surface;
  const std::vector<int> mates = side_mates(surface.triangles);
  std::vector<char> at_rim(surface.vertices.size(), 0);
  for (int s = 0; s < static_cast<int>(mates.size()); ++s) {
    if (mates[s] >= 0) continue;
    at_rim[side_start(surface.triangles, s)] = at_rim[side_end(surface.triangles, s)] = 1;
  }
  // Stored points are further apart than the distance, so few share a cell of twice that size.
  const double distance = std::max(mending.options.merge, 1e-12) * mending.extent;
  PointGrid grid(distance, 2 * distance, static_cast<std::size_t>(std::count(at_rim.begin(), at_rim.end(), 1)));
  std::vector<int> first;  // vertex of each point in the grid
  std::vector<int> merged(surface.vertices.size());
  std::iota(merged.begin(), merged.end(), 0);
  bool any = false;
  for (int v = 0; v < static_cast<int>(merged.size()); ++v) {
    if (!at_rim[v]) continue;
    const int point = grid.insert(surface.vertices[v]);
    if (point == static_cast<int>(first.size())) first.push_back(v);
    merged[v] = first[point];
    any = any || merged[v] != v;
  }
  if (!any) return;
  mending.unsewn = surface.triangles;
  for (auto& t : surface.triangles) {
    for (int& v : t) v = merged[v];
  }
  drop_repeated_corners(mending);
}

namespace {

/// Number of the place of each vertex: the same for the same coordinates.
std::vector<int> places_of(const std::vector<Vec3>& vertices) {
  std::vector<int> order(vertices.size()), place(vertices.size());
  std::iota(order.begin(), order.end(), 0);
  const auto less = [&](int a, int b) {
    return std::lexicographical_compare(vertices[a].data(), vertices[a].data() + 3, vertices[b].data(),
                                        vertices[b].data() + 3);
  };
  // Those that no triangle uses may be no numbers, which have no order.
  order.erase(std::remove_if(order.begin(), order.end(), [&](int v) { return !vertices[v].allFinite(); }), order.end());
  std::sort(order.begin(), order.end(), less);
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[order[i]] = i > 0 && !less(order[i - 1], order[i]) ? place[order[i - 1]] : static_cast<int>(i);
  }
  return place;
}

}  // namespace

void drop_duplicates(Mending& mending) {
  const Triangles& triangles = mending.surface.triangles;
  const std::vector<int> place = places_of(mending.surface.vertices);
  std::vector<std::array<int, 4>> keys;  // places in order, then the triangle
  keys.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    std::array<int, 4> key = {place[triangles[t][0]], place[triangles[t][1]], place[triangles[t][2]],
                              static_cast<int>(t)};
    std::sort(key.begin(), key.begin() + 3);
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<char> marked(triangles.size(), 0);
  for (std::size_t i = 1; i < keys.size(); ++i) {
    if (std::equal(keys[i].begin(), keys[i].begin() + 3, keys[i - 1].begin())) marked[keys[i][3]] = 1;
  }
  SurfaceNote note{.what = "triangles that lie on another one with the same corners", .places = {}, .done = "left out"};
  for (std::size_t t = 0; t < marked.size(); ++t) {
    if (marked[t]) note.add(mending.triangle_name(static_cast<int>(t)), mending.middle(static_cast<int>(t)));
  }
  if (note.count > 0) mending.drop(marked);
  mending.note(std::move(note));
}

}  // namespace lissom
