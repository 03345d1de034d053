#include "lissom/editing/plan_json.h"

#include <cmath>

#include "lissom/editing/mirrored_plan.h"
#include "lissom/editing/people_units.h"
#include "lissom/editing/rod_curve.h"
#include "lissom/model/plan_sampling.h"

namespace lissom {

namespace {

using Json = nlohmann::json;

Json place_json(const Vec2& at) { return {millimetres_of(at.x()), millimetres_of(at.y())}; }

/// What is only drawn needs no more digits than a screen has.
Json drawn_json(const Vec2& at) {
  constexpr double kParts = 1e3;  // of a mm
  return {std::round(at.x() * 1e3 * kParts) / kParts, std::round(at.y() * 1e3 * kParts) / kParts};
}

const char* curve_word(PlanCurve curve) {
  switch (curve) {
    case PlanCurve::kStraight:
      return "straight";
    case PlanCurve::kArc:
      return "arc";
    case PlanCurve::kSpline:
      break;
  }
  return "spline";
}

/// The rod as it is drawn; `fineness`: parts between neighbouring points where it is bent.
Json line_json(const Plan& plan, const PlanRod& rod, int fineness) {
  Json line = Json::array();
  const RodCurve curve(plan, rod);
  const int steps = rod.curve == PlanCurve::kStraight ? 1 : fineness;
  for (int piece = 0; piece < curve.pieces(); ++piece) {
    for (int k = piece == 0 ? 0 : 1; k <= steps; ++k) line.push_back(drawn_json(curve.point(piece, double(k) / steps)));
  }
  return line;
}

Json points_json(const Plan& plan) {
  Json list = Json::array();
  for (const PlanPoint& point : plan.points) {
    list.push_back({{"name", point.name},
                    {"at_mm", place_json(point.at)},
                    {"r_n_mm", millimetres_of(point.r_n)},
                    {"r_b_mm", millimetres_of(point.r_b)},
                    {"split", point.split}});
  }
  return list;
}

Json rods_json(const Plan& plan) {
  Json list = Json::array();
  for (const PlanRod& rod : plan.rods) {
    list.push_back({{"name", rod.name},
                    {"points", rod.points},
                    {"curve", curve_word(rod.curve)},
                    {"role", rod.role == PlanRole::kGhost ? "ghost" : "rod"},
                    {"closed", rod.closed},
                    {"length_mm", RodCurve(plan, rod).length() * 1e3},
                    {"line_mm", line_json(plan, rod, 16)}});
  }
  return list;
}

Json fabric_json(const Fabric& fabric) {
  Json holes = Json::array();
  for (const Vec2& hole : fabric.holes) holes.push_back(place_json(hole));
  return {{"material", fabric.material},
          {"pre_stretch", {fabric.pre_stretch[0], fabric.pre_stretch[1]}},
          {"warp_angle_deg", degrees_of(fabric.warp_angle)},
          {"edge_length_mm", millimetres_of(fabric.edge_length)},
          {"min_angle_deg", degrees_of(fabric.min_angle)},
          {"bending", fabric.bending},
          {"holes_mm", std::move(holes)},
          {"outline", fabric.outline}};
}

Json constraints_json(const Model& model) {
  const ToolConstraints constraints = constraints_of(model);
  Json mirror;
  if (constraints.symmetric) {
    mirror = {{"axis", kAxisWords[static_cast<std::size_t>(constraints.symmetric->axis)]},
              {"at_mm", millimetres_of(constraints.symmetric->at)}};
  }
  return {{"pinned", constraints.pinned},
          {"attached", constraints.attached},
          {"in_plane", constraints.in_plane},
          {"symmetric", std::move(mirror)}};
}

}  // namespace

nlohmann::json plan_to_json(const Model& model) {
  LISSOM_ASSERT(model.plan.has_value());
  const Plan& plan = *model.plan;
  return {{"points", points_json(plan)},
          {"rods", rods_json(plan)},
          {"material", plan.material},
          {"edge_length_mm", millimetres_of(plan.edge_length)},
          {"max_turn_deg", degrees_of(plan.max_turn)},
          {"fabric", fabric_json(plan.fabric)},
          {"constraints", constraints_json(model)}};
}

nlohmann::json plan_lines_json(const Model& model) {
  Json lines = Json::array();
  if (!model.plan) return lines;
  for (const PlanRod& rod : model.plan->rods) {
    if (rod.role != PlanRole::kGhost) lines.push_back(line_json(*model.plan, rod, 6));
  }
  return lines;
}

}  // namespace lissom
