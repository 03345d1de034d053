#include "lissom/model/plan_drawing.h"

#include <cctype>
#include <fmt/format.h>

#include "lissom/geometry/hermite_curve.h"
#include "lissom/geometry/planar_arc.h"
#include "lissom/model/plan_sampling.h"

namespace lissom {

namespace {

constexpr double kFrameMargin = 0.01;  // m

PlanarPath spline_path(const std::vector<Vec2>& points, bool closed) {
  const HermiteCurve<Vec2> curve(points, closed);
  PlanarPath path;
  for (int k = 0; k < curve.pieces(); ++k) {
    const Vec2 &from = points[static_cast<std::size_t>(k)],
               &to = points[static_cast<std::size_t>(k + 1) % points.size()];
    path.push_back(PathPiece::cubic(from, from + curve.slope(k, 0) / 3, to - curve.slope(k, 1) / 3, to));
  }
  return path;
}

PlanarPath arc_path(const PlanRod& rod, const std::vector<Vec2>& points) {
  PlanarPath path;
  for (int k = 0; k < piece_count(rod); ++k) {
    const ArcPiece piece = arc_piece(rod, k);
    const auto pair = [&](std::size_t i) { return PlanarPoint<double>(points[i].x(), points[i].y()); };
    const auto [x, y] = arc_point(pair(piece.from), pair(piece.to), pair(piece.other), 0.5);
    path.push_back(PathPiece::arc(points[piece.from], Vec2(x, y), points[piece.to]));
  }
  return path;
}

}  // namespace

std::optional<PlanRole> role_of_layer(std::string_view layer) {
  std::string upper;
  for (const char c : layer) upper += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  if (upper == kFrameLayer || upper == kMarkLayer) return {};
  return upper == kGhostLayer ? PlanRole::kGhost : PlanRole::kRod;
}

DrawingFrame frame_of(const PlanDrawing& drawing) {
  DrawingFrame frame;
  bool first = true;
  for (const DrawnLine& line : drawing.lines) {
    for (const PathPiece& piece : line.path) {
      for (int k = 0; k <= 16; ++k) {
        const Vec2 p = piece.at(k / 16.0);
        frame.low = first ? p : Vec2(frame.low.cwiseMin(p));
        frame.high = first ? p : Vec2(frame.high.cwiseMax(p));
        first = false;
      }
    }
  }
  if (first) frame.low = frame.high = Vec2::Zero();
  frame.frame_low = frame.low.array() - kFrameMargin;
  frame.frame_high = frame.high.array() + kFrameMargin;
  return frame;
}

PlanDrawing drawing_of_plan(const Plan& plan) {
  PlanDrawing drawing;
  for (const PlanRod& rod : plan.rods) {
    DrawnLine line;
    line.name = rod.name;
    line.role = rod.role;
    line.closed = rod.closed;
    std::vector<Vec2> points;
    double r_n = 0, r_b = 0;
    for (const int i : rod.points) {
      const PlanPoint& point = plan.points[static_cast<std::size_t>(i)];
      points.push_back(point.at);
      r_n += point.r_n / double(rod.points.size());
      r_b += point.r_b / double(rod.points.size());
    }
    line.r_n = r_n;
    line.r_b = r_b;
    if (rod.curve == PlanCurve::kSpline) line.path = spline_path(points, rod.closed);
    if (rod.curve == PlanCurve::kArc) line.path = arc_path(rod, points);
    if (rod.curve == PlanCurve::kStraight) {
      for (int k = 0; k < piece_count(rod); ++k) {
        const std::size_t i = static_cast<std::size_t>(k);
        line.path.push_back(PathPiece::line(points[i], points[(i + 1) % points.size()]));
      }
    }
    drawing.lines.push_back(std::move(line));
  }
  return drawing;
}

}  // namespace lissom
