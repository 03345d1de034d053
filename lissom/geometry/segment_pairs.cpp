#include "lissom/geometry/segment_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lissom {

namespace {

constexpr double kRounding = 1e-9;  // of the lengths of two segments: how far off their crossing may be

double cross(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }

double point_distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 e = b - a;
  const double squared = e.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(e) / squared, 0.0, 1.0) : 0;
  return (a + t * e - p).norm();
}

}  // namespace

double segment_distance(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double s = cross(b - a, c - a), t = cross(b - a, d - a);
  const double u = cross(d - c, a - c), v = cross(d - c, b - c);
  const bool across = ((s > 0) != (t > 0)) && ((u > 0) != (v > 0)) && s != t && u != v;
  const double ends =
      std::min({point_distance(a, c, d), point_distance(b, c, d), point_distance(c, a, b), point_distance(d, a, b)});
  if (!across) return ends;
  // The signs are rounding where the segments lie in one line: believe in a crossing only where it is on both.
  const double crossing = point_distance(c + s / (s - t) * (d - c), a, b);
  return crossing <= kRounding * ((b - a).norm() + (d - c).norm()) ? 0 : std::min(ends, crossing);
}

std::vector<std::array<int, 2>> near_segments(std::span<const Vec2> points,
                                              std::span<const std::array<int, 2>> segments, double distance) {
  const auto start = [&](std::size_t k) -> const Vec2& { return points[static_cast<std::size_t>(segments[k][0])]; };
  const auto end = [&](std::size_t k) -> const Vec2& { return points[static_cast<std::size_t>(segments[k][1])]; };
  if (segments.empty()) return {};
  Vec2 low = start(0), high = low;
  double length = 0;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    low = low.cwiseMin(start(k)).cwiseMin(end(k));
    high = high.cwiseMax(start(k)).cwiseMax(end(k));
    length += (end(k) - start(k)).norm() / double(segments.size());
  }
  constexpr double kMostCells = 300;  // along a side, so that long segments among short ones stay affordable
  const double cell =
      std::max({2 * length, 2 * distance, (high - low).maxCoeff() / kMostCells, std::numeric_limits<double>::min()});
  // Cells that each segment may be near to, first and last column and row, within those where there are segments.
  using Cells = std::array<int, 4>;
  const auto number = [&](double x, double from) { return static_cast<int>(std::floor((x - from) / cell)); };
  const int columns = number(high.x(), low.x()) + 1, rows = number(high.y(), low.y()) + 1;
  std::vector<Cells> cells;
  std::vector<Vec2> lowest, highest;  // of each segment
  std::vector<int> first(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) + 1, 0);
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(x) * rows + y; };
  const auto for_cells = [](const Cells& of, const auto& body) {
    for (int x = of[0]; x <= of[1]; ++x) {
      for (int y = of[2]; y <= of[3]; ++y) body(x, y);
    }
  };
  for (std::size_t k = 0; k < segments.size(); ++k) {
    lowest.push_back(start(k).cwiseMin(end(k)));
    highest.push_back(start(k).cwiseMax(end(k)));
    const Vec2 from = lowest[k].array() - distance, to = highest[k].array() + distance;
    cells.push_back({std::max(number(from.x(), low.x()), 0), std::min(number(to.x(), low.x()), columns - 1),
                     std::max(number(from.y(), low.y()), 0), std::min(number(to.y(), low.y()), rows - 1)});
    for_cells(cells[k], [&](int x, int y) { ++first[at(x, y) + 1]; });
  }
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  std::vector<int> inside(static_cast<std::size_t>(first.back())), next(first.begin(), first.end() - 1);
  for (std::size_t k = 0; k < segments.size(); ++k) {
    for_cells(cells[k],
              [&](int x, int y) { inside[static_cast<std::size_t>(next[at(x, y)]++)] = static_cast<int>(k); });
  }
  const auto boxes_apart = [&](std::size_t a, std::size_t b) {
    return (lowest[a].cwiseMax(lowest[b]) - highest[a].cwiseMin(highest[b])).maxCoeff() > distance;
  };
  const auto joined = [&](std::size_t a, std::size_t b) {
    return segments[a][0] == segments[b][0] || segments[a][0] == segments[b][1] || segments[a][1] == segments[b][0] ||
           segments[a][1] == segments[b][1];
  };
  std::vector<std::array<int, 2>> pairs;
  const auto look = [&](int x, int y) {
    for (int i = first[at(x, y)]; i < first[at(x, y) + 1]; ++i) {
      for (int j = i + 1; j < first[at(x, y) + 1]; ++j) {
        const auto a = static_cast<std::size_t>(inside[i]), b = static_cast<std::size_t>(inside[j]);
        // Of the cells that both are in, the first alone counts.
        if (x != std::max(cells[a][0], cells[b][0]) || y != std::max(cells[a][2], cells[b][2])) continue;
        if (boxes_apart(a, b)) continue;
        if (!joined(a, b) && segment_distance(start(a), end(a), start(b), end(b)) > distance) continue;
        pairs.push_back({inside[i], inside[j]});
      }
    }
  };
  for_cells({0, columns - 1, 0, rows - 1}, look);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace lissom
