#include <algorithm>
#include <cmath>
#include <numbers>

#include "lissom/model/limits.h"
#include "lissom/model/units.h"
#include "lissom/model/validate_parts.h"

namespace lissom {
namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;

void check_points(Checker& check, const std::vector<Vec3>& points, bool closed, const std::string& where) {
  for (std::size_t i = 0; i < points.size() && !check.failed(); ++i) {
    check.finite(points[i], where + "/" + std::to_string(i));
    if (i > 0 && points[i] == points[i - 1]) {
      check.fail(ErrorCode::kGeometry, where + "/" + std::to_string(i), "this point is the same as the one before",
                 "remove one of them");
    }
  }
  const std::size_t least = closed ? 3 : 2;
  if (points.size() < least) {
    return check.fail(ErrorCode::kGeometry, where,
                      "a rod that is " + std::string(closed ? "closed" : "open") + " needs at least " +
                          std::to_string(least) + " points");
  }
  if (closed && points.front() == points.back()) {
    check.fail(ErrorCode::kGeometry, where + "/" + std::to_string(points.size() - 1),
               "a closed rod returns to its first point by itself", "remove the repeated last point");
  }
}

/// `start` has to lie off the axis through `centre`.
void check_radius(Checker& check, const Vec3& centre, const Vec3& start, const Vec3& axis, const std::string& where) {
  check.finite(centre, where + "/centre");
  check.finite(start, where + "/start");
  check.direction(axis, where + "/axis");
  if (check.failed()) return;
  const Vec3 offset = start - centre;
  if (offset.norm() == 0 || offset.cross(axis.stableNormalized()).norm() <= 1e-12 * offset.norm()) {
    check.fail(ErrorCode::kGeometry, where + "/start", "the start lies on the axis, so that the radius is zero",
               "move it, or turn the axis");
  }
}

void check_values(Checker& check, const std::vector<double>& values, const std::string& where,
                  const std::string& what) {
  for (std::size_t i = 0; i < values.size() && !check.failed(); ++i) {
    check.positive(values[i], values.size() == 1 ? where : where + "/" + std::to_string(i), what);
  }
}

void check_section(Checker& check, const SectionProfile& section, const std::string& where) {
  const bool rectangle = section.shape == SectionShape::kRectangle;
  const bool round = !rectangle && (section.shape == SectionShape::kTube || section.r_n == section.r_b);
  const std::string first = rectangle ? "/thickness"
                            : round   ? "/radius"
                                      : "/r_n",
                    second = rectangle ? "/width" : "/r_b";
  check_values(check, section.r_n, where + first, rectangle ? "thickness" : "radius");
  if (!round) check_values(check, section.r_b, where + second, rectangle ? "width" : "radius");
  if (check.failed()) return;
  if (section.r_n.empty() || section.r_n.size() != section.r_b.size()) {
    return check.fail(ErrorCode::kConflict, where, "the section needs equally many values along n and b, at least one");
  }
  if (section.shape == SectionShape::kTube) {
    if (section.r_n != section.r_b)
      return check.fail(ErrorCode::kConflict, where, "a tube is round: r_n and r_b have to agree");
    check.positive(section.wall, where + "/wall", "wall");
    const double thinnest = *std::min_element(section.r_n.begin(), section.r_n.end());
    if (section.wall > thinnest) {
      check.fail(ErrorCode::kRange, where + "/wall",
                 "the wall of " + write_quantity(section.wall, Measure::kLength) + " is thicker than the radius of " +
                     write_quantity(thinnest, Measure::kLength),
                 "a wall equal to the radius is a full rod");
    }
  }
  for (std::size_t i = 0; i < section.r_n.size() && !check.failed(); ++i) {
    check.take(Section{section.shape, section.r_n[i], section.r_b[i], section.wall}.validate(where));
  }
}

void check_axes(Checker& check, const MaterialAxes& axes, const std::string& where) {
  switch (axes.kind) {
    case MaterialAxes::Kind::kDirection:
      return check.direction(axes.normal, where + "/normal");
    case MaterialAxes::Kind::kTransport:
      return check.direction(axes.normal, where + "/transport");
    case MaterialAxes::Kind::kJoints:
      return;
    case MaterialAxes::Kind::kPerPoint:
      if (axes.normals.size() < 2) {
        check.fail(ErrorCode::kType, where + "/per_point", "axes per point need at least two directions",
                   "use \"normal\" for one direction");
      }
      for (std::size_t i = 0; i < axes.normals.size() && !check.failed(); ++i) {
        check.direction(axes.normals[i], where + "/per_point/" + std::to_string(i));
      }
  }
}

/// A straight line along the direction that n should have leaves n undefined.
void check_line_normal(Checker& check, const Curve& curve, const MaterialAxes& axes, const std::string& where) {
  const auto* polyline = std::get_if<Polyline>(&curve);
  const bool transport = axes.kind == MaterialAxes::Kind::kTransport;
  if (check.failed() || !polyline || (axes.kind != MaterialAxes::Kind::kDirection && !transport)) return;
  const std::size_t n = polyline->points.size(), pieces = transport ? 1 : polyline->closed ? n : n - 1;
  const Vec3 normal = axes.normal.stableNormalized();
  for (std::size_t i = 0; i < pieces; ++i) {
    const Vec3 tangent = (polyline->points[(i + 1) % n] - polyline->points[i]).stableNormalized();
    if (tangent.cross(normal).norm() > 1e-9) continue;
    Eigen::Index across = 0;
    tangent.cwiseAbs().minCoeff(&across);
    const Vec3 better = Vec3::Unit(across);
    return check.fail(ErrorCode::kGeometry, where + "/axes",
                      "the material axis n points along the rod" +
                          (pieces > 1 ? " at its piece " + std::to_string(i) : std::string()),
                      "give a direction across the rod, for example \"axes\": {\"normal\": [" + number_text(better[0]) +
                          ", " + number_text(better[1]) + ", " + number_text(better[2]) + "]}");
  }
}

void check_natural(Checker& check, const Rod& rod, const std::string& where) {
  const Natural& natural = rod.natural;
  check.positive(natural.length_factor, where + "/length_factor", "length factor");
  if (natural.kind == Natural::Kind::kCurved) {
    check.finite(natural.curvature_b, where + "/curvature_b");
    check.finite(natural.curvature_n, where + "/curvature_n");
    check.finite(natural.twist, where + "/twist");
  }
  if (natural.kind != Natural::Kind::kCurve) return;
  if (!natural.curve) return check.fail(ErrorCode::kConflict, where + "/curve", "the natural curve is missing");
  check_curve(check, *natural.curve, where + "/curve");
  if (!check.failed() && is_closed(*natural.curve) != is_closed(rod.curve)) {
    check.fail(ErrorCode::kConflict, where + "/curve",
               "one of the drawn and the natural curve is closed, the other is not",
               "a rod with closed ends has both closed");
  }
  if (natural.axes) check_axes(check, *natural.axes, where + "/axes");
  check_line_normal(check, *natural.curve, natural.axes ? *natural.axes : rod.axes, where);
}

}  // namespace

void check_curve(Checker& check, const Curve& curve, const std::string& where) {
  if (const auto* polyline = std::get_if<Polyline>(&curve)) {
    const bool line = polyline->points.size() == 2 && !polyline->closed;
    check_points(check, polyline->points, polyline->closed, where + (line ? "/line" : "/polyline"));
  } else if (const auto* spline = std::get_if<Spline>(&curve)) {
    check_points(check, spline->points, spline->closed, where + "/spline");
  } else if (const auto* arc = std::get_if<Arc>(&curve)) {
    check_radius(check, arc->centre, arc->start, arc->axis, where + "/arc");
    check.finite(arc->angle, where + "/arc/angle");
    if (arc->angle == 0) check.fail(ErrorCode::kGeometry, where + "/arc/angle", "the angle of an arc must not be zero");
    if (arc->closed && std::abs(std::abs(arc->angle) - kFullTurn) > 1e-9) {
      check.fail(ErrorCode::kConflict, where + "/arc/angle", "a closed arc turns by 360 deg",
                 "set the angle, or remove \"closed\"");
    }
    if (std::abs(arc->angle) > kFullTurn * (1 + 1e-9)) {
      check.fail(ErrorCode::kRange, where + "/arc/angle", "an arc turns by at most 360 deg",
                 "use a \"helix\" for more turns");
    }
  } else {
    const Helix& helix = std::get<Helix>(curve);
    check_radius(check, helix.centre, helix.start, helix.axis, where + "/helix");
    check.finite(helix.pitch, where + "/helix/pitch");
    check.finite(helix.turns, where + "/helix/turns");
    if (helix.turns == 0)
      check.fail(ErrorCode::kGeometry, where + "/helix/turns", "the number of turns must not be zero");
    if (std::abs(helix.turns) > kMostTurns) {
      check.fail(ErrorCode::kRange, where + "/helix/turns",
                 "a helix has at most " + std::to_string(kMostTurns) + " turns", "use fewer turns");
    }
  }
}

void check_rod(Checker& check, const Rod& rod, const std::string& where) {
  check_curve(check, rod.curve, where);
  check.known(rod.material, check.materials, "material", where + "/material");
  check_section(check, rod.section, where + "/section");
  check_axes(check, rod.axes, where + "/axes");
  check_line_normal(check, rod.curve, rod.axes, where);
  check_natural(check, rod, where + "/natural");
  if (rod.edges < 0 || rod.edges > kMostNodes) {
    check.fail(ErrorCode::kRange, where + "/edges",
               "the number of edges has to be between 1 and " + std::to_string(kMostNodes), "use fewer edges");
  }
  check.not_negative(rod.edge_length, where + "/edge_length", "edge length");
  if (rod.edge_length > 0) check.positive(rod.edge_length, where + "/edge_length", "edge length");
  if (rod.edges > 0 && rod.edge_length > 0) {
    check.fail(ErrorCode::kConflict, where, "both \"edges\" and \"edge_length\" are given", "keep one of them");
  }
  if (rod.edges == 0 && rod.edge_length == 0) {
    check.fail(ErrorCode::kType, where, "neither \"edges\" nor \"edge_length\" is given",
               "say into how many edges the rod is cut");
  }
  if (is_closed(rod.curve) && rod.edges > 0 && rod.edges < 3) {
    check.fail(ErrorCode::kGeometry, where + "/edges", "a closed rod needs at least 3 edges");
  }
}

}  // namespace lissom
