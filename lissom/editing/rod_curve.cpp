#include "lissom/editing/rod_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lissom/editing/plan_tools.h"
#include "lissom/geometry/planar_arc.h"
#include "lissom/model/plan_sampling.h"

namespace lissom {

namespace {

constexpr int kParts = 64;  // of a piece, for searching and measuring
constexpr int kRounds = 60;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

struct Part {
  int piece = 0;
  double from = 0;  // s
  Vec2 a, b;
};

std::vector<Part> parts_of(const RodCurve& curve) {
  std::vector<Part> parts;
  for (int piece = 0; piece < curve.pieces(); ++piece) {
    for (int k = 0; k < kParts; ++k) {
      const double from = double(k) / kParts;
      const Vec2 a = k == 0 ? curve.point(piece, 0) : parts.back().b;
      parts.push_back({piece, from, a, curve.point(piece, double(k + 1) / kParts)});
    }
  }
  return parts;
}

RodPlace place_on(const RodCurve& curve, const Part& part, double share) {
  RodPlace place{part.piece, part.from + share / kParts, Vec2::Zero(), 0};
  place.at = curve.point(place.piece, place.s);
  return place;
}

}  // namespace

RodCurve::RodCurve(const Plan& plan, const PlanRod& rod) : plan_(plan), rod_(rod) {
  if (rod.curve != PlanCurve::kSpline) return;
  std::vector<Vec2> places;
  for (const int i : rod.points) places.push_back(plan.points[static_cast<std::size_t>(i)].at);
  spline_.emplace(places, rod.closed);
}

int RodCurve::pieces() const { return piece_count(rod_); }

Vec2 RodCurve::point(int piece, double s) const {
  if (spline_) return spline_->point(piece, s);
  const auto at = [&](std::size_t i) -> const Vec2& {
    return plan_.points[static_cast<std::size_t>(rod_.points[i % rod_.points.size()])].at;
  };
  const std::size_t i = static_cast<std::size_t>(piece);
  if (rod_.curve == PlanCurve::kStraight) return (1 - s) * at(i) + s * at(i + 1);
  const ArcPiece arc = arc_piece(rod_, piece);
  const auto place = [&](std::size_t k) { return PlanarPoint<double>(at(k).x(), at(k).y()); };
  const auto [x, y] = arc_point(place(arc.from), place(arc.to), place(arc.other), s);
  return {x, y};
}

RodPlace RodCurve::nearest(const Vec2& to) const {
  RodPlace best;
  best.distance = std::numeric_limits<double>::infinity();
  const auto look = [&](int piece, double s) {
    const Vec2 at = point(piece, s);
    const double distance = (at - to).norm();
    if (distance < best.distance) best = {piece, s, at, distance};
  };
  for (int piece = 0; piece < pieces(); ++piece) {
    for (int k = 0; k <= kParts; ++k) look(piece, double(k) / kParts);
  }
  const int piece = best.piece;
  double low = std::max(best.s - 1.0 / kParts, 0.0), high = std::min(best.s + 1.0 / kParts, 1.0);
  for (int round = 0; round < kRounds; ++round) {
    const double third = (high - low) / 3;
    if ((point(piece, low + third) - to).norm() < (point(piece, high - third) - to).norm()) {
      high -= third;
    } else {
      low += third;
    }
  }
  look(piece, (low + high) / 2);
  return best;
}

double RodCurve::length(int piece) const {
  double length = 0;
  for (int k = 0; k < kParts; ++k) {
    length += (point(piece, double(k + 1) / kParts) - point(piece, double(k) / kParts)).norm();
  }
  return length;
}

double RodCurve::length() const {
  double length = 0;
  for (int piece = 0; piece < pieces(); ++piece) length += this->length(piece);
  return length;
}

double RodCurve::length_to(const RodPlace& place) const {
  double length = 0;
  for (int piece = 0; piece < place.piece; ++piece) length += this->length(piece);
  Vec2 before = point(place.piece, 0);
  for (int k = 1; k <= kParts; ++k) {
    const Vec2 after = point(place.piece, place.s * k / kParts);
    length += (after - before).norm();
    before = after;
  }
  return length;
}

RodPlace RodCurve::at_length(double length) const {
  for (const Part& part : parts_of(*this)) {
    const double own = (part.b - part.a).norm();
    if (length <= own) return place_on(*this, part, own > 0 ? std::max(length, 0.0) / own : 0);
    length -= own;
  }
  return {pieces() - 1, 1, point(pieces() - 1, 1), 0};
}

double radius_at(const Plan& plan, const PlanRod& rod, const RodPlace& place, double PlanPoint::*radius) {
  const std::size_t i = static_cast<std::size_t>(place.piece), n = rod.points.size();
  const double a = plan.points[static_cast<std::size_t>(rod.points[i])].*radius;
  const double b = plan.points[static_cast<std::size_t>(rod.points[(i + 1) % n])].*radius;
  return a == b ? a : rounded_radius((1 - place.s) * a + place.s * b);
}

void put_on_rod(Plan& plan, std::size_t r, const RodPlace& place, int point) {
  const std::size_t n = plan.rods[r].points.size();
  const auto begin = [&] { return plan.rods[r].points.begin() + place.piece + 1; };
  if (plan.rods[r].curve != PlanCurve::kArc || (plan.rods[r].closed && n == 3)) {
    plan.rods[r].points.insert(begin(), point);
    return;
  }
  // The other half of the arc that is cut in two needs a point of its own.
  const bool first_half = place.piece % 2 == 0;
  RodPlace half{place.piece, first_half ? place.s / 2 : (place.s + 1) / 2, Vec2::Zero(), 0};
  half.at = RodCurve(plan, plan.rods[r]).point(half.piece, half.s);
  const double r_n = radius_at(plan, plan.rods[r], half, &PlanPoint::r_n);
  const double r_b = radius_at(plan, plan.rods[r], half, &PlanPoint::r_b);
  const int helper = add_point(plan, half.at, r_n, r_b);
  plan.rods[r].points.insert(begin(), point);
  plan.rods[r].points.insert(first_half ? begin() : begin() + 1, helper);
}

OnRod point_on_rod(Plan& plan, std::size_t r, const Vec2& at) {
  const PlanRod& rod = plan.rods[r];
  const RodPlace place = RodCurve(plan, rod).nearest(at);
  for (const int i : rod.points) {
    const PlanPoint& point = plan.points[static_cast<std::size_t>(i)];
    if ((point.at - place.at).norm() <= point.r_b) return {i, false};
  }
  const double r_n = radius_at(plan, rod, place, &PlanPoint::r_n), r_b = radius_at(plan, rod, place, &PlanPoint::r_b);
  const int point = add_point(plan, place.at, r_n, r_b);
  put_on_rod(plan, r, place, point);
  return {point, true};
}

std::optional<RodCrossing> first_crossing(const Plan& plan, std::size_t a, std::size_t b) {
  const RodCurve curve_a(plan, plan.rods[a]), curve_b(plan, plan.rods[b]);
  const std::vector<Part> parts_b = parts_of(curve_b);
  std::vector<Vec2> shared;
  for (const int i : plan.rods[a].points) {
    const std::vector<int>& other = plan.rods[b].points;
    if (std::find(other.begin(), other.end(), i) == other.end()) continue;
    shared.push_back(plan.points[static_cast<std::size_t>(i)].at);
  }
  for (const Part& own : parts_of(curve_a)) {
    const Vec2 u = own.b - own.a;
    for (const Part& other : parts_b) {
      const Vec2 v = other.b - other.a, w = other.a - own.a;
      const double det = cross(u, v);
      if (std::abs(det) <= 1e-12 * u.norm() * v.norm()) continue;
      const double s = cross(w, v) / det, t = cross(w, u) / det;
      if (s < 0 || s > 1 || t < 0 || t > 1) continue;
      const RodCrossing found{place_on(curve_a, own, s), place_on(curve_b, other, t)};
      const double near = std::max(1e-6 * plan_size(plan), 0.5 * (u.norm() + v.norm()) / kParts);
      const auto close = [&](const Vec2& place) { return (place - found.on_a.at).norm() <= near; };
      if (std::none_of(shared.begin(), shared.end(), close)) return found;
    }
  }
  return std::nullopt;
}

}  // namespace lissom
