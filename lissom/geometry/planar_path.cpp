#include "lissom/geometry/planar_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lissom/geometry/planar_arc.h"

namespace lissom {

namespace {

Vec2 on_arc(const Vec2& from, const Vec2& to, const Vec2& other, double s) {
  const auto pair = [](const Vec2& p) { return PlanarPoint<double>(p.x(), p.y()); };
  const auto [x, y] = arc_point(pair(from), pair(to), pair(other), s);
  return {x, y};
}

Vec2 unit(const Vec2& v) { return v.norm() > 0 ? Vec2(v.normalized()) : Vec2::UnitX(); }

/// The first of these differences that is not nothing.
Vec2 first_direction(const Vec2& at, const Vec2& next, const Vec2& second, const Vec2& last) {
  const double least = 1e-9 * (last - at).norm();
  if ((next - at).norm() > least) return unit(next - at);
  return (second - at).norm() > least ? unit(second - at) : unit(last - at);
}

}  // namespace

Vec2 PathPiece::at(double s) const {
  switch (kind) {
    case Kind::kLine:
      return (1 - s) * from + s * to;
    case Kind::kArc:
      return s < 0.5 ? on_arc(from, a, to, 2 * s) : on_arc(a, to, from, 2 * s - 1);
    case Kind::kCubic:
      break;
  }
  const double r = 1 - s;
  return r * r * r * from + 3 * r * r * s * a + 3 * r * s * s * b + s * s * s * to;
}

Vec2 PathPiece::start_direction() const {
  if (kind == Kind::kLine) return unit(to - from);
  if (kind == Kind::kCubic) return first_direction(from, a, b, to);
  return unit(at(1e-4) - from);
}

Vec2 PathPiece::end_direction() const {
  if (kind == Kind::kLine) return unit(to - from);
  if (kind == Kind::kCubic) return -first_direction(to, b, a, from);
  return unit(to - at(1 - 1e-4));
}

Vec2 circle_centre(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 u = b - a, v = c - a;
  const double twice = 2 * (u.x() * v.y() - u.y() * v.x());
  const double uu = u.squaredNorm(), vv = v.squaredNorm();
  return a + Vec2(v.y() * uu - u.y() * vv, u.x() * vv - v.x() * uu) / twice;
}

double sweep_of(const PathPiece& arc) {
  const auto pair = [](const Vec2& p) { return PlanarPoint<double>(p.x(), p.y()); };
  return 2 * half_sweep(pair(arc.from), pair(arc.a), pair(arc.to)) +
         2 * half_sweep(pair(arc.a), pair(arc.to), pair(arc.from));
}

PlanarPath ellipse_path(const Vec2& centre, double rx, double ry, double turn, double start, double sweep) {
  const Vec2 x = rx * Vec2(std::cos(turn), std::sin(turn)), y = ry * Vec2(-std::sin(turn), std::cos(turn));
  const auto place = [&](double angle) -> Vec2 { return centre + std::cos(angle) * x + std::sin(angle) * y; };
  const auto slope = [&](double angle) -> Vec2 { return std::cos(angle) * y - std::sin(angle) * x; };
  const bool circle = std::abs(rx - ry) <= 1e-9 * std::max(rx, ry);
  const double most = circle ? 2 * std::numbers::pi / 3 : std::numbers::pi / 4;
  const int n = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / most - 1e-9)));
  const double step = sweep / n, handle = 4.0 / 3 * std::tan(step / 4);
  PlanarPath path;
  for (int k = 0; k < n; ++k) {
    const double from = start + k * step, to = start + (k + 1) * step;
    path.push_back(circle ? PathPiece::arc(place(from), place((from + to) / 2), place(to))
                          : PathPiece::cubic(place(from), place(from) + handle * slope(from),
                                             place(to) - handle * slope(to), place(to)));
    if (k > 0) path.back().from = path[path.size() - 2].to;
  }
  return path;
}

}  // namespace lissom
