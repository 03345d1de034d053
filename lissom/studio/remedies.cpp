#include "lissom/studio/remedies.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "lissom/editing/people_units.h"
#include "lissom/session/solved_remedy.h"
#include "lissom/studio/desk.h"

namespace lissom {

namespace {

using Json = nlohmann::json;

constexpr double kThinnest = 0.25;  // mm, half of what printers make

/// The rod of the plan that a rod of the structure, NAME or NAME-3, came from.
const PlanRod* plan_rod(const Plan& plan, const std::string& name) {
  const PlanRod* best = nullptr;
  for (const PlanRod& rod : plan.rods) {
    if (rod.name == name) return &rod;
    if (name.starts_with(rod.name + "-") && (best == nullptr || rod.name.size() > best->name.size())) best = &rod;
  }
  return best;
}

Json thicker_points(const Plan& plan) {
  Json points = Json::array();
  for (const PlanPoint& point : plan.points) {
    const double r_n = millimetres_of(point.r_n), r_b = millimetres_of(point.r_b);
    if (std::min(r_n, r_b) >= kThinnest) continue;
    points.push_back({{"point", point.name},
                      {"at_mm", {millimetres_of(point.at.x()), millimetres_of(point.at.y())}},
                      {"r_n_mm", std::max(r_n, kThinnest)},
                      {"r_b_mm", std::max(r_b, kThinnest)}});
  }
  return points;
}

}  // namespace

std::optional<Json> remedy_edit(const Warning& warning, const Model& model) {
  if (!model.plan) return std::nullopt;
  if (warning.what == "compressed rod" && !warning.ghost.empty()) {
    const PlanRod* rod = plan_rod(*model.plan, warning.ghost);
    if (rod == nullptr) return std::nullopt;
    return Json{{"name", "set_role"}, {"rods", {rod->name}}, {"role", "ghost"}};
  }
  if (warning.what == "thin rod") {
    Json points = thicker_points(*model.plan);
    if (points.empty()) return std::nullopt;
    const Vec2& stretch = model.plan->fabric.pre_stretch;
    return Json{{"name", "set_design"},
                {"points", std::move(points)},
                {"pre_stretch", {stretch.x(), stretch.y()}},
                {"title", "Make thin rods 0.5 mm thick"}};
  }
  if (warning.what == "turning angle") {
    return Json{{"name", "set_rods"}, {"max_turn_deg", model.plan->max_turn * 90 / std::numbers::pi}};
  }
  return std::nullopt;
}

bool has_remedy(const Warning& warning, const Model& model) {
  return warning.what == "slack fabric" || remedy_edit(warning, model).has_value();
}

Result<Json> take_remedy(Desk& desk, const Warning& warning) {
  if (const std::optional<Json> edit = remedy_edit(warning, desk.model())) return desk.edit(*edit);
  if (warning.what != "slack fabric") {
    return Error{ErrorCode::kUnsupported, "/warning", "there is no remedy that could be taken by itself",
                 warning.remedy};
  }
  const LiveDesign* design = desk.shape().design();
  if (design == nullptr || design->equilibrium().verdict != Verdict::kStable) {
    return Error{ErrorCode::kConflict, {}, "there is no settled shape to begin from", "let it settle first"};
  }
  const int revision = desk.revision();
  desk.jobs().start(
      "remedy", "",
      [&desk, revision, model = design->model(), pose = design->pose(),
       slack = design->equilibrium()](const Context& context) {
        const WarningLimits limits;
        const std::optional<SolvedRemedy> found =
            solved_remedy(model, model.poses[static_cast<std::size_t>(pose)], "/poses", slack, limits.stretch,
                          limits.wanted_stretch, {}, context);
        if (context.cancelled()) return Jobs::End{Jobs::End::State::kCancelled, "stopped", {}};
        if (!found) {
          return Jobs::End{
              Jobs::End::State::kFailed,
              "no pre-stretch with thicker rods makes it taut: make the shape flatter, or the rods stiffer",
              {}};
        }
        const double factor = found->remedy.pre_stretch.x() / model.plan->fabric.pre_stretch.x();
        const Json edit = {
            {"name", "strengthen"}, {"pre_stretch_factor", factor}, {"radius_factor", found->remedy.radius_factor}};
        return Jobs::End{Jobs::End::State::kDone, solved_remedy_text(*found), [&desk, revision, edit] {
                           if (desk.revision() != revision) return;
                           const Result<Json> done = desk.edit(edit);
                           if (!done) desk.pages().tell_all({{"event", "log"}, {"text", done.error().text()}});
                         }};
      });
  return Json::object();
}

}  // namespace lissom
