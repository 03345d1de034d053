#include <fmt/format.h>
#include <numeric>

#include "lissom/geometry/surface_mending.h"

namespace lissom {

namespace {

bool is_closed(const std::vector<int>& mates) {
  for (const int mate : mates) {
    if (mate < 0) return false;
  }
  return true;
}

void turn(std::array<int, 3>& triangle) { std::swap(triangle[1], triangle[2]); }

Error one_sided(const Mending& mending, int side) {
  const Triangles& triangles = mending.surface.triangles;
  return {ErrorCode::kGeometry, mending.triangle_place(side / 3),
          fmt::format(
              "the surface has one side only, like a Moebius strip: its triangles cannot all be turned alike, at {}",
              in_millimetres(mending.surface.vertices[side_start(triangles, side)])),
          "cut it open across the strip"};
}

/// Which triangles have to be turned for all to be like the first.
Status find_turned(const Mending& mending, const std::vector<int>& mates, std::vector<char>& turned) {
  const Triangles& triangles = mending.surface.triangles;
  turned.assign(triangles.size(), 2);  // 2: not known yet
  std::vector<int> open;
  for (int first = 0; first < static_cast<int>(triangles.size()); ++first) {
    if (turned[first] != 2) continue;
    turned[first] = 0;
    open.push_back(first);
    while (!open.empty()) {
      const int t = open.back();
      open.pop_back();
      for (int s = 3 * t; s < 3 * t + 3; ++s) {
        if (mates[s] < 0) continue;
        const int other = mates[s] / 3;
        const bool against = side_start(triangles, s) == side_start(triangles, mates[s]);
        const char wanted = static_cast<char>(against ? 1 - turned[t] : turned[t]);
        if (turned[other] == 2) {
          turned[other] = wanted;
          open.push_back(other);
        } else if (turned[other] != wanted) {
          return one_sided(mending, s);
        }
      }
    }
  }
  return {};
}

}  // namespace

Status turn_alike(Mending& mending) {
  Surface& surface = mending.surface;
  const std::vector<int> mates = side_mates(surface.triangles);
  std::vector<char> turned;
  if (Status s = find_turned(mending, mates, turned); !s) return s;
  double kept_area = 0, turned_area = 0;
  for (std::size_t t = 0; t < turned.size(); ++t) {
    (turned[t] ? turned_area : kept_area) += area_vector(surface, static_cast<int>(t)).norm();
    if (turned[t]) turn(surface.triangles[t]);
  }
  // Open surfaces: as most of them were. Closed ones: outward.
  const bool other_way = is_closed(mates) ? enclosed_volume(surface) < 0 : turned_area > kept_area;
  SurfaceNote note{.what = "triangles turned against their neighbours, or inward", .places = {}, .done = "turned over"};
  for (std::size_t t = 0; t < turned.size(); ++t) {
    if (other_way) turn(surface.triangles[t]);
    if ((turned[t] != 0) != other_way)
      note.add(mending.triangle_name(static_cast<int>(t)), mending.middle(static_cast<int>(t)));
  }
  mending.note(std::move(note));
  return {};
}

void turn_outward(Mending& mending) {
  Surface& surface = mending.surface;
  if (!is_closed(side_mates(surface.triangles)) || enclosed_volume(surface) >= 0) return;
  for (auto& t : surface.triangles) turn(t);
  SurfaceNote note{.what = "triangles turned inward", .places = {}, .done = "turned over"};
  note.count = static_cast<int>(surface.triangles.size());
  mending.note(std::move(note));
}

void split_fans(Mending& mending) {
  Surface& surface = mending.surface;
  const std::vector<int> mates = side_mates(surface.triangles);
  // Corners are in one fan when a side connects them.
  std::vector<int> root(mates.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int c) {
    while (root[c] != c) c = root[c] = root[root[c]];
    return c;
  };
  const auto next = [](int side) { return side % 3 == 2 ? side - 2 : side + 1; };
  for (int s = 0; s < static_cast<int>(mates.size()); ++s) {
    if (mates[s] < s) continue;
    // Neighbours are turned alike by now: where one side starts the other ends.
    for (const auto& [a, b] : {std::pair(find(s), find(next(mates[s]))), std::pair(find(next(s)), find(mates[s]))}) {
      root[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<int> first_fan(surface.vertices.size(), -1), own_vertex(mates.size(), -1);
  SurfaceNote note{
      .what = "vertices in which parts of the surface only touch", .places = {}, .done = "made one for each part"};
  for (int c = 0; c < static_cast<int>(mates.size()); ++c) {
    const int v = surface.triangles[c / 3][c % 3], fan = find(c);
    if (first_fan[v] < 0) first_fan[v] = fan;
    if (first_fan[v] == fan) continue;
    if (own_vertex[fan] < 0) {
      own_vertex[fan] = static_cast<int>(surface.vertices.size());
      const Vec3 at = surface.vertices[v];
      surface.vertices.push_back(at);
      first_fan.push_back(fan);
      if (!surface.darkness.empty()) surface.darkness.push_back(double(surface.darkness[v]));
      note.add(fmt::format("vertex {}", v), at);
    }
    surface.triangles[c / 3][c % 3] = own_vertex[fan];
  }
  mending.note(std::move(note));
}

}  // namespace lissom
