#include <algorithm>
#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/plan_tools.h"
#include "lissom/editing/rod_curve.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"through", "list", "", false,
     "Where it runs: [{\"point\": \"a\"}, {\"at_mm\": [x, y]}, {\"rod\": \"r\", \"at_mm\": [x, y]}], the last a place "
     "on a rod."},
    {"curve", "choice", "", true, "\"spline\", \"straight\" or \"arc\"; straight through two points, else a spline."},
    {"role", "choice", "", true, "\"rod\" (printed) or \"ghost\"."},
    {"closed", "flag", "", true, "Whether it returns to its first point."},
    {"rod", "text", "", true, "Its name; one is found."},
    {"r_n_mm", "number", "mm", true, "Radius out of the plane at new points; that of the nearest point."},
    {"r_b_mm", "number", "mm", true, "Radius in the plane at new points; that of the nearest point."},
    {"join", "flag", "", true, "Whether it shares points with rods that it crosses (true)."},
};
constexpr std::string_view kPlace[] = {"point", "rod", "at_mm"};
constexpr std::string_view kCurves[] = {"spline", "straight", "arc"};
constexpr PlanCurve kKinds[] = {PlanCurve::kSpline, PlanCurve::kStraight, PlanCurve::kArc};
constexpr std::string_view kRoles[] = {"rod", "ghost"};
constexpr int kMostCrossings = 200;

struct Radii {
  std::optional<double> r_n, r_b;  ///< m
};

/// A new point of the rod; one that is there already when it is at the same place.
int free_point(const Plan& before, Plan& plan, const Vec2& at, const Radii& radii) {
  const int same = nearest_point(plan, at);
  if (same >= 0 && (point_of(plan, same).at - at).norm() <= 1e-6 * plan_size(plan)) return same;
  const PlanPoint& near = point_of(before, nearest_point(before, at));
  return add_point(plan, at, radii.r_n.value_or(near.r_n), radii.r_b.value_or(near.r_b));
}

int read_place(const Plan& before, Plan& plan, EditReader& place, const Radii& radii) {
  place.only(kPlace);
  if (place.has("point") == place.has("at_mm")) {
    place.fail(ErrorCode::kType, {}, "this is no place", "give a point, or at_mm, or a rod with at_mm");
  }
  if (place.has("point") && place.has("rod")) {
    place.fail(ErrorCode::kConflict, "rod", "a point needs no rod", "give a point, or a rod with at_mm");
  }
  if (place.failed()) return 0;
  if (place.has("point")) return place.point("point");
  const Vec2 at = place.place("at_mm");
  if (!place.has("rod")) return place.failed() ? 0 : free_point(before, plan, at, radii);
  const int rod = place.rod("rod");
  return place.failed() ? 0 : point_on_rod(plan, static_cast<std::size_t>(rod), at).point;
}

/// Gives the last rod common points with the rods that it crosses; how many of these there are.
int join_crossings(Plan& plan) {
  const std::size_t own = plan.rods.size() - 1;
  int joined = 0;
  for (std::size_t other = 0; other < own; ++other) {
    for (int round = 0; round < kMostCrossings; ++round) {
      const std::optional<RodCrossing> crossing = first_crossing(plan, own, other);
      if (!crossing) break;
      const OnRod there = point_on_rod(plan, other, crossing->on_b.at);
      const std::vector<int>& points = plan.rods[own].points;
      if (std::find(points.begin(), points.end(), there.point) != points.end()) break;
      put_on_rod(plan, own, crossing->on_a, there.point);
      ++joined;
    }
  }
  return joined;
}

/// A name that was asked for, or an unused one.
std::string name_of(const Model& model, EditReader& edit) {
  std::string name = edit.optional_name("rod").value_or(unused_rod_name(model));
  for (const PlanRod& rod : model.plan->rods) {
    if (rod.name != name) continue;
    edit.fail(ErrorCode::kConflict, "rod", fmt::format("there is a rod named \"{}\" already", name),
              "choose another name");
  }
  return name;
}

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  EditOutcome out{model};
  Plan& plan = *out.model.plan;
  const Radii radii{edit.optional_length("r_n_mm"), edit.optional_length("r_b_mm")};
  PlanRod rod;
  rod.name = name_of(model, edit);
  for (EditReader& place : edit.items("through", 2)) {
    rod.points.push_back(read_place(*model.plan, plan, place, radii));
    if (edit.failed()) return edit.error();
  }
  rod.closed = edit.has("closed") && edit.flag("closed");
  rod.curve = rod.points.size() == 2 ? PlanCurve::kStraight : PlanCurve::kSpline;
  if (edit.has("curve")) rod.curve = kKinds[edit.choice("curve", kCurves)];
  if (edit.has("role") && edit.choice("role", kRoles) == 1) rod.role = PlanRole::kGhost;
  const bool join = !edit.has("join") || edit.flag("join");
  if (edit.failed()) return edit.error();
  const std::string name = rod.name;
  out.title = fmt::format("Draw {} {}", rod.role == PlanRole::kGhost ? "ghost" : "rod", name);
  plan.rods.push_back(std::move(rod));
  mend_rods(plan, out.notes);
  if (plan.rods.size() == model.plan->rods.size()) {
    edit.fail(ErrorCode::kGeometry, "through", "a rod needs two different points, a closed one three",
              "draw it through more points");
    return edit.error();
  }
  const int joined = join ? join_crossings(plan) : 0;
  if (joined > 0) {
    out.notes.push_back(fmt::format("Rod {} crosses others at {} place{} and is joined to them there.", name, joined,
                                    joined == 1 ? "" : "s"));
  }
  return out;
}

}  // namespace

constinit const EditInfo kEditAddRod = {"add_rod", "Draws a rod or a ghost through points, old and new.", kFields,
                                        apply};

}  // namespace lissom
