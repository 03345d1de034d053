#include "lissom/model/plan_sampling.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "lissom/geometry/hermite_curve.h"
#include "lissom/geometry/planar_arc.h"
#include "lissom/model/limits.h"

namespace lissom {

namespace {

constexpr int kFewest = 4;           // edges of a piece whose length nobody gave: enough to bend and to buckle
constexpr double kLeastTurn = 1e-3;  // rad: what is asked below is beyond kMostNodes anyhow

double turn_between(const Vec2& a, const Vec2& b) {
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

/// Edges of a piece of this length: as long as asked, then more until no edge turns by more than asked. `turn(n)` is the
/// largest turn of an edge when there are n.
template <class Turn>
double edges_of(const Plan& plan, double length, const Turn& turn) {
  double n = plan.edge_length > 0 ? std::max(1.0, std::round(length / plan.edge_length)) : kFewest;
  const double allowed = std::max(plan.max_turn, kLeastTurn) * (1 + 1e-9);
  while (n < kMostNodes) {
    const double worst = turn(static_cast<int>(n));
    if (worst <= allowed) break;
    n = std::max({n + 1, std::floor(1.01 * n), std::ceil(0.9 * n * worst / allowed)});
  }
  return n;
}

/// One way to draw the pieces of a rod.
struct Spline {
  HermiteCurve<Vec2> curve;

  Vec2 at(int piece, double s) const { return curve.point(piece, s); }
  double edges(const Plan& plan, int piece) const {
    constexpr int kParts = 16;
    double length = 0;
    for (int k = 0; k < kParts; ++k) length += curve.slope(piece, (k + 0.5) / kParts).norm() / kParts;
    return edges_of(plan, length, [&](int n) {
      double worst = 0;
      Vec2 before = curve.slope(piece, 0);
      for (int k = 1; k <= n; ++k) {
        const Vec2 after = curve.slope(piece, double(k) / n);
        worst = std::max(worst, turn_between(before, after));
        before = after;
      }
      return worst;
    });
  }
};

struct Straight {
  const Plan& plan;
  const PlanRod& rod;

  Vec2 end(std::size_t i) const { return plan.points[static_cast<std::size_t>(rod.points[i % rod.points.size()])].at; }
  Vec2 at(int piece, double s) const {
    const std::size_t i = static_cast<std::size_t>(piece);
    return (1 - s) * end(i) + s * end(i + 1);
  }
  double edges(const Plan&, int piece) const {
    const std::size_t i = static_cast<std::size_t>(piece);
    return edges_of(plan, (end(i + 1) - end(i)).norm(), [](int) { return 0.0; });
  }
};

struct Arcs {
  const Plan& plan;
  const PlanRod& rod;

  PlanarPoint<double> place(std::size_t i) const {
    const Vec2& p = plan.points[static_cast<std::size_t>(rod.points[i])].at;
    return {p.x(), p.y()};
  }
  Vec2 at(int piece, double s) const {
    const auto [from, to, other] = arc_piece(rod, piece);
    const auto [x, y] = arc_point(place(from), place(to), place(other), s);
    return {x, y};
  }
  double edges(const Plan&, int piece) const {
    const auto [from, to, other] = arc_piece(rod, piece);
    const double half = std::abs(half_sweep(place(from), place(to), place(other)));
    const double chord = (at(piece, 1) - at(piece, 0)).norm();
    const double length = half < 1e-9 ? chord : chord * half / std::sin(half);
    return edges_of(plan, length, [&](int n) { return 2 * half / n; });
  }
};

Error too_many(std::size_t rod) {
  return {ErrorCode::kRange, fmt::format("/plan/rods/{}", rod),
          fmt::format("the plan would have more than {} nodes", kMostNodes), "use longer edges"};
}

template <class Curve>
Status cut(const Plan& plan, std::size_t r, double refine, const Curve& curve, PlanSamples& samples) {
  const PlanRod& rod = plan.rods[r];
  std::vector<int>& nodes = samples.rods.emplace_back();
  std::vector<int>& pieces = samples.pieces.emplace_back();
  for (int piece = 0; piece < piece_count(rod); ++piece) {
    const double wanted = std::max(1.0, std::round(refine * curve.edges(plan, piece)));
    if (!(wanted + double(samples.nodes.size()) <= kMostNodes)) return too_many(r);
    const int n = static_cast<int>(wanted);
    pieces.push_back(n);
    nodes.push_back(rod.points[static_cast<std::size_t>(piece)]);
    for (int step = 1; step < n; ++step) {
      nodes.push_back(static_cast<int>(samples.nodes.size()));
      samples.nodes.push_back(curve.at(piece, double(step) / n));
    }
  }
  if (!rod.closed) nodes.push_back(rod.points.back());
  return {};
}

Status cut(const Plan& plan, std::size_t r, double refine, PlanSamples& samples) {
  const PlanRod& rod = plan.rods[r];
  switch (rod.curve) {
    case PlanCurve::kStraight:
      return cut(plan, r, refine, Straight{plan, rod}, samples);
    case PlanCurve::kArc:
      return cut(plan, r, refine, Arcs{plan, rod}, samples);
    case PlanCurve::kSpline:
      break;
  }
  std::vector<Vec2> points;
  for (const int i : rod.points) points.push_back(plan.points[static_cast<std::size_t>(i)].at);
  return cut(plan, r, refine, Spline{{points, rod.closed}}, samples);
}

}  // namespace

ArcPiece arc_piece(const PlanRod& rod, int piece) {
  const std::size_t i = static_cast<std::size_t>(piece), n = rod.points.size(), next = (i + 1) % n;
  if (rod.closed && n == 3) return {i, next, (i + 2) % n};
  return i % 2 == 0 ? ArcPiece{i, next, (i + 2) % n} : ArcPiece{i, next, i - 1};
}

Result<PlanSamples> sample_plan(const Plan& plan, double refine) {
  if (!(refine > 0)) {
    return Error{ErrorCode::kRange, "/plan", fmt::format("the refinement is {:g}", refine), "give a number above zero"};
  }
  PlanSamples samples;
  for (const PlanPoint& point : plan.points) samples.nodes.push_back(point.at);
  for (std::size_t r = 0; r < plan.rods.size(); ++r) {
    if (Status s = cut(plan, r, refine, samples); !s) return s.error();
  }
  return samples;
}

}  // namespace lissom
