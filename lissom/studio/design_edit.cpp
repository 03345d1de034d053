#include "lissom/studio/design_edit.h"

#include "lissom/editing/people_units.h"

namespace lissom {

nlohmann::json design_edit(const Model& model, const std::string& title) {
  nlohmann::json points = nlohmann::json::array();
  for (const PlanPoint& point : model.plan->points) {
    points.push_back({{"point", point.name},
                      {"at_mm", {millimetres_of(point.at.x()), millimetres_of(point.at.y())}},
                      {"r_n_mm", millimetres_of(point.r_n)},
                      {"r_b_mm", millimetres_of(point.r_b)}});
  }
  const Vec2& stretch = model.plan->fabric.pre_stretch;
  return {{"name", "set_design"}, {"points", points}, {"pre_stretch", {stretch.x(), stretch.y()}}, {"title", title}};
}

}  // namespace lissom
