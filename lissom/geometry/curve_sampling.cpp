#include "lissom/geometry/curve_sampling.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <queue>
#include <utility>

#include "lissom/geometry/hermite_curve.h"

namespace lissom {

namespace {

constexpr double kPi = std::numbers::pi;

Error bad_geometry(const std::string& where, std::string message, std::string hint) {
  return {ErrorCode::kGeometry, where, std::move(message), std::move(hint)};
}

Status check_points(std::span<const Vec3> points, bool closed, const std::string& where) {
  const size_t needed = closed ? 3 : 2;
  if (points.size() < needed) {
    return bad_geometry(where, fmt::format("{} curve has {} points", closed ? "the closed" : "the", points.size()),
                        fmt::format("give at least {}", needed));
  }
  Vec3 low = points[0], high = points[0];
  for (size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) {
      return Error{ErrorCode::kRange, where, fmt::format("point {} is not a finite number", i), "give three numbers"};
    }
    low = low.cwiseMin(points[i]);
    high = high.cwiseMax(points[i]);
  }
  const double least = 1e-12 * (high - low).norm();
  const size_t pieces = closed ? points.size() : points.size() - 1;
  for (size_t i = 0; i < pieces; ++i) {
    const size_t next = (i + 1) % points.size();
    if ((points[next] - points[i]).norm() > least) continue;
    return bad_geometry(
        where, fmt::format("points {} and {} are at the same place", i, next),
        next == 0 ? "a closed curve does not repeat its first point: remove the last one" : "remove one of them");
  }
  return {};
}

Status check_edges(int edges, int needed, const std::string& where) {
  if (edges >= needed) return {};
  return bad_geometry(where, fmt::format("{} edges are too few for this curve", edges),
                      fmt::format("give at least {}: one for each piece, three for a closed curve", needed));
}

/// Unit tangent. Where the slope vanishes (a cusp) the direction between the neighbouring points of the curve.
Vec3 unit_tangent(const HermiteCurve<Vec3>& curve, int piece, double s) {
  const Vec3 d = curve.slope(piece, s), straight = curve.chord(piece);
  if (d.norm() > 1e-9 * straight.norm()) return d.normalized();
  const Vec3 chord = curve.point(piece, std::min(1.0, s + 0.01)) - curve.point(piece, std::max(0.0, s - 0.01));
  return chord.norm() > 0 ? Vec3(chord.normalized()) : Vec3(straight.normalized());
}

/// Edges per piece: one each, the rest always to the piece whose edges are longest (the first of equals).
std::vector<int> distribute(const std::vector<double>& lengths, int edges) {
  std::vector<int> counts(lengths.size(), 1);
  using Entry = std::pair<double, int>;  // edge length, minus the piece so that the first of equals is on top
  std::vector<Entry> start;
  for (size_t i = 0; i < lengths.size(); ++i) start.emplace_back(lengths[i], -static_cast<int>(i));
  std::priority_queue<Entry> longest(std::less<Entry>(), std::move(start));
  for (int left = edges - static_cast<int>(lengths.size()); left > 0; --left) {
    const int piece = -longest.top().second;
    longest.pop();
    const size_t p = static_cast<size_t>(piece);
    ++counts[p];
    longest.emplace(lengths[p] / counts[p], -piece);
  }
  return counts;
}

Result<double> radius_of(const TurnedPoint& turn, const std::string& where) {
  if (!turn.centre.allFinite() || !turn.start.allFinite() || !turn.axis.allFinite() || !std::isfinite(turn.angle) ||
      !std::isfinite(turn.rise)) {
    return Error{ErrorCode::kRange, where, "a number of the curve is not finite", "give finite numbers"};
  }
  if (turn.axis.norm() == 0) return bad_geometry(where, "the axis has no length", "give a direction such as [0, 0, 1]");
  if (turn.angle == 0) return bad_geometry(where, "the curve turns by zero", "give an angle, or use a polyline");
  const Vec3 axis = turn.axis.normalized(), arm = turn.start - turn.centre;
  const double radius = (arm - axis * axis.dot(arm)).norm();
  if (!(radius > 1e-12 * std::max(turn.start.norm(), turn.centre.norm()))) {
    return bad_geometry(where, "the start lies on the axis, so the radius is zero", "move the start or the centre");
  }
  if (turn.closed && (std::abs(std::abs(turn.angle) - 2 * kPi) > 1e-9 || turn.rise != 0)) {
    return Error{ErrorCode::kConflict, where, "the curve is closed but does not turn by a full circle",
                 "give an angle of 360 degrees or leave it open"};
  }
  return radius;
}

}  // namespace

Result<CurveMeasure> measure_polyline(std::span<const Vec3> points, bool closed, const std::string& where) {
  if (Status s = check_points(points, closed, where); !s) return s.error();
  CurveMeasure m;
  m.minimum_edges = static_cast<int>(points.size()) - (closed ? 0 : 1);
  for (int i = 0; i < m.minimum_edges; ++i) {
    m.length += (points[static_cast<size_t>(i + 1) % points.size()] - points[static_cast<size_t>(i)]).norm();
  }
  return m;
}

Result<CurveMeasure> measure_spline(std::span<const Vec3> points, bool closed, const std::string& where) {
  if (Status s = check_points(points, closed, where); !s) return s.error();
  const HermiteCurve<Vec3> curve(points, closed);
  constexpr int kParts = 16;
  constexpr double kGauss = 0.28867513459481287;  // half of 1 / sqrt(3): two-point rule on each part
  CurveMeasure m;
  m.minimum_edges = closed ? 3 : 1;
  double most = 0;
  for (int piece = 0; piece < curve.pieces(); ++piece) {
    double turning = 0;
    for (int k = 0; k < kParts; ++k) {
      const double middle = (k + 0.5) / kParts, offset = kGauss / kParts;
      m.length +=
          (curve.slope(piece, middle - offset).norm() + curve.slope(piece, middle + offset).norm()) / (2 * kParts);
      const Vec3 t0 = unit_tangent(curve, piece, k / double{kParts}),
                 t1 = unit_tangent(curve, piece, (k + 1) / double{kParts});
      turning += std::atan2(t0.cross(t1).norm(), t0.dot(t1));
    }
    most = std::max(most, turning);
  }
  m.turning = most * curve.pieces();
  return m;
}

Result<CurveMeasure> measure_turn(const TurnedPoint& turn, const std::string& where) {
  const Result<double> radius = radius_of(turn, where);
  if (!radius) return radius.error();
  CurveMeasure m;
  const double round = std::abs(turn.angle) * radius.value();
  m.length = std::hypot(round, turn.rise);
  m.turning = std::abs(turn.angle) * round / m.length;
  m.minimum_edges = turn.closed ? 3 : 1;
  return m;
}

Result<CurveSamples> sample_polyline(std::span<const Vec3> points, bool closed, int edges, const std::string& where) {
  const Result<CurveMeasure> measure = measure_polyline(points, closed, where);
  if (!measure) return measure.error();
  if (Status s = check_edges(edges, measure.value().minimum_edges, where); !s) return s.error();
  std::vector<double> lengths;
  for (int i = 0; i < measure.value().minimum_edges; ++i) {
    lengths.push_back((points[static_cast<size_t>(i + 1) % points.size()] - points[static_cast<size_t>(i)]).norm());
  }
  const std::vector<int> counts = distribute(lengths, edges);
  CurveSamples samples;
  samples.closed = closed;
  for (size_t i = 0; i < counts.size(); ++i) {
    const Vec3 &p0 = points[i], &p1 = points[(i + 1) % points.size()];
    for (int k = 0; k < counts[i]; ++k) samples.points.push_back(p0 + (p1 - p0) * (double(k) / counts[i]));
  }
  if (!closed) samples.points.push_back(points.back());
  return samples;
}

Result<CurveSamples> sample_spline(std::span<const Vec3> points, bool closed, int edges, const std::string& where) {
  if (Status s = check_points(points, closed, where); !s) return s.error();
  if (Status s = check_edges(edges, closed ? 3 : 1, where); !s) return s.error();
  const HermiteCurve<Vec3> curve(points, closed);
  CurveSamples samples;
  samples.closed = closed;
  for (int k = 0; k < edges + (closed ? 0 : 1); ++k) {
    // Whole numbers decide the piece, so that nodes meet the control points exactly.
    const long long place = static_cast<long long>(k) * curve.pieces();
    const int piece = std::min(static_cast<int>(place / edges), curve.pieces() - 1);
    const double s = double(place - static_cast<long long>(piece) * edges) / edges;
    samples.points.push_back(curve.point(piece, s));
    samples.tangents.push_back(unit_tangent(curve, piece, s));
  }
  return samples;
}

Result<CurveSamples> sample_turn(const TurnedPoint& turn, int edges, const std::string& where) {
  const Result<double> radius = radius_of(turn, where);
  if (!radius) return radius.error();
  if (Status s = check_edges(edges, turn.closed ? 3 : 1, where); !s) return s.error();
  const Vec3 axis = turn.axis.normalized(), arm = turn.start - turn.centre;
  const Vec3 middle = turn.centre + axis * axis.dot(arm), out = arm - axis * axis.dot(arm), side = axis.cross(out);
  CurveSamples samples;
  samples.closed = turn.closed;
  for (int k = 0; k < edges + (turn.closed ? 0 : 1); ++k) {
    const double part = double(k) / edges, a = turn.angle * part;
    samples.points.push_back(middle + std::cos(a) * out + std::sin(a) * side + axis * (turn.rise * part));
    samples.tangents.push_back((turn.angle * (std::cos(a) * side - std::sin(a) * out) + axis * turn.rise).normalized());
  }
  samples.points.front() = turn.start;
  return samples;
}

}  // namespace lissom
