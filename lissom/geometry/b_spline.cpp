#include "lissom/geometry/b_spline.h"

#include <algorithm>
#include <cmath>

namespace lissom {

namespace {

constexpr int kMostDegree = 16;

/// Polar form of the span [knots[k], knots[k + 1]] at `degree` arguments, in homogeneous coordinates: de Boor's triangle
/// with an argument of its own in each step.
Vec3 blossom(const BSpline& s, int k, const std::vector<double>& at) {
  std::vector<Vec3> row;
  for (int i = k - s.degree; i <= k; ++i) {
    const double w = s.weights.empty() ? 1 : s.weights[static_cast<std::size_t>(i)];
    const Vec2& p = s.points[static_cast<std::size_t>(i)];
    row.emplace_back(w * p.x(), w * p.y(), w);
  }
  const auto knot = [&](int i) { return s.knots[static_cast<std::size_t>(i)]; };
  for (int level = 1; level <= s.degree; ++level) {
    for (int j = s.degree; j >= level; --j) {
      const double low = knot(k - s.degree + j), high = knot(k + 1 + j - level);
      const double a = high > low ? (at[static_cast<std::size_t>(level) - 1] - low) / (high - low) : 0;
      row[static_cast<std::size_t>(j)] =
          (1 - a) * row[static_cast<std::size_t>(j) - 1] + a * row[static_cast<std::size_t>(j)];
    }
  }
  return row.back();
}

Vec2 projected(const Vec3& p) { return p.head<2>() / p.z(); }

Vec2 value(const BSpline& s, int k, double u) {
  return projected(blossom(s, k, std::vector<double>(static_cast<std::size_t>(s.degree), u)));
}

bool is_spline(const BSpline& s) {
  if (s.degree < 1 || s.degree > kMostDegree || s.points.size() < static_cast<std::size_t>(s.degree) + 1) return false;
  if (s.knots.size() != s.points.size() + static_cast<std::size_t>(s.degree) + 1) return false;
  if (!s.weights.empty() && s.weights.size() != s.points.size()) return false;
  for (const double w : s.weights) {
    if (!(w > 0)) return false;
  }
  return std::is_sorted(s.knots.begin(), s.knots.end());
}

/// The curve between two places of one span.
PathPiece piece_of(const BSpline& s, int k, double u, double v) {
  const Vec2 from = value(s, k, u), to = value(s, k, v);
  if (s.degree == 1 && s.weights.empty()) return PathPiece::line(from, to);
  if (s.degree == 2 && s.weights.empty()) {
    const Vec2 middle = projected(blossom(s, k, {u, v}));
    return PathPiece::cubic(from, from + 2.0 / 3 * (middle - from), to + 2.0 / 3 * (middle - to), to);
  }
  if (s.degree == 3 && s.weights.empty()) {
    return PathPiece::cubic(from, projected(blossom(s, k, {u, u, v})), projected(blossom(s, k, {u, v, v})), to);
  }
  const double h = 1e-4 * (v - u);  // differences of second order from within the span
  const Vec2 start = (4 * value(s, k, u + h) - value(s, k, u + 2 * h) - 3 * from) / (2 * h);
  const Vec2 end = (3 * to - 4 * value(s, k, v - h) + value(s, k, v - 2 * h)) / (2 * h);
  return PathPiece::cubic(from, from + (v - u) / 3 * start, to - (v - u) / 3 * end, to);
}

}  // namespace

PlanarPath bezier_pieces(const BSpline& spline) {
  if (!is_spline(spline)) return {};
  const bool exact = spline.weights.empty() && spline.degree <= 3;
  const int parts = exact ? 1 : 8, last = static_cast<int>(spline.points.size());
  PlanarPath path;
  for (int k = spline.degree; k < last; ++k) {
    const double low = spline.knots[static_cast<std::size_t>(k)], high = spline.knots[static_cast<std::size_t>(k) + 1];
    if (!(high > low)) continue;
    for (int i = 0; i < parts; ++i) {
      path.push_back(piece_of(spline, k, low + (high - low) * i / parts, low + (high - low) * (i + 1) / parts));
      if (path.size() > 1) path.back().from = path[path.size() - 2].to;
    }
  }
  return path;
}

}  // namespace lissom
