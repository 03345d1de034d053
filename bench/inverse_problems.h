#pragma once
/// The inverse problems on which methods are compared: documents with a brief, as `lissom optimize` takes them.

#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bench/fabric_problems.h"
#include "lissom/design/brief_goals.h"
#include "lissom/design/structure_problem.h"
#include "scenes/parts.h"
#include "scenes/settled_places.h"
#include "scenes/sheet_brief.h"

namespace lissom::inverse {

using Places = std::vector<Vec3>;

inline Selector everything() { return {}; }

inline GoalBrief at_places(Selector at, Places targets, std::string pose = {}) {
  return {PositionsGoal{std::move(at), std::move(targets), {}}, std::move(pose), GoalStrength::kSoft, 1};
}

inline ParameterBrief radii(int controls, Vec2 range) { return {RadiiBrief{controls, range}, {}, Freedom::kEach}; }

inline ParameterBrief rest_shape(int controls, double reach) {
  return {RestShapeBrief{controls, reach, RestShapeBrief::Gauge::kFree}, {}, Freedom::kEach};
}

/// A rod of 0.2 m with 60 edges, clamped at its start, with a force at its tip.
inline Model rod(double radius, const Vec3& force) {
  Model model;
  model.rods.push_back(
      scene_models::round_rod("rod", Polyline{{Vec3::Zero(), Vec3(0.2, 0, 0)}, false}, radius, "TPU 92A", 60));
  Pose pose;
  pose.name = "bent";
  pose.supports.push_back(scene_models::hold(scene_models::rod_place("rod", 0), SupportKind::kClamp));
  PointForce load;
  load.at = scene_models::rod_place("rod", 1);
  load.force = force;
  pose.forces.push_back(load);
  model.poses.push_back(pose);
  return model;
}

/// One rod to a curve: radii and rest shape at four places, towards a wave that hangs.
inline Result<Model> rod_to_curve() {
  Model model = rod(1.5e-3, Vec3(0, 0, -0.004));
  Places targets;
  for (int i = 0; i <= 60; ++i) {
    const double s = i / 60.0;
    targets.emplace_back(0.19 * s, 0.008 * std::sin(std::numbers::pi * s),
                         -0.05 * s * s - 0.006 * std::sin(2 * std::numbers::pi * s));
  }
  model.design.emplace();
  model.design->parameters = {radii(4, {0.7e-3, 3e-3}), rest_shape(4, 0.03)};
  model.design->goals = {at_places(everything(), targets)};
  return model;
}

/// The Sheet with its four poses: radii at joints.
inline Result<Model> sheet() {
  Result<Model> model = scene_models::sheet_with_brief(scene_models::SheetTargets::kOtherRadii, {});
  if (!model) return model;
  Brief& brief = *model.value().design;
  brief.parameters = brief.stages.front().parameters;
  brief.stages.clear();
  brief.settings.pins = DesignSettings::Pins::kFixed;
  return model;
}

/// A disc of fabric with a ring and two crossing rods, dragged at three points: a plan's radii, places and pre-stretch.
inline Result<Model> dragged_disc() {
  Model model = networks::crossed_disc();
  model.plan->edge_length = 3e-3;
  model.plan->fabric.edge_length = 6e-3;
  const Result<Places> places = scene_models::settled_places(model, 0, {});
  if (!places) return places.error();
  const Result<System> system = make_system(model);
  if (!system) return system.error();
  Selector dragged;
  dragged.kind = Selector::Kind::kUnion;
  for (const char* name : {"e", "n", "centre"}) {
    Selector point;
    point.kind = Selector::Kind::kPlanPoint;
    point.name = name;
    dragged.parts.push_back(point);
  }
  const Result<std::vector<int>> nodes = select(model, system.value().structure, dragged, "dragged");
  if (!nodes) return nodes.error();
  Places targets;
  const Vec3 drags[] = {{0.004, 0, 0.008}, {0, -0.005, 0.003}, {0.003, 0.003, -0.006}};
  for (std::size_t i = 0; i < nodes.value().size(); ++i) {
    targets.push_back(places.value()[static_cast<std::size_t>(nodes.value()[i])] + drags[i]);
  }
  // Held softly where it is at three points, one of which is dragged all the same: else it might lie anywhere.
  for (const char* name : {"w", "s", "n"}) {
    Selector at;
    at.kind = Selector::Kind::kPlanPoint;
    at.name = name;
    const Result<std::vector<int>> node = select(model, system.value().structure, at, name);
    if (!node) return node.error();
    model.poses[0].soft_pins.push_back({at, 2, places.value()[static_cast<std::size_t>(node.value()[0])]});
  }
  model.design.emplace();
  PlanBrief plan;
  plan.radii = Vec2(0.4e-3, 2e-3);
  plan.reach = 0.1;
  plan.pre_stretch = Vec2(1.2, 1.6);
  model.design->parameters = {{plan, {}, Freedom::kEach}};
  model.design->goals = {at_places(dragged, targets)};
  return model;
}

/// A square of fabric held at one side, pulled in two directions and aslant.
inline Model pulled_fabric(double stiffness_1, double stiffness_2, double poisson_ratio) {
  Model model;
  model.membrane_materials.push_back({"fabric", stiffness_1, stiffness_2, poisson_ratio, 0, 0, "to be found"});
  Membrane sheet;
  sheet.name = "fabric";
  sheet.material = "fabric";
  sheet.shape = MembraneGrid{Vec2::Zero(), Vec2(0.1, 0.1), 10, 10};
  sheet.warp_angle = 0.3;
  model.membranes.push_back(sheet);
  const std::pair<const char*, Vec3> pulls[] = {
      {"along", {0.3, 0, 0}}, {"across", {0, 0.3, 0}}, {"aslant", {0.2, 0.15, 0}}};
  for (const auto& [name, force] : pulls) {
    Pose pose;
    pose.name = name;
    const bool across = std::string_view(name) == "across";
    const Vec3 low_end = across ? Vec3(1, 1e-6, 1) : Vec3(1e-6, 1, 1);
    pose.supports.push_back(scene_models::hold(scene_models::box(Vec3(-1, -1, -1), low_end), SupportKind::kPin));
    // Kept flat: a sheet without bending wrinkles beside its clamp.
    Support flat = scene_models::hold(scene_models::box(across ? Vec3(-1, 1e-6, -1) : Vec3(1e-6, -1, -1), Vec3::Ones()),
                                      SupportKind::kFree);
    flat.directions = {Vec3::UnitZ()};
    pose.supports.push_back(flat);
    PointForce load;
    load.at = scene_models::box(across ? Vec3(-1, 0.1 - 1e-6, -1) : Vec3(0.1 - 1e-6, -1, -1), Vec3::Ones());
    load.force = force;
    load.shared = true;
    pose.forces.push_back(load);
    model.poses.push_back(pose);
  }
  return model;
}

/// Calibration: two moduli and Poisson's ratio from shapes that were measured to 0.05 mm.
inline Result<Model> calibration() {
  Model model = pulled_fabric(40, 40, 0.1);
  const Model truth = pulled_fabric(30, 18, 0.28);
  model.design.emplace();
  std::mt19937 random(7);
  const auto noise = [&random] { return 1e-4 * (static_cast<double>(random()) / 4294967295.0 - 0.5); };
  for (std::size_t k = 0; k < model.poses.size(); ++k) {
    Result<Places> places = scene_models::settled_places(truth, static_cast<int>(k), {});
    if (!places) return places.error();
    for (Vec3& x : places.value()) x += Vec3(noise(), noise(), 0);
    model.design->goals.push_back(at_places(everything(), places.value(), model.poses[k].name));
  }
  FabricBrief fabric;
  fabric.stiffness_1 = fabric.stiffness_2 = Vec2(5, 200);
  fabric.poisson_ratio = Vec2(-0.2, 0.45);
  model.design->parameters = {{fabric, {}, Freedom::kEach}};
  return model;
}

/// A target out of reach: the rod is to stand up against its load.
inline Result<Model> out_of_reach() {
  Model model = rod(1.5e-3, Vec3(0, 0, -0.006));
  Places targets;
  for (int i = 0; i <= 60; ++i) targets.emplace_back(0.15 * i / 60, 0, 0.05 * i / 60);
  model.design.emplace();
  model.design->parameters = {radii(4, {1e-3, 2e-3}), rest_shape(4, 0.01)};
  model.design->goals = {at_places(everything(), targets)};
  return model;
}

/// Near a bifurcation: a strut just beyond its buckling load is to be nearly straight.
inline Result<Model> near_bifurcation() {
  Model model = rod(1.5e-3, Vec3::Zero());
  const double stiffness = find_material("TPU 92A")->youngs_modulus * std::numbers::pi * std::pow(1.5e-3, 4) / 4;
  const double critical = std::numbers::pi * std::numbers::pi * stiffness / (4 * 0.2 * 0.2);
  Pose& pose = model.poses.front();
  pose.forces.front().force = Vec3(-1.1 * critical, 0, 0.003 * critical);
  Model wanted = model;
  wanted.poses.front().forces.front().force = Vec3(-0.98 * critical, 0, 0.003 * critical);
  const Result<Places> places = scene_models::settled_places(wanted, 0, {});
  if (!places) return places.error();
  model.design.emplace();
  model.design->parameters = {radii(4, {0.8e-3, 2.5e-3})};
  model.design->goals = {at_places(everything(), places.value())};
  return model;
}

struct Case {
  const char* name;
  Result<Model> (*make)();
};
constexpr Case kCases[] = {{"rod to a curve", rod_to_curve}, {"sheet, four poses", sheet},
                           {"dragged disc", dragged_disc},   {"calibration", calibration},
                           {"out of reach", out_of_reach},   {"near a bifurcation", near_bifurcation}};

/// The problem of a document, released.
inline Result<std::unique_ptr<StructureProblem>> released(const Model& model, const Context& context) {
  const Result<BriefSpace> space = make_brief_space(*model.design, model);
  if (!space) return space.error();
  const Result<BriefGoals> goals = make_brief_goals(*model.design, space.value());
  if (!goals) return goals.error();
  StructureProblemOptions options;
  options.solve.tolerance = model.design->settings.solve_tolerance;
  Result<std::unique_ptr<StructureProblem>> problem =
      StructureProblem::make(space.value().space, goals.value().goals, goals.value().wishes, options, context);
  if (!problem) return problem;
  if (const Status s = problem.value()->release(); !s) return s.error();
  return problem;
}

}  // namespace lissom::inverse
