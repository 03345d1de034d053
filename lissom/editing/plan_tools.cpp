#include "lissom/editing/plan_tools.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

#include "lissom/editing/people_units.h"

namespace lissom {

namespace {

template <class Named>
bool has_name(const std::vector<Named>& list, const std::string& name) {
  return std::any_of(list.begin(), list.end(), [&](const Named& one) { return one.name == name; });
}

/// Leaves one of points that follow each other; a line that ends where it began becomes a ring.
void leave_out_repeated(PlanRod& rod, std::vector<std::string>& notes) {
  std::vector<int>& points = rod.points;
  points.erase(std::unique(points.begin(), points.end()), points.end());
  while (rod.closed && points.size() > 1 && points.front() == points.back()) points.pop_back();
  if (rod.closed || points.size() < 4 || points.front() != points.back()) return;
  points.pop_back();
  rod.closed = true;
  notes.push_back(fmt::format("Rod {} ends where it begins, so it is closed now.", rod.name));
}

void mend_arc(PlanRod& rod, std::vector<std::string>& notes) {
  const std::size_t n = rod.points.size();
  if (rod.curve != PlanCurve::kArc || n < 2) return;
  if (n == 2) {
    rod.curve = PlanCurve::kStraight;
    notes.push_back(fmt::format("Rod {} has two points left, so it is straight now.", rod.name));
  } else if (n > 3 && n % 2 == (rod.closed ? 1 : 0)) {
    rod.curve = PlanCurve::kSpline;
    notes.push_back(fmt::format("The points of rod {} make no whole arcs any more, so it is a spline now.", rod.name));
  }
}

}  // namespace

double plan_size(const Plan& plan) {
  double size = 0;
  for (const PlanPoint& p : plan.points) size = std::max(size, (p.at - plan.points[0].at).norm());
  return size;
}

std::string unused_point_name(const Plan& plan) {
  for (int number = 1;; ++number) {
    std::string name = fmt::format("p{}", number);
    if (!has_name(plan.points, name)) return name;
  }
}

std::string unused_rod_name(const Model& model) {
  for (int number = 1;; ++number) {
    std::string name = fmt::format("rod{}", number);
    const auto taken = [&](const auto& rod) { return rod.name == name || rod.name.starts_with(name + "-"); };
    const bool in_plan = model.plan && std::any_of(model.plan->rods.begin(), model.plan->rods.end(), taken);
    if (!in_plan && std::none_of(model.rods.begin(), model.rods.end(), taken)) return name;
  }
}

std::size_t rod_number(const Plan& plan, std::string_view name) {
  const auto found =
      std::find_if(plan.rods.begin(), plan.rods.end(), [&](const PlanRod& rod) { return rod.name == name; });
  LISSOM_ASSERT(found != plan.rods.end());
  return static_cast<std::size_t>(found - plan.rods.begin());
}

double rounded_radius(double radius) {
  const double rounded = rounded_length(radius);
  return rounded > 0 ? rounded : radius;
}

int add_point(Plan& plan, const Vec2& at, double r_n, double r_b) {
  plan.points.push_back({unused_point_name(plan), {rounded_length(at.x()), rounded_length(at.y())}, r_n, r_b, false});
  return static_cast<int>(plan.points.size()) - 1;
}

int nearest_point(const Plan& plan, const Vec2& to) {
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < plan.points.size(); ++i) {
    const double distance = (plan.points[i].at - to).norm();
    if (distance >= least) continue;
    least = distance;
    nearest = static_cast<int>(i);
  }
  return nearest;
}

void take_out(Plan& plan, const std::vector<int>& points) {
  for (PlanRod& rod : plan.rods) {
    std::erase_if(rod.points, [&](int i) { return std::find(points.begin(), points.end(), i) != points.end(); });
  }
}

void drop_rods(Plan& plan, const std::vector<int>& rods) {
  std::vector<PlanRod> kept;
  for (std::size_t r = 0; r < plan.rods.size(); ++r) {
    if (std::find(rods.begin(), rods.end(), static_cast<int>(r)) == rods.end()) kept.push_back(std::move(plan.rods[r]));
  }
  plan.rods = std::move(kept);
}

void drop_unused_points(Plan& plan) {
  std::vector<int> number(plan.points.size(), -1);
  for (const PlanRod& rod : plan.rods) {
    for (const int i : rod.points) number[static_cast<std::size_t>(i)] = 0;
  }
  std::vector<PlanPoint> kept;
  for (std::size_t i = 0; i < plan.points.size(); ++i) {
    if (number[i] < 0) continue;
    number[i] = static_cast<int>(kept.size());
    kept.push_back(std::move(plan.points[i]));
  }
  plan.points = std::move(kept);
  for (PlanRod& rod : plan.rods) {
    for (int& i : rod.points) i = number[static_cast<std::size_t>(i)];
  }
}

void mend_rods(Plan& plan, std::vector<std::string>& notes) {
  std::vector<PlanRod> kept;
  for (PlanRod& rod : plan.rods) {
    leave_out_repeated(rod, notes);
    if (rod.points.size() < (rod.closed ? 3U : 2U)) {
      notes.push_back(fmt::format("Rod {} has too few points left and is gone.", rod.name));
      continue;
    }
    mend_arc(rod, notes);
    kept.push_back(std::move(rod));
  }
  plan.rods = std::move(kept);
  drop_unused_points(plan);
}

std::string points_in_words(const Plan& plan, const std::vector<int>& points) {
  if (points.size() != 1) return fmt::format("{} points", points.size());
  return "point " + plan.points[static_cast<std::size_t>(points[0])].name;
}

std::string rods_in_words(const Plan& plan, const std::vector<int>& rods) {
  if (rods.size() != 1) return fmt::format("{} rods", rods.size());
  return "rod " + plan.rods[static_cast<std::size_t>(rods[0])].name;
}

std::string stretch_title(const Vec2& from, const Vec2& to) {
  const std::string how = to == from                           ? "Leave"
                          : (to.array() >= from.array()).all() ? "Raise"
                          : (to.array() <= from.array()).all() ? "Lower"
                                                               : "Set";
  if (to == from) return "Leave the stretch as it is";
  if (to[0] == to[1]) return fmt::format("{} the stretch to {:.4g}", how, to[0]);
  return fmt::format("{} the stretch to {:.4g} and {:.4g}", how, to[0], to[1]);
}

std::string length_in_words(double metres) { return fmt::format("{:.4g} mm", millimetres_of(metres)); }

}  // namespace lissom
