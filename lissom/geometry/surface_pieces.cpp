#include <algorithm>
#include <fmt/format.h>
#include <numeric>

#include "lissom/geometry/surface_mending.h"

namespace lissom {

namespace {

struct PieceSizes {
  std::vector<double> areas;               ///< m^2
  std::vector<Eigen::AlignedBox3d> boxes;  ///< m
  double largest = 0, sum = 0;             ///< m^2
};

PieceSizes sizes_of(const Surface& surface, const SurfacePieces& pieces) {
  PieceSizes sizes;
  sizes.areas.assign(pieces.count, 0);
  sizes.boxes.resize(pieces.count);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    sizes.areas[pieces.of[t]] += 0.5 * area_vector(surface, static_cast<int>(t)).norm();
    for (const int v : surface.triangles[t]) sizes.boxes[pieces.of[t]].extend(surface.vertices[v]);
  }
  sizes.largest = *std::max_element(sizes.areas.begin(), sizes.areas.end());
  sizes.sum = std::accumulate(sizes.areas.begin(), sizes.areas.end(), 0.0);
  return sizes;
}

/// Sides that more than two triangles have, as (low vertex, high vertex, side), in this order.
std::vector<std::array<int, 3>> crowded_sides(const Triangles& triangles, const std::vector<int>& mates) {
  std::vector<std::array<int, 3>> crowded;
  for (int s = 0; s < static_cast<int>(mates.size()); ++s) {
    if (mates[s] != kCrowded) continue;
    const int a = side_start(triangles, s), b = side_end(triangles, s);
    crowded.push_back({std::min(a, b), std::max(a, b), s});
  }
  std::sort(crowded.begin(), crowded.end());
  return crowded;
}

/// Pieces that share a crowded side hang together too.
SurfacePieces joined(const SurfacePieces& pieces, const std::vector<std::array<int, 3>>& crowded) {
  std::vector<int> root(pieces.count);
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int p) {
    while (root[p] != p) p = root[p] = root[root[p]];
    return p;
  };
  for (std::size_t i = 1; i < crowded.size(); ++i) {
    if (crowded[i][0] != crowded[i - 1][0] || crowded[i][1] != crowded[i - 1][1]) continue;
    const int a = find(pieces.of[crowded[i][2] / 3]), b = find(pieces.of[crowded[i - 1][2] / 3]);
    root[std::max(a, b)] = std::min(a, b);
  }
  std::vector<int> number(pieces.count, -1);
  SurfacePieces together;
  for (int p = 0; p < pieces.count; ++p) {
    if (find(p) == p) number[p] = together.count++;
  }
  for (const int p : pieces.of) together.of.push_back(number[find(p)]);
  return together;
}

/// Leaves out the pieces that are marked, and notes them.
void drop_pieces(Mending& mending, const SurfacePieces& pieces, const PieceSizes& sizes,
                 const std::vector<char>& marked, const std::string& what) {
  SurfaceNote note{.what = what, .places = {}, .done = "left out"};
  for (int p = 0; p < pieces.count; ++p) {
    if (!marked[p]) continue;
    note.add(
        fmt::format("a piece of {} and {:.3g} mm^2", size_in_millimetres(sizes.boxes[p].sizes()), 1e6 * sizes.areas[p]),
        sizes.boxes[p].center());
  }
  std::vector<char> triangles(pieces.of.size(), 0);
  for (std::size_t t = 0; t < pieces.of.size(); ++t) triangles[t] = marked[pieces.of[t]];
  mending.drop(triangles);
  mending.note(std::move(note));
}

/// Pieces far smaller than the largest, when they are little altogether.
std::vector<char> debris(const PieceSizes& sizes, double fraction) {
  std::vector<char> marked(sizes.areas.size(), 0);
  double lost = 0;
  for (std::size_t p = 0; p < marked.size(); ++p) {
    if (sizes.areas[p] > fraction * sizes.largest) continue;
    marked[p] = 1;
    lost += sizes.areas[p];
  }
  if (lost > 10 * fraction * sizes.largest) marked.assign(marked.size(), 0);
  return marked;
}

bool any(const std::vector<char>& marked) { return std::find(marked.begin(), marked.end(), 1) != marked.end(); }

Error several_pieces(const Mending& mending, const PieceSizes& sizes) {
  std::vector<int> order(sizes.areas.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return sizes.areas[a] > sizes.areas[b]; });
  std::string list;
  for (std::size_t i = 0; i < std::min<std::size_t>(order.size(), SurfaceNote::kMost); ++i) {
    const Eigen::AlignedBox3d& box = sizes.boxes[order[i]];
    list +=
        fmt::format("{}{} at {}", i > 0 ? "; " : "", size_in_millimetres(box.sizes()), in_millimetres(box.center()));
  }
  return {ErrorCode::kGeometry, mending.where,
          fmt::format("the surface has {} separate pieces: {}{}", order.size(), list,
                      order.size() > SurfaceNote::kMost ? "; ..." : ""),
          "join them in the program that made them, bring them one by one, or keep the largest (--keep-largest)"};
}

Error crowded_side(const Mending& mending, const std::vector<std::array<int, 3>>& crowded) {
  const auto same = [](const auto& a, const auto& b) { return a[0] == b[0] && a[1] == b[1]; };
  std::size_t places = 1, meeting = 1;
  for (std::size_t i = 1; i < crowded.size(); ++i) places += !same(crowded[i], crowded[i - 1]);
  while (meeting < crowded.size() && same(crowded[meeting], crowded[0])) ++meeting;
  const Vec3 at = 0.5 * (mending.surface.vertices[crowded[0][0]] + mending.surface.vertices[crowded[0][1]]);
  return {ErrorCode::kGeometry, mending.triangle_place(crowded[0][2] / 3),
          fmt::format("{} triangles meet in the edge between vertices {} and {} at {}{}", meeting, crowded[0][0],
                      crowded[0][1], in_millimetres(at),
                      places > 1 ? fmt::format(", and more than two in {} other edges", places - 1) : ""),
          "remove walls inside the surface and sheets that hang on it (in Blender: Select All by Trait, Non Manifold)"};
}

}  // namespace

Status leave_one_piece(Mending& mending) {
  constexpr int kRounds = 20;  // what hangs on debris falls with it, in a few rounds at most
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<int> mates = side_mates(mending.surface.triangles);
    const SurfacePieces pieces = surface_pieces(mates);
    if (pieces.count == 1) break;
    const auto crowded = crowded_sides(mending.surface.triangles, mates);
    const SurfacePieces together = joined(pieces, crowded);
    const PieceSizes sizes = sizes_of(mending.surface, together), parts = sizes_of(mending.surface, pieces);
    std::vector<char> marked = debris(sizes, mending.options.debris);
    const std::vector<char> hanging = debris(parts, mending.options.debris);
    if (any(marked)) {
      drop_pieces(mending, together, sizes, marked, "loose pieces, far smaller than the rest");
    } else if (any(hanging)) {
      drop_pieces(mending, pieces, parts, hanging, "scraps that hang on an edge between two other triangles");
    } else if (together.count > 1) {
      if (mending.options.pieces == SurfaceRepairOptions::Pieces::kRefuse) return several_pieces(mending, sizes);
      marked.assign(marked.size(), 1);
      marked[std::max_element(sizes.areas.begin(), sizes.areas.end()) - sizes.areas.begin()] = 0;
      drop_pieces(mending, together, sizes, marked, "pieces besides the largest");
    } else {
      break;
    }
  }
  const auto crowded = crowded_sides(mending.surface.triangles, side_mates(mending.surface.triangles));
  if (!crowded.empty()) return crowded_side(mending, crowded);
  return {};
}

}  // namespace lissom
