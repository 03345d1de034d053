#include "lissom/fabrication/stub_cut.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace lissom {

namespace {

/// m, height over the plane of a cut, towards the stub.
double height(const StubCut& cut, const Vec3& x) { return cut.step * (x - cut.station.centre).dot(cut.station.t); }

bool near_axis(const StubCut& cut, const Vec3& x) {
  const double h = height(cut, x);
  return std::abs(h) < cut.depth && (x - cut.station.centre - cut.station.t * (cut.step * h)).norm() < cut.reach;
}

/// m, where between -play and play no vertex is near: cuts there leave no needles, and their line is plane.
double best_shift(std::vector<double> heights, double play) {
  heights.push_back(-play);
  heights.push_back(play);
  std::sort(heights.begin(), heights.end());
  double shift = 0, widest = 0;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    if (heights[i] < -play || heights[i + 1] > play || heights[i + 1] - heights[i] <= widest) continue;
    widest = heights[i + 1] - heights[i];
    shift = (heights[i] + heights[i + 1]) / 2;
  }
  return shift;
}

/// Moves cuts within their play.
std::vector<StubCut> moved(std::vector<StubCut> cuts, const std::vector<Vec3>& vertices) {
  for (StubCut& cut : cuts) {
    const double radius = std::hypot(cut.reach, cut.depth);
    std::vector<double> heights;
    for (const Vec3& x : vertices) {
      if ((x - cut.station.centre).squaredNorm() > radius * radius || !near_axis(cut, x)) continue;
      heights.push_back(height(cut, x));
    }
    cut.station.centre += cut.station.t * (cut.step * best_shift(std::move(heights), cut.play));
  }
  return cuts;
}

/// Which stub every vertex belongs to, or -1.
std::vector<int> stubs_of(const std::vector<StubCut>& cuts, const std::vector<Vec3>& vertices) {
  std::vector<int> stub(vertices.size(), -1);
  for (std::size_t c = 0; c < cuts.size(); ++c) {
    const double radius = std::hypot(cuts[c].reach, cuts[c].depth);
    const Vec3 centre = cuts[c].station.centre;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      if ((vertices[v] - centre).squaredNorm() > radius * radius) continue;
      if (height(cuts[c], vertices[v]) > 0 && near_axis(cuts[c], vertices[v])) stub[v] = static_cast<int>(c);
    }
  }
  return stub;
}

class Cutter {
 public:
  Cutter(const std::vector<StubCut>& cuts, Surface& surface)
      : cuts_(cuts), surface_(surface), stub_(stubs_of(cuts, surface.vertices)), next_(cuts.size()) {}

  void cut() {
    std::vector<std::array<int, 3>> kept;
    for (const std::array<int, 3>& t : surface_.triangles) {
      int beyond = 0, cut = -1;
      for (const int v : t) {
        if (stub(v) < 0) continue;
        ++beyond;
        cut = stub(v);
      }
      if (beyond == 0) kept.push_back(t);
      if (beyond == 1 || beyond == 2) clip(t, static_cast<std::size_t>(cut), beyond, kept);
    }
    surface_.triangles = std::move(kept);
  }

  std::optional<std::vector<VertexRing>> rings() const {
    std::vector<VertexRing> rings;
    for (std::size_t c = 0; c < cuts_.size(); ++c) {
      const std::map<int, int>& next = next_[c];
      if (next.empty()) return std::nullopt;
      VertexRing ring;
      int v = next.begin()->first;
      do {
        ring.vertices.push_back(v);
        const auto following = next.find(v);
        if (following == next.end() || ring.vertices.size() > next.size()) return std::nullopt;
        v = following->second;
      } while (v != next.begin()->first);
      if (ring.vertices.size() != next.size()) return std::nullopt;
      if (!set_angles(cuts_[c].station, ring)) return std::nullopt;
      rings.push_back(ring);
    }
    return rings;
  }

 private:
  int stub(int v) const { return static_cast<std::size_t>(v) < stub_.size() ? stub_[v] : -1; }

  void clip(const std::array<int, 3>& t, std::size_t cut, int beyond, std::vector<std::array<int, 3>>& kept) {
    // Turned such that the corner that is alone comes first.
    std::size_t alone = 0;
    while ((stub(t[alone]) >= 0) != (beyond == 1)) ++alone;
    const int a = t[alone], b = t[(alone + 1) % 3], c = t[(alone + 2) % 3];
    if (beyond == 1) {
      const int ab = between(b, a, cut), ac = between(c, a, cut);
      kept.push_back({b, c, ac});
      kept.push_back({b, ac, ab});
      next_[cut][ac] = ab;
    } else {
      const int ab = between(a, b, cut), ac = between(a, c, cut);
      kept.push_back({a, ab, ac});
      next_[cut][ab] = ac;
    }
  }

  /// The vertex on the edge from one that stays to one that goes.
  int between(int stays, int goes, std::size_t cut) {
    const auto [entry, is_new] = between_.emplace(std::pair(stays, goes), static_cast<int>(surface_.vertices.size()));
    if (!is_new) return entry->second;
    const Vec3 from = surface_.vertices[stays], to = surface_.vertices[goes];
    const double h0 = height(cuts_[cut], from), h1 = height(cuts_[cut], to);
    surface_.vertices.push_back(from + (-h0 / (h1 - h0)) * (to - from));
    return entry->second;
  }

  /// Angles about the tangent, anticlockwise; false when the line does not go around once.
  bool set_angles(const RodStation& s, VertexRing& ring) const {
    constexpr double kTurn = 2 * std::numbers::pi;
    for (const int v : ring.vertices) {
      const Vec3 x = surface_.vertices[v] - s.centre;
      ring.angles.push_back(std::atan2(x.dot(s.n) / s.r_n, x.dot(s.b) / s.r_b));
    }
    double around = 0;
    const std::size_t n = ring.angles.size();
    for (std::size_t k = 0; k < n; ++k) around += std::remainder(ring.angles[(k + 1) % n] - ring.angles[k], kTurn);
    if (std::abs(std::abs(around) - kTurn) > 1e-6) return false;
    if (around < 0) {
      std::reverse(ring.vertices.begin(), ring.vertices.end());
      std::reverse(ring.angles.begin(), ring.angles.end());
    }
    for (std::size_t k = 1; k < n; ++k) {
      ring.angles[k] = ring.angles[k - 1] + std::remainder(ring.angles[k] - ring.angles[k - 1], kTurn);
    }
    return true;
  }

  const std::vector<StubCut>& cuts_;
  Surface& surface_;
  std::vector<int> stub_;
  std::vector<std::map<int, int>> next_;  // per cut: along the border of what stays
  std::map<std::pair<int, int>, int> between_;
};

}  // namespace

std::optional<std::vector<VertexRing>> cut_stubs(const std::vector<StubCut>& cuts, Surface& surface) {
  const std::vector<StubCut> own = moved(cuts, surface.vertices);
  Cutter cutter(own, surface);
  cutter.cut();
  return cutter.rings();
}

}  // namespace lissom
