#include "scenes/sheet_brief.h"

#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "lissom/core/assert.h"
#include "lissom/design/brief_space.h"
#include "scenes/settled_places.h"
#include "scenes/sheet_design.h"

namespace lissom::scene_models {

namespace {

constexpr double kPins = 1e4;                         // N/m, at each pinned node
constexpr double kThinnest = 1e-3, kThickest = 5e-3;  // m
constexpr double kReach = 0.01;                       // m, of the rest shape
constexpr double kSpread = 0.3;                       // of the hidden radii, about those drawn
constexpr double kShift = 0.0015;                     // m, of the hidden rest shape, about the one drawn

ParameterBrief radii(int controls) { return {RadiiBrief{controls, Vec2(kThinnest, kThickest)}, {}, Freedom::kEach}; }

Brief brief_of_sheet() {
  Brief brief;
  brief.stages = {{{radii(2)}, 10}, {{radii(3)}, 5}, {{radii(4)}, 5}};
  brief.settings.iterations = 12;
  brief.parameters = {radii(4), {RestShapeBrief{4, kReach, RestShapeBrief::Gauge::kFree}, {}, Freedom::kEach}};
  return brief;
}

/// One of the designs that the last stage can make.
Result<Model> hidden_sheet(const Model& model) {
  const Result<BriefSpace> space = make_brief_space(*model.design, model);
  if (!space) return space.error();
  std::mt19937 random(51);
  VecX p = space.value().space->start();
  for (int i = 0; i < p.size(); ++i) {
    const double u = 2 * static_cast<double>(random()) / 4294967295.0 - 1;
    const Parameter& parameter = space.value().space->parameters()[static_cast<std::size_t>(i)];
    p[i] += u * (parameter.kind == ParameterKind::kRadius ? kSpread * p[i] : kShift);
  }
  Result<Design> design = space.value().space->at(p);
  if (!design) return design.error();
  return std::move(design).value().model;
}

}  // namespace

Result<Model> sheet_with_brief(SheetTargets targets, const Context& context) {
  Model model = sheet_to_design(kPins);
  model.design = brief_of_sheet();
  std::vector<Model> others;
  if (targets == SheetTargets::kOtherRadii) {
    model.title = "Sheet";
    model.design->settings.pins = DesignSettings::Pins::kAdaptive;
    for (const RadiiField& field : sheet_targets()) others.push_back(with_radii(model, field));
  } else {
    model.title = "Sheet with a hidden design";
    model.design->stages.clear();
    model.design->settings.iterations = 30;
    Result<Model> hidden = hidden_sheet(model);
    if (!hidden) return hidden;
    others.assign(model.poses.size(), hidden.value());
  }
  for (std::size_t k = 0; k < model.poses.size(); ++k) {
    Result<std::vector<Vec3>> places = settled_places(others[k], static_cast<int>(k), context);
    if (!places) return places.error();
    Selector all;
    all.kind = Selector::Kind::kAll;
    model.design->goals.push_back(
        {PositionsGoal{all, std::move(places).value(), {}}, model.poses[k].name, GoalStrength::kSoft, 1});
  }
  return model;
}

Model sheet_design() {
  Result<Model> made = sheet_with_brief(SheetTargets::kOtherRadii, {});
  LISSOM_ASSERT(made.ok());
  return std::move(made).value();
}

}  // namespace lissom::scene_models
