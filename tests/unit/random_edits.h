#pragma once
/// Edits of all kinds, drawn at random; some of them cannot be done.

#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "lissom/editing/edits_json.h"

namespace lissom {

class RandomEdits {
 public:
  using Json = nlohmann::json;
  explicit RandomEdits(unsigned seed) : random_(seed) {}

  /// The next edit, of any kind.
  Json next(const Model& model) {
    const Plan& plan = *model.plan;
    const std::string name(edits()[pick(edits().size())]->name);
    Json edit = fields(name, plan);
    edit["name"] = name;
    // Now and then a slip.
    if (pick(20) == 0) edit["no_such_field"] = 1;
    return edit;
  }

 private:
  std::size_t pick(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
  double number(double low, double high) { return low + (high - low) * (double(random_()) / 4294967296.0); }
  std::string point(const Plan& plan) { return pick(40) == 0 ? "nobody" : plan.points[pick(plan.points.size())].name; }
  std::string rod(const Plan& plan) { return plan.rods[pick(plan.rods.size())].name; }
  Json points(const Plan& plan, std::size_t count) {
    Json list = Json::array();
    for (std::size_t i = 0; i < count; ++i) list.push_back(point(plan));
    return list;
  }
  Json near(const Plan& plan) {
    const Vec2 at = plan.points[pick(plan.points.size())].at * 1e3;
    return {at.x() + number(-12, 12), at.y() + number(-12, 12)};
  }
  /// A small step from where a point is.
  Json step(const Plan& plan, Json* name) {
    const PlanPoint& point = plan.points[pick(plan.points.size())];
    *name = point.name;
    return {1e3 * point.at.x() + number(-3, 3), 1e3 * point.at.y() + number(-3, 3)};
  }

  Json fields(const std::string& name, const Plan& plan) {
    Json who;
    if (name == "move_points") {
      const Json to = step(plan, &who);
      return {{"moves", {{{"point", who}, {"to_mm", to}}}}};
    }
    if (name == "transform_points") {
      return {{"points", points(plan, 2)}, {"turn_deg", number(-4, 4)}, {"move_mm", {number(-1, 1), number(-1, 1)}}};
    }
    if (name == "add_rod") {
      return {{"through", {{{"point", point(plan)}}, {{"at_mm", near(plan)}}}},
              {"role", pick(2) == 0 ? "rod" : "ghost"}};
    }
    if (name == "insert_point") return {{"rod", rod(plan)}, {"at_mm", near(plan)}};
    if (name == "remove") return pick(2) == 0 ? Json{{"points", points(plan, 1)}} : Json{{"rods", {rod(plan)}}};
    if (name == "set_radii") return {{"points", points(plan, 2)}, {"factor", number(0.9, 1.15)}};
    if (name == "set_role") return {{"rods", {rod(plan)}}, {"role", pick(2) == 0 ? "rod" : "ghost"}};
    if (name == "set_split") return {{"points", points(plan, 1)}, {"split", pick(2) == 0}};
    if (name == "set_curve") return {{"rods", {rod(plan)}}, {"curve", pick(2) == 0 ? "spline" : "straight"}};
    if (name == "set_closed") {
      const PlanRod& other = plan.rods[pick(plan.rods.size())];
      return {{"rod", other.name}, {"closed", !other.closed}};
    }
    if (name == "split_rod") {
      const PlanRod& rod = plan.rods[pick(plan.rods.size())];
      const int at = rod.points[rod.points.size() / 2];
      return {{"rod", rod.name}, {"point", plan.points[static_cast<std::size_t>(at)].name}};
    }
    if (name == "join_rods") return {{"rods", joinable(plan)}};
    if (name == "merge_points") return {{"points", points(plan, 2)}};
    if (name == "rename") return {{"point", point(plan)}, {"to", "n" + std::to_string(pick(1000))}};
    if (name == "mirror") return {{"rods", {rod(plan)}}, {"axis", pick(2) == 0 ? "x" : "y"}, {"at_mm", 0}};
    return numbers(name, plan);
  }

  Json numbers(const std::string& name, const Plan& plan) {
    if (name == "set_pre_stretch") return {{"along", {number(1.3, 1.5), number(1.3, 1.5)}}};
    if (name == "set_fabric") return {{"warp_angle_deg", number(-90, 90)}, {"bending", number(0, 2)}};
    if (name == "set_rods") return {{"material", pick(2) == 0 ? "PLA" : "PETG"}, {"max_turn_deg", number(5, 12)}};
    if (name == "add_hole") return {{"at_mm", near(plan)}};
    if (name == "remove_hole") return {{"hole", pick(2)}};
    if (name == "strengthen")
      return {{"pre_stretch_factor", number(0.98, 1.02)}, {"radius_factor", number(0.95, 1.05)}};
    if (name == "set_title") return {{"title", "Title \u00e9 \"" + std::to_string(pick(100)) + "\"\n"}};
    if (name == "set_constraints") return constraints(plan);
    Json who;
    const Json at = step(plan, &who);
    return {{"points", {{{"point", who}, {"at_mm", at}, {"r_n_mm", number(0.3, 0.6)}}}}, {"title", "Take a fit over"}};
  }

  Json constraints(const Plan& plan) {
    switch (pick(4)) {
      case 0:
        return {{"pinned", points(plan, pick(3))}};
      case 1:
        return {{"attached", Json::array({points(plan, 2)})}};
      case 2:
        return {{"in_plane", Json::array({points(plan, 3)})}};
      default:
        return {{"symmetric", pick(2) == 0 ? Json{{"axis", "x"}} : Json()}};
    }
  }

  /// Two rods with a common end, if there are any.
  Json joinable(const Plan& plan) {
    const std::size_t first = pick(plan.rods.size());
    for (std::size_t k = 0; k < plan.rods.size(); ++k) {
      const PlanRod &a = plan.rods[(first + k) % plan.rods.size()], &b = plan.rods[(first + k + 1) % plan.rods.size()];
      if (!a.closed && !b.closed && a.points.back() == b.points.front()) return {a.name, b.name};
    }
    return {rod(plan), rod(plan)};
  }

  std::mt19937 random_;
};

}  // namespace lissom
