#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <optional>
#include <set>

#include "lissom/geometry/surface_mending.h"

namespace lissom {

namespace {

constexpr std::size_t kMostHoleSides = 64;  // a lid takes the cube of it

std::uint64_t edge_key(int a, int b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint32_t>(std::max(a, b));
}

/// The edges of a surface, and of the lids on it.
class Edges {
 public:
  explicit Edges(const Triangles& triangles) {
    keys_.reserve(3 * triangles.size());
    for (const auto& t : triangles) {
      for (int i = 0; i < 3; ++i) keys_.push_back(edge_key(t[i], t[(i + 1) % 3]));
    }
    std::sort(keys_.begin(), keys_.end());
  }
  void add(const Triangles& lid) {
    for (const auto& t : lid) {
      for (int i = 0; i < 3; ++i) added_.insert(edge_key(t[i], t[(i + 1) % 3]));
    }
  }
  bool has(int a, int b) const {
    return std::binary_search(keys_.begin(), keys_.end(), edge_key(a, b)) || added_.count(edge_key(a, b)) > 0;
  }

 private:
  std::vector<std::uint64_t> keys_;
  std::set<std::uint64_t> added_;
};

/// The triangulation of a ring of vertices with the least area [Barequet, Sharir 1995], without thin triangles and without
/// edges that the surface has already. Empty when there is none.
class Lid {
 public:
  Lid(const Mending& mending, const Edges& edges, std::vector<int> ring)
      : mending_(mending), edges_(edges), ring_(std::move(ring)), n_(static_cast<int>(ring_.size())) {}

  Triangles triangles() {
    area_.assign(static_cast<std::size_t>(n_) * n_, 0);
    split_.assign(area_.size(), -1);
    for (int span = 2; span < n_; ++span) {
      for (int i = 0; i + span < n_; ++i) solve(i, i + span);
    }
    Triangles found;
    if (std::isfinite(area_[at(0, n_ - 1)])) collect(0, n_ - 1, found);
    return found;
  }

 private:
  std::size_t at(int i, int j) const { return static_cast<std::size_t>(i) * n_ + j; }
  const Vec3& place(int i) const { return mending_.surface.vertices[ring_[i]]; }

  /// The best lid over the part of the ring from i to j.
  void solve(int i, int j) {
    double& best = area_[at(i, j)];
    best = INFINITY;
    const bool whole = i == 0 && j == n_ - 1;
    if (!whole && edges_.has(ring_[i], ring_[j])) return;
    for (int m = i + 1; m < j; ++m) {
      const double parts = area_[at(i, m)] + area_[at(m, j)];
      if (parts >= best || mending_.is_thin(place(i), place(m), place(j))) continue;
      const double area = parts + 0.5 * (place(m) - place(i)).cross(place(j) - place(i)).norm();
      if (area >= best) continue;
      best = area;
      split_[at(i, j)] = m;
    }
  }

  void collect(int i, int j, Triangles& found) const {
    if (j - i < 2) return;
    const int m = split_[at(i, j)];
    found.push_back({ring_[i], ring_[m], ring_[j]});
    collect(i, m, found);
    collect(m, j, found);
  }

  const Mending& mending_;
  const Edges& edges_;
  std::vector<int> ring_;
  int n_;
  std::vector<double> area_;  // m^2, of the best lid over a part, by its ends
  std::vector<int> split_;
};

struct Hole {
  std::vector<int> ring;  ///< against the direction of its triangles: as a lid runs around
  Vec3 middle = Vec3::Zero();
  double diagonal = 0;  ///< m, of the box around it
  double length = 0;    ///< m
};

Hole hole_of(const Surface& surface, const std::vector<int>& loop) {
  Hole hole;
  Eigen::AlignedBox3d box;
  for (auto side = loop.rbegin(); side != loop.rend(); ++side) {
    const int end = side_end(surface.triangles, *side);
    hole.ring.push_back(end);
    box.extend(surface.vertices[end]);
    hole.length += (surface.vertices[end] - surface.vertices[side_start(surface.triangles, *side)]).norm();
  }
  hole.middle = box.center();
  hole.diagonal = box.diagonal().norm();
  return hole;
}

std::string name_of(const Hole& hole) {
  return fmt::format("a hole of {} sides, {:.3g} mm around,", hole.ring.size(), 1000 * hole.length);
}

}  // namespace

namespace {

/// A ring that meets itself in a vertex has no lid.
bool is_simple(std::vector<int> ring) {
  std::sort(ring.begin(), ring.end());
  return std::adjacent_find(ring.begin(), ring.end()) == ring.end();
}

std::vector<Hole> small_holes(const Mending& mending) {
  std::vector<Hole> holes;
  for (const auto& loop : rim_loops(mending.surface.triangles, side_mates(mending.surface.triangles))) {
    Hole hole = hole_of(mending.surface, loop);
    if (hole.diagonal <= mending.options.small_hole * mending.extent) holes.push_back(std::move(hole));
  }
  return holes;
}

}  // namespace

void close_small_holes(Mending& mending) {
  if (mending.options.holes != SurfaceRepairOptions::Holes::kFill) return;
  Triangles& triangles = mending.surface.triangles;
  SurfaceNote closed{.what = "small holes", .places = {}, .done = "closed"};
  std::optional<Edges> edges;
  for (const Hole& hole : small_holes(mending)) {
    if (hole.ring.size() > kMostHoleSides || !is_simple(hole.ring)) continue;
    if (!edges) edges.emplace(triangles);
    const Triangles lid = Lid(mending, *edges, hole.ring).triangles();
    if (lid.empty()) continue;
    closed.add(name_of(hole), hole.middle);
    edges->add(lid);
    triangles.insert(triangles.end(), lid.begin(), lid.end());
    mending.origins.resize(triangles.size(), -1);
    if (!mending.unsewn.empty()) mending.unsewn.insert(mending.unsewn.end(), lid.begin(), lid.end());
  }
  mending.note(std::move(closed));
}

void note_small_holes(Mending& mending) {
  const bool filled = mending.options.holes == SurfaceRepairOptions::Holes::kFill;
  SurfaceNote kept{.what = filled ? "small holes that no lid fits on" : "small holes",
                   .places = {},
                   .done = filled ? "kept as rims" : "kept as rims (--fill-holes closes them)"};
  for (const Hole& hole : small_holes(mending)) kept.add(name_of(hole), hole.middle);
  mending.note(std::move(kept), SurfaceNote::Outcome::kKept);
}

}  // namespace lissom
