#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "lissom/model/brief_methods.h"
#include "lissom/model/json_value.h"
#include "lissom/model/validate_parts.h"

namespace lissom {
namespace {

enum class Sign { kAny, kPositive };

void check_range(Checker& check, const Vec2& range, Sign sign, const std::string& where) {
  check.finite(range[0], where + "/0");
  check.finite(range[1], where + "/1");
  if (check.failed()) return;
  if (!(range[0] < range[1])) {
    return check.fail(ErrorCode::kRange, where, "the lower bound has to be less than the upper one",
                      "give the smaller number first");
  }
  if (sign == Sign::kPositive) check.positive(range[0], where + "/0", "lower bound");
}

void check_range(Checker& check, const std::optional<Vec2>& range, Sign sign, const std::string& where) {
  if (range) check_range(check, *range, sign, where);
}

void check_controls(Checker& check, int controls, const std::string& where) {
  if (controls >= 2 && controls <= 4) return;
  check.fail(ErrorCode::kRange, where + "/controls", fmt::format("a rod has 2, 3 or 4 controls, not {}", controls),
             "4 is usual");
}

void check_names(Checker& check, const std::vector<std::string>& names, const std::vector<std::string>& known,
                 const char* what, const std::string& where) {
  for (std::size_t i = 0; i < names.size() && !check.failed(); ++i) {
    check.known(names[i], known, what, fmt::format("{}/{}", where, i));
    if (std::count(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) > 0) {
      check.fail(ErrorCode::kConflict, fmt::format("{}/{}", where, i),
                 fmt::format("the {} \"{}\" is named twice", what, names[i]), "name it once");
    }
  }
}

struct ParameterCheck {
  Checker& check;
  const std::string& where;  ///< of the parameter

  std::string at(const char* key) const { return where + "/" + key; }

  void operator()(const RadiiBrief& radii) const {
    check_controls(check, radii.controls, at("radii"));
    check_range(check, radii.range, Sign::kPositive, at("radii/range"));
  }
  void operator()(const RestShapeBrief& shape) const {
    check_controls(check, shape.controls, at("rest_shape"));
    check.positive(shape.reach, at("rest_shape/reach"), "reach");
  }
  void operator()(const LengthBrief& length) const {
    if (length.rods.empty()) check.fail(ErrorCode::kType, at("length/rods"), "no rod is named", "name some");
    check_names(check, length.rods, check.rods, "rod", at("length/rods"));
    check_range(check, length.factors, Sign::kPositive, at("length/factors"));
  }
  void operator()(const ModulusBrief& modulus) const {
    check_range(check, modulus.range, Sign::kPositive, at("youngs_modulus/range"));
  }
  void operator()(const FabricBrief& fabric) const {
    const std::string own = at("fabric");
    check_range(check, fabric.stiffness, Sign::kPositive, own + "/stiffness");
    check_range(check, fabric.stiffness_1, Sign::kPositive, own + "/stiffness_1");
    check_range(check, fabric.stiffness_2, Sign::kPositive, own + "/stiffness_2");
    check_range(check, fabric.poisson_ratio, Sign::kAny, own + "/poisson_ratio");
    check_range(check, fabric.thickness, Sign::kPositive, own + "/thickness");
    check_range(check, fabric.pre_stretch, Sign::kPositive, own + "/pre_stretch");
    if (check.failed()) return;
    if (fabric.poisson_ratio && ((*fabric.poisson_ratio)[0] <= -1 || (*fabric.poisson_ratio)[1] >= 1)) {
      check.fail(ErrorCode::kRange, own + "/poisson_ratio", "Poisson's ratio of a fabric has to lie between -1 and 1",
                 "narrow the range");
    }
    if (!fabric.stiffness && !fabric.stiffness_1 && !fabric.stiffness_2 && !fabric.poisson_ratio && !fabric.thickness &&
        !fabric.pre_stretch) {
      nothing(own);
    }
  }
  void operator()(const NaturalBrief& natural) const {
    const std::string own = at("natural");
    check_names(check, natural.rods, check.rods, "rod", own + "/rods");
    check_range(check, natural.curvature_b, Sign::kAny, own + "/curvature_b");
    check_range(check, natural.curvature_n, Sign::kAny, own + "/curvature_n");
    check_range(check, natural.twist, Sign::kAny, own + "/twist");
    check_range(check, natural.length_factor, Sign::kPositive, own + "/length_factor");
    if (!natural.curvature_b && !natural.curvature_n && !natural.twist && !natural.length_factor) nothing(own);
  }
  void operator()(const LoadBrief& load) const {
    struct Words {
      const char *key, *name;
    };
    constexpr Words kWords[] = {
        {"force", "force"}, {"moment", "moment"}, {"pin_target", "soft pin"}, {"move", "support"}};
    const Words words = kWords[static_cast<int>(load.kind)];
    const std::string own = at(words.key);
    const Pose* pose = check_pose_name(check, load.pose, own);
    if (pose == nullptr) return;
    const std::size_t counts[] = {pose->forces.size(), pose->moments.size(), pose->soft_pins.size(),
                                  pose->supports.size()};
    const std::size_t count = counts[static_cast<int>(load.kind)];
    if (load.number < 0 || static_cast<std::size_t>(load.number) >= count) {
      check.fail(ErrorCode::kUnknown, own + "/number",
                 fmt::format("pose \"{}\" has no {} number {}", pose->name, words.name, load.number),
                 fmt::format("there are {}, the first is number 0", count));
    }
    check_range(check, load.size, Sign::kAny, own + "/size");
    for (int i = 0; i < 3; ++i)
      check_range(check, load.xyz[static_cast<std::size_t>(i)], Sign::kAny, own + "/" + "xyz"[i]);
    const bool some = load.xyz[0] || load.xyz[1] || load.xyz[2];
    if (!load.size && !some) nothing(own);
    if (load.size && some) {
      check.fail(ErrorCode::kConflict, own, "both the size and components may change", "keep one of them");
    }
  }

  void operator()(const PlanBrief& plan) const {
    const std::string own = at("plan");
    if (!check.model.plan) check.fail(ErrorCode::kConflict, own, "the document has no plan", "draw one under \"plan\"");
    check_names(check, plan.points, check.plan_points, "point of the plan", own + "/points");
    check_range(check, plan.radii, Sign::kPositive, own + "/radii");
    if (plan.reach) check.positive(*plan.reach, own + "/reach", "reach");
    check_range(check, plan.pre_stretch, Sign::kPositive, own + "/pre_stretch");
    if (!plan.radii && !plan.reach && !plan.pre_stretch) nothing(own);
  }

  void nothing(const std::string& own) const {
    check.fail(ErrorCode::kType, own, "nothing here has a range", "give the bounds of something as [lower, upper]");
  }
};

struct GoalCheck {
  Checker& check;
  const std::string& where;  ///< of the goal

  void wanted(const GoalValue& value, const std::string& own) const {
    constexpr const char* kKeys[] = {"reach", "at_most", "at_least"};
    check.finite(value.value, own + "/" + kKeys[static_cast<int>(value.kind)]);
  }
  void membranes(const std::vector<std::string>& names, const std::string& own) const {
    check_names(check, names, check.membranes, "membrane", own + "/membranes");
    if (check.membranes.empty()) {
      check.fail(ErrorCode::kConflict, own, "the document has no membranes", "remove this goal");
    }
  }
  void rods(const std::vector<std::string>& names, const std::string& own) const {
    check_names(check, names, check.rods, "rod", own + "/rods");
  }

  void operator()(const PositionsGoal& goal) const {
    const std::string own = where + "/positions";
    check.selector(goal.at, own + "/at");
    if (goal.targets.empty()) check.fail(ErrorCode::kType, own + "/targets", "there is no target", "give one per node");
    for (std::size_t i = 0; i < goal.targets.size() && !check.failed(); ++i) {
      check.finite(goal.targets[i], fmt::format("{}/targets/{}", own, i));
    }
    double sum = 0;
    for (std::size_t i = 0; i < goal.weights.size() && !check.failed(); ++i) {
      check.not_negative(goal.weights[i], fmt::format("{}/weights/{}", own, i), "weight");
      sum += goal.weights[i];
    }
    if (check.failed() || goal.weights.empty()) return;
    if (goal.weights.size() != goal.targets.size()) {
      check.fail(ErrorCode::kConflict, own + "/weights",
                 fmt::format("there are {} weights and {} targets", goal.weights.size(), goal.targets.size()),
                 "give one weight per target, or none");
    } else if (!(sum > 0)) {
      check.fail(ErrorCode::kRange, own + "/weights", "all weights are 0", "let something count");
    }
  }
  void operator()(const PlaceGoal& goal) const {
    check.selector(goal.at, where + "/place/at");
    check.finite(goal.target, where + "/place/reach");
  }
  void operator()(const AngleGoal& goal) const {
    const std::string own = where + "/angle";
    for (const auto& [key, nodes] : {std::pair{"/from", &goal.from}, std::pair{"/to", &goal.to}}) {
      if (nodes->size() != 2) check.fail(ErrorCode::kType, own + key, "a direction goes from one node to another");
      for (std::size_t i = 0; i < nodes->size(); ++i) check.selector((*nodes)[i], fmt::format("{}{}/{}", own, key, i));
    }
    if (goal.axis) check.direction(*goal.axis, own + "/axis");
    wanted(goal.wanted, own);
  }
  void operator()(const ReactionGoal& goal) const {
    check.selector(goal.at, where + "/reaction/at");
    check.direction(goal.axis, where + "/reaction/axis");
    wanted(goal.wanted, where + "/reaction");
  }
  void operator()(const AreaGoal& goal) const {
    membranes(goal.membranes, where + "/area");
    wanted(goal.wanted, where + "/area");
  }
  void operator()(const VolumeGoal& goal) const {
    membranes(goal.membranes, where + "/enclosed_volume");
    wanted(goal.wanted, where + "/enclosed_volume");
  }
  void operator()(const MassGoal& goal) const {
    rods(goal.rods, where + "/mass");
    check_names(check, goal.membranes, check.membranes, "membrane", where + "/mass/membranes");
    wanted(goal.wanted, where + "/mass");
  }
  void operator()(const EnergyGoal& goal) const { wanted(goal.wanted, where + "/strain_energy"); }
  void operator()(const StretchGoal& goal) const {
    membranes(goal.membranes, where + "/smallest_stretch");
    wanted(goal.wanted, where + "/smallest_stretch");
  }
  void operator()(const StrainGoal& goal) const {
    rods(goal.rods, where + "/rod_strain");
    wanted(goal.wanted, where + "/rod_strain");
  }
  void operator()(const StabilityGoal& goal) const { wanted(goal.wanted, where + "/stability_margin"); }
};

void check_iterations(Checker& check, int iterations, const std::string& where) {
  if (iterations >= 1) return;
  check.fail(ErrorCode::kRange, where + "/iterations", "at least one iteration is needed", "100 is usual");
}

void check_settings(Checker& check, const DesignSettings& settings, const std::string& where) {
  if (std::find(kBriefMethods.begin(), kBriefMethods.end(), settings.method) == kBriefMethods.end()) {
    check.fail(ErrorCode::kUnknown, where + "/method", fmt::format("there is no method \"{}\"", settings.method),
               "\"structured_bfgs\" is usual");
  }
  check_iterations(check, settings.iterations, where);
  const auto share = [&](double value, const char* key) {
    if (value >= 0 && value < 1) return;
    check.fail(ErrorCode::kRange, where + "/" + key, "the tolerance has to lie between 0 and 1", "1e-6 is usual");
  };
  share(settings.gradient_tolerance, "gradient_tolerance");
  share(settings.decrease_tolerance, "decrease_tolerance");
  check.positive(settings.constraint_tolerance, where + "/constraint_tolerance", "tolerance");
  check.positive(settings.solve_tolerance, where + "/solve_tolerance", "tolerance");
}

}  // namespace

const Pose* check_pose_name(Checker& check, const std::string& name, const std::string& where) {
  if (check.failed()) return nullptr;
  if (!name.empty()) check.known(name, check.poses, "pose", where + "/pose");
  if (name.empty() && check.model.poses.size() != 1) {
    check.fail(ErrorCode::kUnknown, where + "/pose",
               check.model.poses.empty() ? "the document has no pose" : "it is not said which pose is meant",
               check.model.poses.empty() ? "describe one under \"poses\"" : "name one of the poses");
  }
  if (check.failed()) return nullptr;
  return name.empty() ? &check.model.poses.front() : check.model.pose(name);
}

void check_parameters(Checker& check, const std::vector<ParameterBrief>& parameters, const std::string& where) {
  if (parameters.empty()) {
    check.fail(ErrorCode::kType, where + "/parameters", "nothing may change", "say what a design may change");
  }
  for (std::size_t i = 0; i < parameters.size() && !check.failed(); ++i) {
    const ParameterBrief& parameter = parameters[i];
    const std::string own = fmt::format("{}/parameters/{}", where, i);
    std::visit(ParameterCheck{check, own}, parameter.what);
    if (!parameter.mirror || check.failed()) continue;
    check.direction(parameter.mirror->normal, own + "/mirror/normal");
    check.finite(parameter.mirror->offset, own + "/mirror/offset");
    check.not_negative(parameter.mirror->tolerance, own + "/mirror/within", "distance");
  }
}

void check_design(Checker& check, const Brief& brief, const std::string& where) {
  for (std::size_t k = 0; k < brief.stages.size() && !check.failed(); ++k) {
    const std::string own = fmt::format("{}/stages/{}", where, k);
    check_parameters(check, brief.stages[k].parameters, own);
    if (brief.stages[k].iterations) check_iterations(check, *brief.stages[k].iterations, own);
  }
  check_parameters(check, brief.parameters, where);
  if (brief.goals.empty()) check.fail(ErrorCode::kType, where + "/goals", "there is no goal", "say what to reach");
  for (std::size_t i = 0; i < brief.goals.size() && !check.failed(); ++i) {
    const GoalBrief& goal = brief.goals[i];
    const std::string own = fmt::format("{}/goals/{}", where, i);
    if (check_pose_name(check, goal.pose, own) == nullptr) return;
    std::visit(GoalCheck{check, own}, goal.what);
    check.positive(goal.weight, own + "/weight", "weight");
  }
  check.not_negative(brief.wishes.closeness, where + "/wishes/closeness", "weight");
  check.not_negative(brief.wishes.smoothness, where + "/wishes/smoothness", "weight");
  check.not_negative(brief.wishes.clearance, where + "/wishes/clearance", "gap");
  check_settings(check, brief.settings, where + "/settings");
}

}  // namespace lissom
