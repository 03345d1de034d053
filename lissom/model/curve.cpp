#include "lissom/model/curve.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "lissom/model/limits.h"
#include "lissom/model/sampling.h"

namespace lissom {

namespace {

constexpr int kDefaultEdges = 10;
constexpr double kDefaultTurning = std::numbers::pi / 18;  // rad per edge

TurnedPoint turned(const Arc& arc) { return {arc.centre, arc.start, arc.axis, arc.angle, 0, arc.closed}; }

TurnedPoint turned(const Helix& helix) {
  return {helix.centre, helix.start, helix.axis, 2 * std::numbers::pi * helix.turns,
          helix.pitch * std::abs(helix.turns)};
}

struct Measure {
  const std::string& where;
  Result<CurveMeasure> operator()(const Polyline& c) const { return measure_polyline(c.points, c.closed, where); }
  Result<CurveMeasure> operator()(const Spline& c) const { return measure_spline(c.points, c.closed, where); }
  Result<CurveMeasure> operator()(const Arc& c) const {
    if (std::abs(c.angle) > 2 * std::numbers::pi + 1e-9) {
      return Error{ErrorCode::kGeometry, where, "the arc turns by more than a full circle", "use a helix for a coil"};
    }
    return measure_turn(turned(c), where);
  }
  Result<CurveMeasure> operator()(const Helix& c) const { return measure_turn(turned(c), where); }
};

struct Sample {
  int edges;
  const std::string& where;
  Result<CurveSamples> operator()(const Polyline& c) const { return sample_polyline(c.points, c.closed, edges, where); }
  Result<CurveSamples> operator()(const Spline& c) const { return sample_spline(c.points, c.closed, edges, where); }
  Result<CurveSamples> operator()(const Arc& c) const { return sample_turn(turned(c), edges, where); }
  Result<CurveSamples> operator()(const Helix& c) const { return sample_turn(turned(c), edges, where); }
};

}  // namespace

bool is_closed(const Curve& curve) {
  if (const auto* polyline = std::get_if<Polyline>(&curve)) return polyline->closed;
  if (const auto* spline = std::get_if<Spline>(&curve)) return spline->closed;
  if (const auto* arc = std::get_if<Arc>(&curve)) return arc->closed;
  return false;
}

Result<CurveMeasure> measure(const Curve& curve, const std::string& where) { return std::visit(Measure{where}, curve); }

Result<CurveSamples> sample(const Curve& curve, int edges, const std::string& where) {
  return std::visit(Sample{edges, where}, curve);
}

Result<int> edge_count(const Rod& rod, double refine, const std::string& where) {
  const Result<CurveMeasure> measured = measure(rod.curve, where + "/curve");
  if (!measured) return measured.error();
  const CurveMeasure& m = measured.value();
  if (rod.edges < 0 || !(rod.edge_length >= 0)) {
    return Error{ErrorCode::kRange, where, "the number of edges or their length is negative",
                 "give `edges` of at least 1, or an `edge_length` above zero"};
  }
  if (!(refine > 0)) {
    return Error{ErrorCode::kRange, where, fmt::format("the refinement is {:g}", refine), "give a number above zero"};
  }
  double edges =
      std::max<double>({kDefaultEdges, double(m.minimum_edges), std::ceil(m.turning / kDefaultTurning - 1e-9)});
  if (rod.edges > 0) {
    edges = rod.edges;
    if (rod.edges < m.minimum_edges) {
      return Error{ErrorCode::kGeometry, where, fmt::format("{} edges are too few for this curve", rod.edges),
                   fmt::format("give at least {}: one for each piece, three for a closed curve", m.minimum_edges)};
    }
  } else if (rod.edge_length > 0) {
    edges = std::max<double>(m.minimum_edges, std::round(m.length / rod.edge_length));
  }
  edges = std::max<double>(m.minimum_edges, std::round(edges * refine));
  if (!(edges <= kMostNodes)) {
    return Error{ErrorCode::kRange, where, fmt::format("the rod would be cut into {:g} edges", edges),
                 fmt::format("use fewer or longer edges: at most {} per rod", kMostNodes)};
  }
  return static_cast<int>(edges);
}

}  // namespace lissom
