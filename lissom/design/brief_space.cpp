#include "lissom/design/brief_space.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numeric>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/design/design_spaces.h"
#include "lissom/design/load_space.h"
#include "lissom/design/network_radii.h"
#include "lissom/design/parameter_goals.h"
#include "lissom/design/plan_design_space.h"
#include "lissom/design/rest_shape.h"
#include "lissom/design/stiffness_spaces.h"

namespace lissom {

namespace {

constexpr double kMirrorTolerance = 1e-4;  // of the size of the structure
constexpr double kRounding = 1e-9;         // of a radius at its bound
constexpr double kSameRadius = 1e-6;       // of a radius that the space has kept

ControlStage stage_of(int controls) { return static_cast<ControlStage>(controls); }

template <class Space>
Result<SpacePtr> shared(Result<Space> space) {
  if (!space) return space.error();
  return SpacePtr(std::make_shared<const Space>(std::move(space).value()));
}

/// The space begins at the nearest radii that it has; those of the document have to be among them. Between controls they may
/// be outside of the range by what the space itself leaves there.
Status check_start(const RadiiBrief& radii, const LinearSpace& space, const Structure& structure) {
  const Result<Design> start = space.at(space.start());
  if (!start) return start.error();
  for (std::size_t e = 0; e < structure.edges.size(); ++e) {
    const Section& has = structure.edges[e].section;
    const Section& gets = start.value().system.structure.edges[e].section;
    for (const auto& [r, kept] : {std::pair(has.r_n, gets.r_n), std::pair(has.r_b, gets.r_b)}) {
      if (r >= radii.range[0] * (1 - kRounding) && r <= radii.range[1] * (1 + kRounding)) continue;
      if (std::abs(kept - r) <= kSameRadius * r) continue;
      return Error{
          ErrorCode::kRange, "radii/range",
          fmt::format("rod \"{}\" has a radius of {:.4g} mm, which is outside of {:.4g} to {:.4g} mm",
                      structure.rods[structure.edges[e].rod].name, 1e3 * r, 1e3 * radii.range[0], 1e3 * radii.range[1]),
          "widen the range, or start from other radii"};
    }
  }
  return {};
}

struct SpaceMaker {
  const std::shared_ptr<const Design>& base;
  const SpacePtr& plan;  ///< made before, for it makes the base

  Result<SpacePtr> operator()(const RadiiBrief& radii) const {
    Result<LinearSpace> space = radii_space(base, stage_of(radii.controls), radii.range);
    if (!space) return space.error();
    if (const Status s = check_start(radii, space.value(), base->system.structure); !s) return s.error();
    return shared(std::move(space));
  }
  Result<SpacePtr> operator()(const RestShapeBrief& shape) const {
    const RestShapeGauge gauge =
        shape.gauge == RestShapeBrief::Gauge::kFree ? RestShapeGauge::kFree : RestShapeGauge::kFixSix;
    return shared(rest_shape_space(base, {stage_of(shape.controls), shape.reach, gauge}));
  }
  Result<SpacePtr> operator()(const LengthBrief& length) const {
    return shared(straight_length_space(base, length.rods, length.factors));
  }
  Result<SpacePtr> operator()(const ModulusBrief& modulus) const {
    const ModulusChoice choice =
        modulus.per == ModulusBrief::Per::kRod ? ModulusChoice::kPerRod : ModulusChoice::kPerMaterial;
    return shared(youngs_modulus_space(base, choice, modulus.range));
  }
  Result<SpacePtr> operator()(const FabricBrief& fabric) const {
    std::vector<SheetChoice> choices;
    const auto add = [&choices](SheetProperty property, const std::optional<Vec2>& range) {
      if (range) choices.push_back({property, *range});
    };
    add(SheetProperty::kStiffness, fabric.stiffness);
    add(SheetProperty::kStiffness1, fabric.stiffness_1);
    add(SheetProperty::kStiffness2, fabric.stiffness_2);
    add(SheetProperty::kPoissonRatio, fabric.poisson_ratio);
    add(SheetProperty::kThickness, fabric.thickness);
    add(SheetProperty::kPreStretch, fabric.pre_stretch);
    return shared(fabric_space(base, choices));
  }
  Result<SpacePtr> operator()(const NaturalBrief& natural) const {
    std::vector<NaturalChoice> choices;
    const auto add = [&choices](NaturalProperty property, const std::optional<Vec2>& range) {
      if (range) choices.push_back({property, *range});
    };
    add(NaturalProperty::kCurvatureB, natural.curvature_b);
    add(NaturalProperty::kCurvatureN, natural.curvature_n);
    add(NaturalProperty::kTwist, natural.twist);
    add(NaturalProperty::kLengthFactor, natural.length_factor);
    return shared(natural_shape_space(base, natural.rods, choices));
  }
  Result<SpacePtr> operator()(const LoadBrief& load) const {
    constexpr LoadKind kKinds[] = {LoadKind::kForce, LoadKind::kMoment, LoadKind::kPinTarget, LoadKind::kMove};
    const LoadKind kind = kKinds[static_cast<int>(load.kind)];
    const int pose = brief_pose(base->model, load.pose);
    std::vector<LoadChoice> choices;
    if (load.size) choices.push_back({kind, pose, load.number, LoadPart::kSize, *load.size});
    for (int i = 0; i < 3; ++i) {
      const std::optional<Vec2>& range = load.xyz[static_cast<std::size_t>(i)];
      if (range) choices.push_back({kind, pose, load.number, static_cast<LoadPart>(i), *range});
    }
    return shared(load_space(base, choices));
  }
  Result<SpacePtr> operator()(const PlanBrief&) const { return plan; }
};

PlanSpaceOptions options_of(const PlanBrief& brief) {
  PlanSpaceOptions options;
  options.points = brief.points;
  options.radii = brief.radii ? Choice::kFree : Choice::kFixed;
  options.positions = brief.reach ? Choice::kFree : Choice::kFixed;
  options.pre_stretch = PreStretchChoice::kFixed;
  if (brief.radii) options.radius_range = *brief.radii;
  if (brief.reach) options.reach = *brief.reach;
  if (brief.pre_stretch) {
    options.pre_stretch_range = *brief.pre_stretch;
    options.pre_stretch =
        brief.axes == PlanBrief::PreStretch::kCommon ? PreStretchChoice::kCommon : PreStretchChoice::kPerAxis;
  }
  return options;
}

/// The design as drawn, and the space of the plan where the brief changes it: that space has a mesh of its own.
struct Base {
  std::shared_ptr<const Design> design;
  SpacePtr plan;
};

Result<Base> make_base(const Brief& brief, const Model& model) {
  Base base;
  for (std::size_t i = 0; i < brief.parameters.size(); ++i) {
    const PlanBrief* plan = std::get_if<PlanBrief>(&brief.parameters[i].what);
    if (plan == nullptr) continue;
    const std::string where = fmt::format("/design/parameters/{}", i);
    if (base.plan) return Error{ErrorCode::kConflict, where, "the plan is chosen twice", "choose it once"};
    Result<PlanDesignSpace> made = PlanDesignSpace::make(model, options_of(*plan));
    if (!made) return made.error();
    const auto space = std::make_shared<const PlanDesignSpace>(std::move(made).value());
    base = {space->base(), space};
  }
  if (base.design) return base;
  Result<System> system = make_system(model);
  if (!system) return system.error();
  base.design = std::make_shared<const Design>(Design{model, std::move(system).value()});
  return base;
}

/// "radii", as in documents.
const char* word_of(const ParameterKindBrief& what) {
  constexpr const char* kWords[] = {"radii",   "rest shape",     "lengths", "moduli",
                                    "fabrics", "natural shapes", "loads",   "plan"};
  static_assert(std::size(kWords) == std::variant_size_v<ParameterKindBrief>);
  return kWords[what.index()];
}

Result<SpacePtr> make_entry(const ParameterBrief& entry, const Base& made) {
  const std::shared_ptr<const Design>& base = made.design;
  Result<SpacePtr> space = std::visit(SpaceMaker{base, made.plan}, entry.what);
  if (!space) return space;
  if (entry.mirror) {
    const MirrorBrief& mirror = *entry.mirror;
    const double tolerance = mirror.tolerance > 0 ? mirror.tolerance : kMirrorTolerance * base->system.structure.size;
    space = shared(mirrored(space.value(), mirror.normal, mirror.offset, tolerance));
    if (!space) return space;
  }
  if (entry.freedom == Freedom::kCommonFactor) {
    return shared(common_factor(space.value(), fmt::format("factor of {}", word_of(entry.what))));
  }
  if (entry.freedom == Freedom::kCommonValue && space.value()->size() > 1) {
    std::vector<int> all(static_cast<std::size_t>(space.value()->size()));
    std::iota(all.begin(), all.end(), 0);
    return shared(tied_parameters(space.value(), {all}));
  }
  return space;
}

/// Parameters are found by the places of their controls: some spaces leave parameters out or tie them.
void add_neighbours(int controls_of_rods, const Structure& structure, std::span<const Parameter> parameters, int first,
                    std::vector<std::array<int, 2>>& neighbours) {
  const Result<RodControls> controls = RodControls::make(structure, stage_of(controls_of_rods));
  if (!controls) return;  // the space of such a structure is an error of its own
  std::map<std::array<double, 4>, int> found;
  const auto key = [](const Vec3& at, int axis) {
    return std::array<double, 4>{at.x(), at.y(), at.z(), static_cast<double>(axis)};
  };
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Parameter& p = parameters[i];
    if (p.at) found.emplace(key(*p.at, p.axis), first + static_cast<int>(i));
  }
  constexpr std::array<int, 1> kFirst{0};
  for (const auto& [a, b] : neighbours_along_rods(controls.value(), structure, kFirst)) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto one = found.find(key(controls.value().place(a, structure), axis));
      const auto other = found.find(key(controls.value().place(b, structure), axis));
      if (one != found.end() && other != found.end()) neighbours.push_back({one->second, other->second});
    }
  }
}

}  // namespace

int brief_pose(const Model& model, const std::string& name) {
  for (std::size_t i = 0; i < model.poses.size(); ++i) {
    if (name.empty() || model.poses[i].name == name) return static_cast<int>(i);
  }
  LISSOM_ASSERT(false);
  return -1;
}

Result<BriefSpace> make_brief_space(const Brief& brief, const Model& model) {
  const Result<Base> base = make_base(brief, model);
  if (!base) return base.error();
  BriefSpace made;
  made.base = base.value().design;
  std::vector<SpacePtr> parts;
  int first = 0;
  for (std::size_t i = 0; i < brief.parameters.size(); ++i) {
    const ParameterBrief& entry = brief.parameters[i];
    const std::string where = fmt::format("/design/parameters/{}", i);
    Result<SpacePtr> space = make_entry(entry, base.value());
    Status status = space ? check_bounds(space.value()->parameters(), space.value()->start()) : Status(space.error());
    if (!status) {
      Error error = status.error();
      error.message = error.where.empty() || error.where.starts_with("/") || error.where.starts_with("radii/")
                          ? error.message
                          : error.where + ": " + error.message;
      error.where = where + (error.where.starts_with("radii/") ? "/" + error.where : "");
      return error;
    }
    const auto* radii = std::get_if<RadiiBrief>(&entry.what);
    const auto* shape = std::get_if<RestShapeBrief>(&entry.what);
    if (entry.freedom == Freedom::kEach && (radii != nullptr || shape != nullptr)) {
      add_neighbours(radii != nullptr ? radii->controls : shape->controls, made.base->system.structure,
                     space.value()->parameters(), first, made.neighbours);
    }
    first += space.value()->size();
    parts.push_back(std::move(space).value());
  }
  if (parts.size() == 1) {
    made.space = parts.front();
    return made;
  }
  Result<SpacePtr> sum = shared(SumSpace::make(std::move(parts)));
  if (!sum) {
    Error error = sum.error();
    error.where = "/design/parameters";
    return error;
  }
  made.space = std::move(sum).value();
  return made;
}

}  // namespace lissom
