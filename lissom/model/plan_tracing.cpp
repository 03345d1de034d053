#include "lissom/model/plan_tracing.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lissom/geometry/hermite_curve.h"
#include "lissom/geometry/segment_pairs.h"

namespace lissom {

namespace {

constexpr double kCorner = 0.17;  // rad, between cubics: less is taken for smooth
constexpr int kParts = 32;        // of a curved piece, when it is searched

bool breaks(const PathPiece& before, const PathPiece& after) {
  if (before.kind != after.kind) return true;
  if (before.kind != PathPiece::Kind::kCubic) return false;
  const Vec2 u = before.end_direction(), v = after.start_direction();
  return std::abs(std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v))) > kCorner;
}

/// The runs as short segments.
struct Chords {
  std::vector<Vec2> points;
  std::vector<std::array<int, 2>> ends;
  std::vector<int> run;
  std::vector<double> from, to;  // places

  explicit Chords(const std::vector<Run>& runs) {
    for (std::size_t r = 0; r < runs.size(); ++r) {
      for (std::size_t k = 0; k < runs[r].path.size(); ++k) {
        const int parts = runs[r].kind() == PathPiece::Kind::kLine ? 1 : kParts;
        for (int i = 0; i < parts; ++i) {
          ends.push_back({static_cast<int>(points.size()), static_cast<int>(points.size()) + 1});
          from.push_back(double(k) + double(i) / parts);
          to.push_back(double(k) + double(i + 1) / parts);
          run.push_back(static_cast<int>(r));
          points.push_back(runs[r].path[k].at(double(i) / parts));
          points.push_back(runs[r].path[k].at(double(i + 1) / parts));
        }
      }
    }
  }
};

double cross(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }

/// Where two segments are nearest to each other, as parts of each.
Vec2 nearest_parts(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Vec2 u = b - a, v = d - c;
  const double turn = cross(u, v);
  if (turn != 0) {
    const double s = cross(c - a, v) / turn, t = cross(c - a, u) / turn;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) return {s, t};
  }
  Vec2 best = Vec2::Zero();
  double least = -1;
  const auto consider = [&](double s, double t) {
    const double distance = (a + s * u - c - t * v).norm();
    if (least >= 0 && distance >= least) return;
    least = distance;
    best = {s, t};
  };
  const auto project = [](const Vec2& p, const Vec2& from, const Vec2& along) {
    return along.squaredNorm() > 0 ? std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0.0;
  };
  consider(0, project(a, c, v));
  consider(1, project(b, c, v));
  consider(project(c, a, u), 0);
  consider(project(d, a, u), 1);
  return best;
}

/// Brings two places where curves cross onto the crossing itself: the chords are a little off.
void sharpen(const Run& a, const Run& b, double& s, double& t) {
  constexpr double kStep = 1e-6;
  for (int round = 0; round < 4; ++round) {
    const double s0 = std::clamp(s, kStep, a.length() - kStep), t0 = std::clamp(t, kStep, b.length() - kStep);
    const Vec2 u = (a.at(s0 + kStep) - a.at(s0 - kStep)) / (2 * kStep);
    const Vec2 v = (b.at(t0 + kStep) - b.at(t0 - kStep)) / (2 * kStep);
    const double turn = cross(u, v);
    if (std::abs(turn) < 1e-3 * u.norm() * v.norm()) return;
    const Vec2 gap = b.at(t) - a.at(s);
    s = std::clamp(s + cross(gap, v) / turn, 0.0, a.length());
    t = std::clamp(t + cross(gap, u) / turn, 0.0, b.length());
  }
}

/// Stops that are hardly apart become one, at a node of the run where there is one.
void tidy(Run& run, double tolerance) {
  for (double& stop : run.stops) {
    const double node = std::round(stop);
    if ((run.at(node) - run.at(stop)).norm() <= 2 * tolerance) stop = node;
    if (run.closed && stop >= run.length()) stop -= run.length();
  }
  std::sort(run.stops.begin(), run.stops.end());
  std::vector<double> kept;
  for (const double stop : run.stops) {
    if (!kept.empty() && (run.at(stop) - run.at(kept.back())).norm() <= 2 * tolerance && stop - kept.back() < 0.5) {
      if (stop == std::round(stop)) kept.back() = stop;
      continue;
    }
    kept.push_back(stop);
  }
  run.stops = std::move(kept);
}

/// A run as many points, to measure along and against.
class Ruler {
 public:
  explicit Ruler(const Run& run) : run_(run) {
    const int n = static_cast<int>(run.path.size()) * kParts;
    for (int i = 0; i <= n; ++i) {
      points_.push_back(run.at(double(i) / kParts));
      along_.push_back(
          i == 0 ? 0
                 : along_.back() +
                       (points_[static_cast<std::size_t>(i)] - points_[static_cast<std::size_t>(i) - 1]).norm());
    }
  }

  double length() const { return along_.back(); }

  double along(double place) const {
    const double x = std::clamp(place, 0.0, run_.length()) * kParts;
    const std::size_t i = std::min(static_cast<std::size_t>(x), along_.size() - 2);
    return along_[i] + (x - double(i)) * (along_[i + 1] - along_[i]);
  }

  double place(double length) const {
    const auto above = std::upper_bound(along_.begin() + 1, along_.end() - 1, length);
    const std::size_t i = static_cast<std::size_t>(above - along_.begin()) - 1;
    const double step = along_[i + 1] - along_[i];
    return (double(i) + (step > 0 ? std::clamp((length - along_[i]) / step, 0.0, 1.0) : 0)) / kParts;
  }

  /// Distance of a point from the part of the run between two places; `to` may lie beyond the end of a closed one.
  double distance(const Vec2& p, double from, double to) const {
    const int n = static_cast<int>(points_.size()) - 1;
    const int first = static_cast<int>(std::floor(from * kParts)) - 1,
              last = static_cast<int>(std::ceil(to * kParts)) + 1;
    double least = (points_[0] - p).norm() + length();
    for (int i = first; i < last; ++i) {
      if (!run_.closed && (i < 0 || i >= n)) continue;
      const std::size_t k = static_cast<std::size_t>(((i % n) + n) % n);
      least = std::min(least, segment_distance(points_[k], points_[k + 1], p, p));
    }
    return least;
  }

 private:
  const Run& run_;
  std::vector<Vec2> points_;
  std::vector<double> along_;
};

/// How far the spline through these places strays from the run.
double straying(const Run& run, const Ruler& ruler, const std::vector<double>& places) {
  if (places.size() < (run.closed ? 3u : 2u)) return ruler.length();
  std::vector<Vec2> points;
  for (const double place : places) points.push_back(run.at(place));
  const HermiteCurve<Vec2> curve(points, run.closed);
  double worst = 0;
  for (int k = 0; k < curve.pieces(); ++k) {
    const std::size_t i = static_cast<std::size_t>(k);
    const double to = i + 1 < places.size() ? places[i + 1] : places[0] + run.length();
    for (int step = 1; step < 12; ++step)
      worst = std::max(worst, ruler.distance(curve.point(k, step / 12.0), places[i], to));
  }
  return worst;
}

/// The stops, and between them so many places that no two are further apart than `spacing` (m).
std::vector<double> spread(const Run& run, const Ruler& ruler, double spacing) {
  std::vector<double> anchors = run.stops, places;
  if (run.closed && anchors.empty()) anchors.push_back(0);
  const std::size_t spans = run.closed ? anchors.size() : anchors.size() - 1;
  for (std::size_t k = 0; k < spans; ++k) {
    const double from = ruler.along(anchors[k]);
    double to = k + 1 < anchors.size() ? ruler.along(anchors[k + 1]) : ruler.along(anchors[0]) + ruler.length();
    const int n = std::max(1, static_cast<int>(std::ceil((to - from) / spacing - 1e-9)));
    places.push_back(anchors[k]);
    for (int i = 1; i < n; ++i) {
      const double length = from + (to - from) * i / n;
      places.push_back(ruler.place(length > ruler.length() ? length - ruler.length() : length));
    }
  }
  if (!run.closed) places.push_back(anchors.back());
  if (run.closed) std::sort(places.begin(), places.end());
  return places;
}

}  // namespace

Vec2 Run::at(double place) const {
  const double n = length(), p = closed ? place - n * std::floor(place / n) : std::clamp(place, 0.0, n);
  const std::size_t k = std::min(static_cast<std::size_t>(p), path.size() - 1);
  return path[k].at(p - double(k));
}

std::vector<Run> runs_of(const PlanDrawing& drawing, double tolerance) {
  std::vector<Run> runs;
  for (std::size_t l = 0; l < drawing.lines.size(); ++l) {
    PlanarPath path;
    for (const PathPiece& piece : drawing.lines[l].path) {
      const double size = std::max((piece.to - piece.from).norm(), (piece.a - piece.from).norm());
      if (size > tolerance / 10) path.push_back(piece);
    }
    if (path.empty()) continue;
    const bool closed = drawing.lines[l].closed || (path.back().to - path.front().from).norm() <= tolerance;
    if (closed && (path.back().to - path.front().from).norm() > tolerance) {
      path.push_back(PathPiece::line(path.back().to, path.front().from));
    }
    std::size_t first = path.size();
    for (std::size_t k = 0; k < path.size() && first == path.size(); ++k) {
      if (closed && breaks(path[(k + path.size() - 1) % path.size()], path[k])) first = k;
    }
    const bool whole = closed && first == path.size();
    if (closed && !whole) std::rotate(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(first), path.end());
    for (std::size_t k = 0; k < path.size(); ++k) {
      if (k == 0 || (!whole && breaks(path[k - 1], path[k]))) runs.push_back({static_cast<int>(l), {}, whole, {}});
      runs.back().path.push_back(path[k]);
    }
  }
  for (Run& run : runs) {
    if (!run.closed) run.stops = {0, run.length()};
  }
  return runs;
}

void find_meetings(std::vector<Run>& runs, double tolerance) {
  const Chords chords(runs);
  for (const auto& [i, j] : near_segments(chords.points, chords.ends, tolerance)) {
    const std::size_t p = static_cast<std::size_t>(i), q = static_cast<std::size_t>(j);
    Run &a = runs[static_cast<std::size_t>(chords.run[p])], &b = runs[static_cast<std::size_t>(chords.run[q])];
    const double gap = std::abs(chords.from[q] - chords.from[p]);
    const double apart = a.closed ? std::min(gap, a.length() - gap) : gap;
    if (&a == &b && apart < 1.5 * (chords.to[p] - chords.from[p])) continue;
    const auto at = [&](std::size_t k, std::size_t end) -> const Vec2& {
      return chords.points[static_cast<std::size_t>(chords.ends[k][end])];
    };
    const Vec2 parts = nearest_parts(at(p, 0), at(p, 1), at(q, 0), at(q, 1));
    double s = chords.from[p] + parts[0] * (chords.to[p] - chords.from[p]);
    double t = chords.from[q] + parts[1] * (chords.to[q] - chords.from[q]);
    sharpen(a, b, s, t);
    if ((a.at(s) - b.at(t)).norm() > 2 * tolerance) continue;
    a.stops.push_back(s);
    b.stops.push_back(t);
  }
  for (Run& run : runs) tidy(run, tolerance);
}

std::vector<double> spline_places(const Run& run, double tolerance, double& strays) {
  const Ruler ruler(run);
  std::vector<double> nodes = run.stops;
  for (std::size_t k = 0; k < run.path.size() + (run.closed ? 0 : 1); ++k) nodes.push_back(double(k));
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  strays = straying(run, ruler, nodes);
  if (strays <= tolerance) return nodes;
  constexpr int kMost = 256;
  std::vector<double> best = nodes;
  for (int n = run.closed ? 3 : 1; n <= kMost && strays > tolerance; n += 1 + n / 4) {
    const std::vector<double> places = spread(run, ruler, ruler.length() / n);
    const double now = straying(run, ruler, places);
    if (now >= strays) continue;
    strays = now;
    best = places;
  }
  return best;
}

}  // namespace lissom
