#include "lissom/editing/rod_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

/// A new point on the line of a rod.
int helping_point(Plan& plan, const PlanRod& rod, const RodPlace& place) {
  const double r_n = radius_at(plan, rod, place, &PlanPoint::r_n), r_b = radius_at(plan, rod, place, &PlanPoint::r_b);
  return add_point(plan, place.at, r_n, r_b);
}

void put_on_arc(Plan& plan, std::size_t r, const RodPlace& place, int point) {
  const PlanRod rod = plan.rods[r];
  const auto begin = [&] { return plan.rods[r].points.begin() + place.piece + 1; };
  if (rod.closed && rod.points.size() == 3) {
    plan.rods[r].points.insert(begin(), point);
    return;
  }
  // The other half of the arc that is cut in two needs a point of its own.
  const bool first_half = place.piece % 2 == 0;
  RodPlace half{place.piece, first_half ? place.s / 2 : (place.s + 1) / 2, Vec2::Zero(), 0};
  half.at = RodCurve(plan, rod).point(half.piece, half.s);
  const int helper = helping_point(plan, rod, half);
  plan.rods[r].points.insert(begin(), point);
  plan.rods[r].points.insert(first_half ? begin() : begin() + 1, helper);
}

/// Distances from the end of a piece of length `first` at which points cut the next `gap`, such that no piece is much longer
/// than the one before. A spline is monotone along a line while neighbouring pieces are as 1 to 5 (slopes of at most three
/// times the piece, Fritsch and Carlson 1980), at the end of an open one, whose slope is 3 to 1 of the first two, as 1 to 3.
std::vector<double> growing_steps(double first, double gap, bool at_end) {
  const double most = at_end ? 2.5 : 4, growth = at_end ? 2.2 : 2.5;
  std::vector<double> cuts;
  double at = 0, step = first;
  while (gap - at > most * step) {
    step *= growth;
    at += step;
    cuts.push_back(at);
  }
  return cuts;
}

void put_on_spline(Plan& plan, std::size_t r, const RodPlace& place, int point) {
  const Plan before = plan;
  const PlanRod& rod = before.rods[r];
  const RodCurve curve(before, rod);
  const int pieces = curve.pieces();
  std::vector<std::pair<double, int>> order;  // m along the rod, point
  double total = 0;
  for (std::size_t k = 0; k < rod.points.size(); ++k) {
    order.emplace_back(total, rod.points[k]);
    if (static_cast<int>(k) < pieces) total += curve.length(static_cast<int>(k));
  }
  const double at = curve.length_to(place), start = order[static_cast<std::size_t>(place.piece)].first;
  const double own = curve.length(place.piece), left = at - start, right = own - left;
  const auto neighbour = [&](int piece) -> double {
    if (rod.closed) return curve.length((piece + pieces) % pieces);
    return piece >= 0 && piece < pieces ? curve.length(piece) : 0;
  };
  const bool first = !rod.closed && place.piece == 0, last = !rod.closed && place.piece + 1 == pieces;
  const auto add = [&](double from, double direction, const std::vector<double>& cuts) {
    for (const double cut : cuts) {
      double where = from + direction * cut;
      if (rod.closed) where = std::fmod(where + total, total);
      order.emplace_back(where, helping_point(plan, rod, curve.at_length(where)));
    }
  };
  add(start, -1, growing_steps(left, neighbour(place.piece - 1), false));
  add(start + own, 1, growing_steps(right, neighbour(place.piece + 1), false));
  add(at, 1, growing_steps(left, right, first));
  add(at, -1, growing_steps(right, left, last));
  order.emplace_back(at, point);
  std::sort(order.begin(), order.end());
  std::vector<int>& points = plan.rods[r].points;
  points.clear();
  for (const auto& [where, number] : order) points.push_back(number);
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
  switch (plan.rods[r].curve) {
    case PlanCurve::kStraight:
      plan.rods[r].points.insert(plan.rods[r].points.begin() + place.piece + 1, point);
      break;
    case PlanCurve::kArc:
      put_on_arc(plan, r, place, point);
      break;
    case PlanCurve::kSpline:
      put_on_spline(plan, r, place, point);
      break;
  }
}

OnRod point_on_rod(Plan& plan, std::size_t r, const Vec2& at) {
  const PlanRod& rod = plan.rods[r];
  const RodCurve curve(plan, rod);
  const RodPlace place = curve.nearest(at);
  const double least = 0.05 * curve.length(place.piece);
  for (const int i : rod.points) {
    const PlanPoint& point = plan.points[static_cast<std::size_t>(i)];
    if ((point.at - place.at).norm() <= std::max(point.r_b, least)) return {i, false};
  }
  const int point = helping_point(plan, rod, place);
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
