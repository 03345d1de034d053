#include "lissom/geometry/planar_smoothing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lissom {

namespace {

using Triangles = std::vector<std::array<int, 3>>;

/// The triangles at each vertex that may move, compressed.
class Stars {
 public:
  Stars(const Triangles& triangles, std::size_t points, std::size_t fixed) : triangles_(triangles), fixed_(fixed) {
    start_.assign(points - fixed + 1, 0);
    const auto each = [&](const auto& use) {
      for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (const int v : triangles[t]) {
          if (static_cast<std::size_t>(v) >= fixed) use(static_cast<std::size_t>(v) - fixed, static_cast<int>(t));
        }
      }
    };
    each([&](std::size_t v, int) { ++start_[v + 1]; });
    for (std::size_t v = 0; v + 1 < start_.size(); ++v) start_[v + 1] += start_[v];
    list_.resize(static_cast<std::size_t>(start_.back()));
    std::vector<int> next(start_.begin(), start_.end() - 1);
    each([&](std::size_t v, int t) { list_[static_cast<std::size_t>(next[v]++)] = t; });
  }

  /// Calls use(b, c) for the triangles (v, b, c), anticlockwise, at vertex v.
  template <class Use>
  void around(std::size_t v, const Use& use) const {
    for (int k = start_[v - fixed_]; k < start_[v - fixed_ + 1]; ++k) {
      const auto& t = triangles_[static_cast<std::size_t>(list_[static_cast<std::size_t>(k)])];
      const int corner = t[0] == static_cast<int>(v) ? 0 : t[1] == static_cast<int>(v) ? 1 : 2;
      use(static_cast<std::size_t>(t[static_cast<std::size_t>((corner + 1) % 3)]),
          static_cast<std::size_t>(t[static_cast<std::size_t>((corner + 2) % 3)]));
    }
  }

  /// Smallest angle of the triangles at v if it were at `place`.
  double worst(const std::vector<Vec2>& points, std::size_t v, const Vec2& place) const {
    double least = std::numbers::pi;
    around(v,
           [&](std::size_t b, std::size_t c) { least = std::min(least, smallest_angle(place, points[b], points[c])); });
    return least;
  }

 private:
  const Triangles& triangles_;
  std::size_t fixed_;
  std::vector<int> start_, list_;
};

}  // namespace

double smallest_angle(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 e = b - a, f = c - b, g = a - c;
  const double twice = e.x() * -g.y() + e.y() * g.x();
  // The smallest angle lies opposite to the shortest edge, between the two others.
  const double ee = e.squaredNorm(), ff = f.squaredNorm(), gg = g.squaredNorm();
  const double cosine = ee <= ff && ee <= gg ? -f.dot(g) : ff <= gg ? -g.dot(e) : -e.dot(f);
  return std::atan2(twice, cosine);
}

void even_out(std::vector<Vec2>& points, std::size_t fixed, const Triangles& triangles) {
  const Stars stars(triangles, points.size(), fixed);
  for (std::size_t v = fixed; v < points.size(); ++v) {
    Vec2 sum = Vec2::Zero();
    int count = 0;
    stars.around(v, [&](std::size_t b, std::size_t c) {
      sum += points[b] + points[c];
      count += 2;
    });
    if (count == 0) continue;
    const Vec2 place = sum / count;
    constexpr double kFlat = 0.2;  // rad: the triangulation that follows mends what is better than this
    if (stars.worst(points, v, place) >= std::min(kFlat, stars.worst(points, v, points[v]))) points[v] = place;
  }
}

void open_worst_angles(std::vector<Vec2>& points, std::size_t fixed, const Triangles& triangles, double angle) {
  constexpr int kSweeps = 12, kDirections = 8;
  const Stars stars(triangles, points.size(), fixed);
  std::vector<double> worst(points.size(), 0), step(points.size(), 0);
  for (std::size_t v = fixed; v < points.size(); ++v) {
    double shortest = std::numeric_limits<double>::infinity();
    stars.around(v, [&](std::size_t b, std::size_t) { shortest = std::min(shortest, (points[b] - points[v]).norm()); });
    step[v] = shortest / 4;
  }
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    bool moved = false;
    for (std::size_t v = fixed; v < points.size(); ++v) {
      const double now = stars.worst(points, v, points[v]);
      if (now >= angle) continue;
      double best = now;
      Vec2 place = points[v];
      for (int k = 0; k < kDirections; ++k) {
        const double turn = 2 * std::numbers::pi * k / kDirections;
        const Vec2 trial = points[v] + step[v] * Vec2(std::cos(turn), std::sin(turn));
        const double there = stars.worst(points, v, trial);
        if (there <= best) continue;
        best = there;
        place = trial;
      }
      if (best > now) {
        points[v] = place;
      } else {
        step[v] /= 2;
      }
      moved = true;
    }
    if (!moved) return;
  }
}

}  // namespace lissom
