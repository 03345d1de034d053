#include "lissom/model/check_plan.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

#include "lissom/core/nearest_name.h"
#include "lissom/geometry/hermite_curve.h"
#include "lissom/model/expand_plan.h"
#include "lissom/model/json_value.h"
#include "lissom/model/limits.h"
#include "lissom/model/validate_parts.h"

namespace lissom {

namespace {

constexpr double kMostStretch = 4;  // elastane itself breaks at five to eight times its length, knits with it far below

std::string point_place(const PlanPoint& point) { return "/plan/points/" + pointer_step(point.name); }

void check_points(Checker& check, const Plan& plan) {
  std::vector<char> used(plan.points.size(), 0);
  for (const PlanRod& rod : plan.rods) {
    for (const int i : rod.points) used[static_cast<std::size_t>(i)] = 1;
  }
  // All numbers before any are compared: what is near and what is the same place is said by the size of the whole.
  double size = 0;
  for (const PlanPoint& p : plan.points) {
    check.finite(Vec3(p.at.x(), p.at.y(), 0), point_place(p));
    size = std::max(size, (p.at - plan.points[0].at).norm());
  }
  for (std::size_t i = 0; i < plan.points.size() && !check.failed(); ++i) {
    const PlanPoint& point = plan.points[i];
    const std::string where = point_place(point);
    check.positive(point.r_n, where + "/r_n", "radius");
    check.positive(point.r_b, where + "/r_b", "radius");
    if (!used[i]) {
      check.fail(ErrorCode::kConflict, where, fmt::format("no rod runs through the point \"{}\"", point.name),
                 "remove it, or name it in a rod");
    }
    for (std::size_t j = 0; j < i && !check.failed(); ++j) {
      if ((plan.points[j].at - point.at).norm() > 1e-6 * size) continue;
      check.fail(ErrorCode::kGeometry, where,
                 fmt::format("the points \"{}\" and \"{}\" are at the same place", plan.points[j].name, point.name),
                 "use one point for both: rods that share a point are joined there");
    }
  }
}

/// Where a piece of a spline bends most, and with which radius, m; 0 where it turns on the spot.
struct Bend {
  double radius = std::numeric_limits<double>::infinity();
  Vec2 at = Vec2::Zero();
};

Bend tightest_bend(const HermiteCurve<Vec2>& curve, int piece) {
  const auto speed = [&](double s) { return curve.slope(piece, s).norm(); };
  Bend tightest;
  const auto look = [&](double s) {
    const Vec2 slope = curve.slope(piece, s), change = (curve.slope(piece, s + 0.5) - curve.slope(piece, s - 0.5));
    const double across = std::abs(slope.x() * change.y() - slope.y() * change.x()), along = slope.norm();
    const double radius = along > 1e-9 * change.norm() ? along * along * along / across : 0;
    if (radius < tightest.radius) tightest = {radius, curve.point(piece, s)};
  };
  // Bends are tight where the spline is slow, sometimes on a very short way.
  constexpr int kPlaces = 32;
  double slowest = 0;
  for (int k = 0; k <= kPlaces; ++k) {
    const double s = double(k) / kPlaces;
    look(s);
    if (speed(s) < speed(slowest)) slowest = s;
  }
  double low = std::max(slowest - 1.0 / kPlaces, 0.0), high = std::min(slowest + 1.0 / kPlaces, 1.0);
  for (int round = 0; round < 60; ++round) {
    const double third = (high - low) / 3;
    if (speed(low + third) < speed(high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  look((low + high) / 2);
  return tightest;
}

/// A spline through uneven points can turn on the spot or in a loop of no size, which no number of edges can follow.
void check_bends(Checker& check, const Plan& plan, std::size_t r) {
  const PlanRod& rod = plan.rods[r];
  if (rod.curve != PlanCurve::kSpline) return;
  const auto point = [&](int place) -> const PlanPoint& {
    const std::size_t i = static_cast<std::size_t>(place) % rod.points.size();
    return plan.points[static_cast<std::size_t>(rod.points[i])];
  };
  std::vector<Vec2> places;
  for (std::size_t i = 0; i < rod.points.size(); ++i) places.push_back(point(static_cast<int>(i)).at);
  const HermiteCurve<Vec2> curve(places, rod.closed);
  for (int piece = 0; piece < curve.pieces(); ++piece) {
    const Bend bend = tightest_bend(curve, piece);
    const double width = std::min(point(piece).r_b, point(piece + 1).r_b);
    if (bend.radius >= width) continue;
    return check.fail(
        ErrorCode::kGeometry, fmt::format("/plan/rods/{}", r),
        fmt::format(
            "rod \"{}\" bends around a radius of {:.2g} mm between \"{}\" and \"{}\", near ({:.4g}, {:.4g}) mm, "
            "but is {:.2g} mm wide on each side: it would run over itself",
            rod.name, 1e3 * bend.radius, point(piece).name, point(piece + 1).name, 1e3 * bend.at.x(), 1e3 * bend.at.y(),
            1e3 * width),
        "space its points more evenly, or draw two rods that meet at a point there");
  }
}

void check_plan_rod(Checker& check, const Plan& plan, std::size_t r) {
  const PlanRod& rod = plan.rods[r];
  const std::string where = fmt::format("/plan/rods/{}", r);
  const std::size_t n = rod.points.size(), least = rod.closed || rod.curve == PlanCurve::kArc ? 3 : 2;
  const std::string name = "rod \"" + rod.name + "\"";
  if (n < least) {
    return check.fail(ErrorCode::kGeometry, where + "/points", fmt::format("{} has {} points", name, n),
                      fmt::format("give at least {}", least));
  }
  const auto named = [&](std::size_t i) -> const std::string& {
    return plan.points[static_cast<std::size_t>(rod.points[i])].name;
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (rod.points[i] != rod.points[j]) continue;
      return check.fail(ErrorCode::kGeometry, where + "/points/" + std::to_string(i),
                        fmt::format("{} runs through the point \"{}\" twice", name, named(i)),
                        j == 0 && i + 1 == n ? "remove the last point and say \"closed\": true"
                                             : "draw it as two rods that share the point");
    }
  }
  if (rod.curve != PlanCurve::kArc) return;
  if (n > 3 && n % 2 == (rod.closed ? 1 : 0)) {
    return check.fail(ErrorCode::kGeometry, where + "/points",
                      fmt::format("{} has {} points, which do not make up whole arcs", name, n),
                      "an arc has three points, the last of which is the first of the next one");
  }
  for (int piece = 0; piece < piece_count(rod) && !check.failed(); ++piece) {
    const ArcPiece arc = arc_piece(rod, piece);
    const auto at = [&](std::size_t i) -> const Vec2& {
      return plan.points[static_cast<std::size_t>(rod.points[i])].at;
    };
    const Vec2 u = at(arc.from) - at(arc.other), v = at(arc.to) - at(arc.other);
    const double half = std::abs(std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v)));
    constexpr double kMostHalf = 3;  // rad: beyond, the circle is hundreds of times its arc
    const bool flat = rod.closed && n == 3 && (half < 1e-3 || std::numbers::pi - half < 1e-3);
    if (half <= kMostHalf && !flat) continue;
    check.fail(
        ErrorCode::kGeometry, where + "/points",
        fmt::format("the points \"{}\", \"{}\" and \"{}\" of {} lie in line, so that no circle runs through them "
                    "in this order",
                    named(arc.from), named(arc.to), named(arc.other), name),
        "move one of them, or make the rod straight");
  }
}

void check_plan_fabric(Checker& check, const Model& model) {
  const Plan& plan = *model.plan;
  const Fabric& fabric = plan.fabric;
  const std::string where = "/plan/fabric";
  if (!model.membrane_material(fabric.material)) {
    std::vector<std::string> names;
    for (const MembraneMaterial& own : model.membrane_materials) names.push_back(own.name);
    for (const MembraneMaterial& known : membrane_library()) names.push_back(known.name);
    check.fail(ErrorCode::kUnknown, where + "/material",
               fmt::format("there is no membrane material \"{}\"", fabric.material),
               suggestion(fabric.material, names));
  }
  for (int axis = 0; axis < 2 && !check.failed(); ++axis) {
    const double stretch = fabric.pre_stretch[axis];
    check.finite(stretch, where + "/pre_stretch");
    if (stretch > 0) continue;
    check.fail(ErrorCode::kRange, where + "/pre_stretch", fmt::format("the pre-stretch is {:g}", stretch),
               "give the stretched length divided by the length at rest, for example 1.4; 1 is no stretch");
  }
  if (!check.failed() && fabric.pre_stretch.maxCoeff() < 1) {
    check.fail(ErrorCode::kRange, where + "/pre_stretch",
               fmt::format("the pre-stretch is {:g}: the fabric would hang slack from the start",
                           fabric.pre_stretch.maxCoeff()),
               "give the stretched length divided by the length at rest, more than 1, for example 1.4");
  }
  if (!check.failed() && fabric.pre_stretch.maxCoeff() > kMostStretch) {
    check.fail(ErrorCode::kRange, where + "/pre_stretch",
               fmt::format("the pre-stretch is {:g}: no fabric can be stretched to {:g} times its length",
                           fabric.pre_stretch.maxCoeff(), fabric.pre_stretch.maxCoeff()),
               "give the stretched length divided by the length at rest, 1.2 to 1.8 is usual; 40 % more is 1.4");
  }
  check.finite(fabric.warp_angle, where + "/warp_angle");
  check.not_negative(fabric.edge_length, where + "/edge_length", "edge length");
  check.not_negative(fabric.bending, where + "/bending", "bending factor");
  check.not_negative(fabric.min_angle, where + "/min_angle", "angle");
  if (fabric.min_angle > std::numbers::pi / 6 * (1 + 1e-9)) {
    check.fail(ErrorCode::kRange, where + "/min_angle", "the smallest angle asked for is above 30 degrees",
               "ask for 30 degrees or less");
  }
  std::vector<std::string> names;
  for (const PlanRod& rod : plan.rods) names.push_back(rod.name);
  for (std::size_t i = 0; i < fabric.outline.size() && !check.failed(); ++i) {
    if (std::find(names.begin(), names.end(), fabric.outline[i]) != names.end()) continue;
    check.fail(ErrorCode::kUnknown, where + "/outline/" + std::to_string(i),
               fmt::format("the plan has no rod named \"{}\"", fabric.outline[i]),
               suggestion(fabric.outline[i], names));
  }
  for (std::size_t i = 0; i < fabric.holes.size(); ++i) {
    check.finite(Vec3(fabric.holes[i].x(), fabric.holes[i].y(), 0), where + "/holes/" + std::to_string(i));
  }
}

}  // namespace

Status check_plan(const Model& model) {
  Checker check(model);
  const Plan& plan = *model.plan;
  if (plan.rods.empty()) {
    return Error{ErrorCode::kGeometry, "/plan/rods", "the plan has no rods, so that its fabric has no edge",
                 "draw at least a closed loop; make it a ghost if it is not printed"};
  }
  std::vector<std::string> points, rods;
  for (const PlanPoint& point : plan.points) points.push_back(point.name);
  for (const PlanRod& rod : plan.rods) rods.push_back(rod.name);
  check.distinct(points, "point", [&](std::size_t i) { return point_place(plan.points[i]); });
  check.distinct(rods, "rod", [](std::size_t i) { return fmt::format("/plan/rods/{}/name", i); });
  for (std::size_t r = 0; r < plan.rods.size() && !check.failed(); ++r) check_plan_rod(check, plan, r);
  if (!check.failed()) check_points(check, plan);
  for (std::size_t r = 0; r < plan.rods.size() && !check.failed(); ++r) check_bends(check, plan, r);
  check.known(plan.material, check.materials, "material", "/plan/material");
  check.not_negative(plan.edge_length, "/plan/edge_length", "edge length");
  check.positive(plan.max_turn, "/plan/max_turn", "largest turn");
  if (!check.failed()) check_plan_fabric(check, model);
  if (check.failed()) return check.status();
  if (plan_rod_names(plan).empty()) {
    return Error{ErrorCode::kGeometry, "/plan/rods", "all rods of the plan are ghosts, so that nothing is printed",
                 "make at least one of them a rod"};
  }
  return {};
}

}  // namespace lissom
