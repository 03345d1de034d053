#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "lissom/geometry/surface_mending.h"

namespace lissom {

namespace {

/// Edits a surface whose triangles are turned alike, with at most two at a side and one fan at a vertex; every edit keeps
/// it so. A needle (two corners nearly in one place) loses its short side, a cap (one corner nearly on the opposite
/// side) exchanges its long side for the other diagonal [Botsch, Kobbelt 2001, without their slicing].
class ThinTriangles {
 public:
  explicit ThinTriangles(Mending& mending)
      : mending_(mending), triangles_(mending.surface.triangles), at_(mending.surface.vertices.size()) {
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
      for (const int v : triangles_[t]) at_[v].push_back(t);
    }
    dropped_.assign(triangles_.size(), 0);
    work_left_ = 50 * static_cast<long long>(triangles_.size()) + 1'000'000;
  }

  Status mend() {
    constexpr int kRounds = 12;
    std::vector<int> thin = thin_ones();
    for (int round = 0; round < kRounds && !thin.empty() && work_left_ > 0; ++round) {
      bool changed = false;
      for (const int t : thin) {
        if (!dropped_[t] && work_left_ > 0 && mending_.is_thin(t)) changed = mend(t) || changed;
      }
      if (!changed) break;
      thin = thin_ones();
    }
    if (!thin.empty()) return refused(thin);
    mending_.drop(dropped_);
    mending_.note(std::move(needles_));
    mending_.note(std::move(caps_));
    return {};
  }

 private:
  const Vec3& place(int v) const { return mending_.surface.vertices[v]; }

  std::vector<int> thin_ones() const {
    std::vector<int> thin;
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
      if (!dropped_[t] && mending_.is_thin(t)) thin.push_back(t);
    }
    return thin;
  }

  Error refused(const std::vector<int>& thin) const {
    const int t = thin.front();
    return {ErrorCode::kGeometry, mending_.triangle_place(t),
            fmt::format("the triangle at {} is {:.2g} mm high and cannot be mended without folding the surface{}",
                        in_millimetres(mending_.middle(t)), 1000 * mending_.height(t),
                        thin.size() > 1 ? fmt::format(" (and {} others)", thin.size() - 1) : ""),
            "remesh the surface there in the program that made it"};
  }

  /// Side i of t runs from corner i to the next.
  double length(int t, int i) const { return (place(triangles_[t][(i + 1) % 3]) - place(triangles_[t][i])).norm(); }

  bool mend(int t) {
    int shortest = 0, longest = 0;
    for (int i = 1; i < 3; ++i) {
      if (length(t, i) < length(t, shortest)) shortest = i;
      if (length(t, i) > length(t, longest)) longest = i;
    }
    const double least = std::max(mending_.options.merge * mending_.extent, mending_.options.thin * length(t, longest));
    const std::string name = mending_.triangle_name(t);
    const Vec3 at = mending_.middle(t);
    const bool needle = length(t, shortest) < 4 * least;
    if (needle && collapse(t, shortest)) return needles_.add(name, at), true;
    if (exchange(t, longest)) return caps_.add(name, at), true;
    if (!needle && length(t, shortest) < 20 * least && collapse(t, shortest)) return needles_.add(name, at), true;
    return false;
  }

  /// Triangles that have both vertices.
  std::vector<int> between(int a, int b) {
    std::vector<int> found;
    for (const int t : at_[a]) {
      if (std::find(triangles_[t].begin(), triangles_[t].end(), b) != triangles_[t].end()) found.push_back(t);
    }
    work_left_ -= static_cast<long long>(at_[a].size());
    return found;
  }

  std::vector<int> neighbours(int v) {
    std::vector<int> found;
    for (const int t : at_[v]) {
      for (const int w : triangles_[t]) {
        if (w != v) found.push_back(w);
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    work_left_ -= static_cast<long long>(at_[v].size());
    return found;
  }

  /// So many triangles at a corner that editing them one by one would take forever.
  bool crowded(int t) const {
    return std::any_of(triangles_[t].begin(), triangles_[t].end(), [&](int v) { return at_[v].size() > kMostAround; });
  }

  bool on_rim(int v) { return neighbours(v).size() != at_[v].size(); }

  int opposite(int t, int a, int b) const {
    for (const int v : triangles_[t]) {
      if (v != a && v != b) return v;
    }
    return -1;
  }

  Vec3 normal(int a, int b, int c) const { return (place(b) - place(a)).cross(place(c) - place(a)); }

  /// Merges the ends of side i of t, at the place of the one whose neighbours bear it.
  bool collapse(int t, int i) {
    const int a = triangles_[t][i], b = triangles_[t][(i + 1) % 3];
    if (crowded(t) || !may_merge(a, b)) return false;
    const bool b_first = on_rim(b) && !on_rim(a);
    for (const auto& [kept, gone] :
         {b_first ? std::pair(b, a) : std::pair(a, b), b_first ? std::pair(a, b) : std::pair(b, a)}) {
      if (!bears_move(gone, kept)) continue;
      merge(kept, gone);
      return true;
    }
    return false;
  }

  /// Whether the surface stays one without crowded sides when a and b become one vertex (the link condition).
  bool may_merge(int a, int b) {
    const std::vector<int> both = between(a, b), around_a = neighbours(a), around_b = neighbours(b);
    std::vector<int> common;
    std::set_intersection(around_a.begin(), around_a.end(), around_b.begin(), around_b.end(),
                          std::back_inserter(common));
    if (common.size() != both.size()) return false;
    const bool rim_a = around_a.size() != at_[a].size(), rim_b = around_b.size() != at_[b].size();
    if (both.size() == 2 && rim_a && rim_b) return false;
    if (at_[a].size() + at_[b].size() - 2 * both.size() < (rim_a || rim_b ? 1 : 3)) return false;
    for (const int t : both) {
      // A triangle that would be left hanging by its tip, or laid on another one.
      const int c = opposite(t, a, b);
      if (at_[c].size() > kMostAround) return false;
      if (between(a, c).size() < 2 && between(b, c).size() < 2) return false;
      if (both.size() == 2) {
        const int d = opposite(t == both[0] ? both[1] : both[0], a, b);
        if (has_triangle(a, c, d) && has_triangle(b, c, d)) return false;
      }
    }
    return true;
  }

  bool has_triangle(int a, int b, int c) {
    for (const int t : between(a, b)) {
      if (opposite(t, a, b) == c) return true;
    }
    return false;
  }

  /// Whether no triangle at `gone` folds over or becomes thin when that moves to `kept`.
  bool bears_move(int gone, int kept) const {
    for (const int t : at_[gone]) {
      std::array<int, 3> moved = triangles_[t];
      if (std::find(moved.begin(), moved.end(), kept) != moved.end()) continue;
      if (mending_.is_thin(t)) continue;
      std::replace(moved.begin(), moved.end(), gone, kept);
      const Vec3 before = normal(triangles_[t][0], triangles_[t][1], triangles_[t][2]);
      if (before.dot(normal(moved[0], moved[1], moved[2])) <= 0) return false;
      if (mending_.is_thin(place(moved[0]), place(moved[1]), place(moved[2]))) return false;
    }
    return true;
  }

  void merge(int kept, int gone) {
    const std::vector<int> around = at_[gone];
    for (const int t : around) {
      if (std::find(triangles_[t].begin(), triangles_[t].end(), kept) != triangles_[t].end()) {
        remove(t);
        continue;
      }
      std::replace(triangles_[t].begin(), triangles_[t].end(), gone, kept);
      at_[kept].push_back(t);
    }
    at_[gone].clear();
  }

  void remove(int t) {
    dropped_[t] = 1;
    for (const int v : triangles_[t]) {
      work_left_ -= static_cast<long long>(at_[v].size());
      std::erase(at_[v], t);
    }
  }

  /// Side i of t and its neighbour's triangle give way to the other diagonal; at a rim the triangle goes.
  bool exchange(int t, int i) {
    const int a = triangles_[t][i], b = triangles_[t][(i + 1) % 3], c = triangles_[t][(i + 2) % 3];
    if (crowded(t)) return false;
    const std::vector<int> both = between(a, b);
    if (both.size() == 1) return leave_out_at_rim(t, a, b, c);
    const int other = both[0] == t ? both[1] : both[0], d = opposite(other, a, b);
    if (!between(c, d).empty()) return false;
    const Vec3 up = normal(a, b, c) + normal(b, a, d);
    if (up.dot(normal(a, d, c)) <= 0 || up.dot(normal(d, b, c)) <= 0) return false;
    const double before = std::min(slimness(a, b, c), slimness(b, a, d));
    if (std::min(slimness(a, d, c), slimness(d, b, c)) <= before) return false;
    triangles_[t] = {a, d, c};
    triangles_[other] = {d, b, c};
    std::erase(at_[b], t);
    at_[d].push_back(t);
    std::erase(at_[a], other);
    at_[c].push_back(other);
    return true;
  }

  /// Height over the longest side in its lengths.
  double slimness(int a, int b, int c) const {
    const double longest = std::max({(place(b) - place(a)).squaredNorm(), (place(c) - place(b)).squaredNorm(),
                                     (place(a) - place(c)).squaredNorm()});
    return longest > 0 ? normal(a, b, c).norm() / longest : 0;
  }

  bool leave_out_at_rim(int t, int a, int b, int c) {
    const std::size_t rims = 1 + (between(b, c).size() == 1) + (between(c, a).size() == 1);
    if (rims == 3 || (rims == 1 && on_rim(c))) return false;
    remove(t);
    return true;
  }

  static constexpr std::size_t kMostAround = 10'000;  // triangles at a corner that is edited

  Mending& mending_;
  Triangles& triangles_;
  std::vector<std::vector<int>> at_;  // triangles by vertex
  std::vector<char> dropped_;
  long long work_left_ = 0;
  SurfaceNote needles_{.what = "needles (triangles with two corners nearly in one place)",
                       .places = {},
                       .done = "their short sides closed up"};
  SurfaceNote caps_{.what = "caps (triangles with a corner nearly on the opposite side)",
                    .places = {},
                    .done = "their long sides exchanged, or left out at a rim"};
};

}  // namespace

Status mend_thin_triangles(Mending& mending) {
  bool any = false;
  for (int t = 0; t < static_cast<int>(mending.surface.triangles.size()) && !any; ++t) any = mending.is_thin(t);
  if (!any) return {};
  return ThinTriangles(mending).mend();
}

}  // namespace lissom
