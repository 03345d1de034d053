#include <algorithm>
#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/plan_tools.h"
#include "lissom/editing/rod_curve.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"rod", "rod", "", false, "Which rod."},
    {"point", "point", "", true, "Where: one of its points. A closed rod is also split at the point across."},
    {"at_mm", "place", "mm", true, "Or near which place: it gets a point there, unless one is that near."},
};

std::ptrdiff_t place_in(const PlanRod& rod, int point) {
  const auto found = std::find(rod.points.begin(), rod.points.end(), point);
  return found == rod.points.end() ? -1 : found - rod.points.begin();
}

/// Gives an arc a point more, so that whole arcs end at the place `at` of its list; where that place is then.
std::ptrdiff_t end_of_arc(Plan& plan, int r, std::ptrdiff_t at) {
  PlanRod& rod = rod_of(plan, r);
  if (rod.curve != PlanCurve::kArc || at % 2 == 0) return at;
  // The point in the middle of an arc becomes an end: each half gets a point of its own, on the same circle.
  const int middle = rod.points[static_cast<std::size_t>(at)];
  const RodCurve curve(plan, rod);
  const auto half = [&](std::ptrdiff_t piece) {
    const RodPlace place{static_cast<int>(piece), 0.5, curve.point(static_cast<int>(piece), 0.5), 0};
    return std::pair(place, radius_at(plan, rod, place, &PlanPoint::r_n));
  };
  const auto [before, n_before] = half(at - 1);
  const auto [after, n_after] = half(at);
  const double b_before = radius_at(plan, rod, before, &PlanPoint::r_b),
               b_after = radius_at(plan, rod, after, &PlanPoint::r_b);
  const int first = add_point(plan, before.at, n_before, b_before),
            second = add_point(plan, after.at, n_after, b_after);
  std::vector<int>& points = rod_of(plan, r).points;
  const auto place = std::find(points.begin(), points.end(), middle);
  const auto put = points.insert(place, first);
  points.insert(put + 2, second);
  return at + 1;
}

/// Cuts an open rod in two at a place of its list; the second part gets the name.
void split_open(Plan& plan, int r, std::ptrdiff_t at, const std::string& name) {
  at = end_of_arc(plan, r, at);
  PlanRod second = rod_of(plan, r);
  second.name = name;
  second.points.erase(second.points.begin(), second.points.begin() + at);
  std::vector<int>& first = rod_of(plan, r).points;
  first.resize(static_cast<std::size_t>(at) + 1);
  plan.rods.insert(plan.rods.begin() + r + 1, std::move(second));
}

/// Makes the place `at` of a ring of arcs the end of one.
void end_of_arc_in_ring(Plan& plan, int r, std::ptrdiff_t at) {
  const PlanRod& rod = rod_of(plan, r);
  if (rod.curve != PlanCurve::kArc) return;
  if (rod.points.size() > 3) {
    end_of_arc(plan, r, at);
    return;
  }
  // A circle: with a fourth point on it every place is one.
  RodPlace half{2, 0.5, RodCurve(plan, rod).point(2, 0.5), 0};
  const int fourth = add_point(plan, half.at, radius_at(plan, rod, half, &PlanPoint::r_n),
                               radius_at(plan, rod, half, &PlanPoint::r_b));
  rod_of(plan, r).points.push_back(fourth);
}

/// Turns the list of a ring such that it begins at a place, and repeats that point at its end.
void open_ring(PlanRod& rod, std::ptrdiff_t at) {
  std::rotate(rod.points.begin(), rod.points.begin() + at, rod.points.end());
  rod.points.push_back(rod.points.front());
  rod.closed = false;
}

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  const int r = edit.rod("rod");
  if (edit.has("point") == edit.has("at_mm")) {
    edit.fail(ErrorCode::kType, {}, "this does not say where to split", "give a point, or at_mm");
  }
  const bool anywhere = edit.has("at_mm");
  int point = anywhere ? -1 : edit.point("point");
  const Vec2 place = anywhere ? edit.place("at_mm") : Vec2::Zero();
  if (edit.failed()) return edit.error();
  EditOutcome out{model};
  Plan& plan = *out.model.plan;
  if (anywhere) point = point_on_rod(plan, static_cast<std::size_t>(r), place).point;
  const std::string name = rod_of(plan, r).name, other = unused_rod_name(model);
  std::ptrdiff_t at = place_in(rod_of(plan, r), point);
  const std::string point_name = point_of(plan, point).name;
  if (at < 0) {
    edit.fail(ErrorCode::kConflict, "point", fmt::format("rod \"{}\" does not run through \"{}\"", name, point_name),
              "choose one of its points, or put a point there first");
  } else if (!rod_of(plan, r).closed &&
             (at == 0 || at + 1 == static_cast<std::ptrdiff_t>(rod_of(plan, r).points.size()))) {
    edit.fail(ErrorCode::kConflict, anywhere ? "at_mm" : "point",
              fmt::format("rod \"{}\" ends at \"{}\" already", name, point_name), "choose a place between its ends");
  }
  if (edit.failed()) return edit.error();
  if (rod_of(plan, r).closed) {
    end_of_arc_in_ring(plan, r, at);
    at = place_in(rod_of(plan, r), point);
    open_ring(rod_of(plan, r), at);
    at = static_cast<std::ptrdiff_t>(rod_of(plan, r).points.size()) / 2;
    out.notes.push_back(fmt::format("The ring {} is split at {} too.", name,
                                    point_of(plan, rod_of(plan, r).points[static_cast<std::size_t>(at)]).name));
  }
  split_open(plan, r, at, other);
  out.names.rods[name] = {name, other};
  out.title = fmt::format("Split rod {} at {}", name, point_name);
  return out;
}

}  // namespace

constinit const EditInfo kEditSplitRod = {"split_rod", "Makes two rods of one; they stay joined at the point.", kFields,
                                          apply};

}  // namespace lissom
