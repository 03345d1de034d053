#include <fmt/format.h>

#include "lissom/geometry/surface_mending.h"

namespace lissom {

namespace {

bool is_closed(const std::vector<int>& mates) {
  for (const int mate : mates) {
    if (mate < 0) return false;
  }
  return true;
}

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
    if (turned[t]) mending.turn_over(static_cast<int>(t));
  }
  // Open surfaces: as most of them were. Closed ones: outward.
  const bool other_way = is_closed(mates) ? enclosed_volume(surface) < 0 : turned_area > kept_area;
  SurfaceNote note{.what = "triangles turned against their neighbours, or inward", .places = {}, .done = "turned over"};
  for (std::size_t t = 0; t < turned.size(); ++t) {
    if (other_way) mending.turn_over(static_cast<int>(t));
    if ((turned[t] != 0) != other_way)
      note.add(mending.triangle_name(static_cast<int>(t)), mending.middle(static_cast<int>(t)));
  }
  mending.note(std::move(note));
  return {};
}

void turn_outward(Mending& mending) {
  Surface& surface = mending.surface;
  if (!is_closed(side_mates(surface.triangles)) || enclosed_volume(surface) >= 0) return;
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) mending.turn_over(t);
  SurfaceNote note{.what = "triangles turned inward", .places = {}, .done = "turned over"};
  note.count = static_cast<int>(surface.triangles.size());
  mending.note(std::move(note));
}

namespace {

/// Vertices that were in use before sewing and are not any more.
void note_sewn(Mending& mending) {
  std::vector<char> used(mending.surface.vertices.size(), 0), before(used.size(), 0);
  for (std::size_t t = 0; t < mending.unsewn.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      used[mending.surface.triangles[t][i]] = 1;
      before[mending.unsewn[t][i]] = 1;
    }
  }
  SurfaceNote note{.what = "vertices in the place of another one", .places = {}, .done = "merged with it"};
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (before[v] && !used[v]) note.add(fmt::format("vertex {}", v), mending.surface.vertices[v]);
  }
  mending.note(std::move(note));
}

}  // namespace

void split_fans(Mending& mending) {
  Surface& surface = mending.surface;
  const std::vector<int> fans = corner_fans(side_mates(surface.triangles));
  std::vector<int> first_fan(surface.vertices.size(), -1);  // by vertex
  for (std::size_t c = 0; c < fans.size(); ++c) {
    int& first = first_fan[surface.triangles[c / 3][c % 3]];
    if (first < 0) first = fans[c];
  }
  std::vector<int> own_vertex(fans.size(), -1);  // by fan, of those that are not the first at their vertex
  SurfaceNote note{
      .what = "vertices in which parts of the surface only touch", .places = {}, .done = "made one for each part"};
  for (std::size_t c = 0; c < fans.size(); ++c) {
    const int v = surface.triangles[c / 3][c % 3], fan = fans[c];
    if (first_fan[v] == fan) continue;
    if (own_vertex[fan] < 0) {
      const int before = mending.unsewn.empty() ? v : mending.unsewn[c / 3][c % 3];
      own_vertex[fan] = first_fan[before] < 0 ? before : static_cast<int>(surface.vertices.size());
      if (own_vertex[fan] == before) {
        first_fan[before] = fan;
      } else {
        surface.vertices.push_back(Vec3(surface.vertices[v]));
        if (!surface.darkness.empty()) surface.darkness.push_back(double{surface.darkness[v]});
        first_fan.push_back(fan);
        note.add(fmt::format("vertex {}", v), surface.vertices[v]);
      }
    }
    surface.triangles[c / 3][c % 3] = own_vertex[fan];
  }
  if (!mending.unsewn.empty()) note_sewn(mending);
  mending.unsewn.clear();
  mending.note(std::move(note));
}

}  // namespace lissom
