#include "lissom/model/brief_json.h"
#include "lissom/model/brief_methods.h"

namespace lissom {
namespace {

using Gauge = RestShapeBrief::Gauge;
using Control = DesignSettings::Control;
constexpr std::pair<std::string_view, Gauge> kGauges[] = {{"fix_six", Gauge::kFixSix}, {"free", Gauge::kFree}};
constexpr std::pair<std::string_view, ModulusBrief::Per> kPers[] = {{"material", ModulusBrief::Per::kMaterial},
                                                                    {"rod", ModulusBrief::Per::kRod}};
constexpr std::pair<std::string_view, Control> kControls[] = {{"line_search", Control::kLineSearch},
                                                              {"trust_region", Control::kTrustRegion}};
constexpr std::pair<std::string_view, DesignSettings::Pins> kPins[] = {{"fixed", DesignSettings::Pins::kFixed},
                                                                       {"adaptive", DesignSettings::Pins::kAdaptive}};
constexpr std::pair<std::string_view, Freedom> kFreedoms[] = {
    {"each", Freedom::kEach}, {"common_factor", Freedom::kCommonFactor}, {"common_value", Freedom::kCommonValue}};
constexpr std::pair<std::string_view, PlanBrief::PreStretch> kAxes[] = {{"common", PlanBrief::PreStretch::kCommon},
                                                                        {"per_axis", PlanBrief::PreStretch::kPerAxis}};
constexpr IntegerOf kPlaces{2, 4};

/// [lower, upper].
constexpr PairOf range_of(Measure measure) { return {measure, measure}; }

/// One of kBriefMethods.
struct MethodOf {
  static std::array<std::pair<std::string_view, std::string_view>, kBriefMethods.size()> words() {
    std::array<std::pair<std::string_view, std::string_view>, kBriefMethods.size()> pairs;
    for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i] = {kBriefMethods[i], kBriefMethods[i]};
    return pairs;
  }
  void read(Reader& reader, const JsonValue& json, std::string& value) const {
    const auto known = words();
    std::string_view word = value;
    ChoiceOf<std::string_view>{known}.read(reader, json, word);
    value = std::string(word);
  }
  JsonValue write(const std::string& value) const { return JsonValue::string(value); }
  JsonValue schema(Schema& schema) const {
    const auto known = words();
    return ChoiceOf<std::string_view>{known}.schema(schema);
  }
};

/// A load as the key says that names it.
template <LoadBrief::Kind Kind>
struct LoadEntry {
  LoadBrief load{Kind, {}, 0, {}, {}};
};

constexpr Measure measure_of(LoadBrief::Kind kind) {
  if (kind == LoadBrief::Kind::kForce) return Measure::kForce;
  return kind == LoadBrief::Kind::kMoment ? Measure::kMoment : Measure::kLength;
}

template <LoadBrief::Kind Kind>
void describe(Fields& fields, LoadEntry<Kind>& entry) {
  LoadBrief& load = entry.load;
  const PairOf range = range_of(measure_of(Kind));
  fields.field("pose", load.pose, TextOf{false}, kOptional, "Its pose; the only one when absent.")
      .field("number", load.number, IntegerOf{}, kOptional, "Which of the list of the pose, from 0.");
  if constexpr (Kind != LoadBrief::Kind::kPinTarget) {
    fields.field("size", load.size, range, kOptional, "Bounds along its present direction.");
  }
  fields.field("x", load.xyz[0], range, kOptional, "Bounds of the component along x.")
      .field("y", load.xyz[1], range, kOptional, "Bounds of the component along y.")
      .field("z", load.xyz[2], range, kOptional, "Bounds of the component along z.");
}

using ForceEntry = LoadEntry<LoadBrief::Kind::kForce>;
using MomentEntry = LoadEntry<LoadBrief::Kind::kMoment>;
using PinEntry = LoadEntry<LoadBrief::Kind::kPinTarget>;
using MoveEntry = LoadEntry<LoadBrief::Kind::kMove>;

struct ParameterEntry {
  std::optional<RadiiBrief> radii;
  std::optional<RestShapeBrief> rest_shape;
  std::optional<LengthBrief> length;
  std::optional<ModulusBrief> modulus;
  std::optional<FabricBrief> fabric;
  std::optional<NaturalBrief> natural;
  std::optional<ForceEntry> force;
  std::optional<MomentEntry> moment;
  std::optional<PinEntry> pin_target;
  std::optional<MoveEntry> move;
  std::optional<PlanBrief> plan;
  std::optional<MirrorBrief> mirror;
  Freedom freedom = Freedom::kEach;
};

void describe(Fields& fields, ParameterEntry& p) {
  fields.field("radii", p.radii, ObjectOf<RadiiBrief>{"radii"}, kOptional, "Half-extents of rods, along both axes.")
      .field("rest_shape", p.rest_shape, ObjectOf<RestShapeBrief>{"rest shape"}, kOptional,
             "The shape of rod networks as drawn.")
      .field("length", p.length, ObjectOf<LengthBrief>{"lengths"}, kOptional, "Lengths of straight rods.")
      .field("youngs_modulus", p.modulus, ObjectOf<ModulusBrief>{"moduli"}, kOptional,
             "Young's moduli of rods; Poisson's ratios and densities stay.")
      .field("fabric", p.fabric, ObjectOf<FabricBrief>{"fabric ranges"}, kOptional,
             "Moduli and pre-stretch of fabrics.")
      .field("natural", p.natural, ObjectOf<NaturalBrief>{"natural ranges"}, kOptional, "Natural shapes of rods.")
      .field("force", p.force, ObjectOf<ForceEntry>{"force ranges"}, kOptional, "A force of a pose.")
      .field("moment", p.moment, ObjectOf<MomentEntry>{"moment ranges"}, kOptional, "A moment of a pose.")
      .field("pin_target", p.pin_target, ObjectOf<PinEntry>{"pin target ranges"}, kOptional,
             "The target of a soft pin of a pose.")
      .field("move", p.move, ObjectOf<MoveEntry>{"move ranges"}, kOptional, "The movement of a support of a pose.")
      .field("plan", p.plan, ObjectOf<PlanBrief>{"plan ranges"}, kOptional,
             "The plan and the pre-stretch of its fabric.")
      .field("mirror", p.mirror, ObjectOf<MirrorBrief>{"mirror"}, kOptional,
             "A plane at whose sides these parameters agree.")
      .field("freedom", p.freedom, ChoiceOf<Freedom>{kFreedoms}, kOptional,
             "Whether they change one by one, by one factor, or all have one value.");
}

constexpr ObjectOf<ParameterEntry> kParameter{"design parameter"};

}  // namespace

// Found by argument-dependent lookup, hence in the namespace of the structs.
void describe(Fields& fields, RadiiBrief& radii) {
  fields.field("controls", radii.controls, kPlaces, kOptional, "At how many places of each rod, ends included.")
      .field("range", radii.range, range_of(Measure::kLength), kRequired, "Smallest and largest radius.");
}

void describe(Fields& fields, RestShapeBrief& shape) {
  fields.field("controls", shape.controls, kPlaces, kOptional, "At how many places of each rod, ends included.")
      .field("reach", shape.reach, NumberOf{Measure::kLength, kPositive}, kRequired,
             "How far these places may move along each axis.")
      .field("gauge", shape.gauge, ChoiceOf<Gauge>{kGauges}, kOptional,
             "Whether six coordinates are fixed, so that the drawing does not move as a whole.");
}

void describe(Fields& fields, LengthBrief& length) {
  fields.field("rods", length.rods, ListOf<TextOf>{{false}, 1}, kRequired, "Which rods.")
      .field("factors", length.factors, range_of(Measure::kRatio), kOptional, "Bounds, over what is drawn.");
}

void describe(Fields& fields, ModulusBrief& modulus) {
  fields
      .field("per", modulus.per, ChoiceOf<ModulusBrief::Per>{kPers}, kOptional,
             "One for each material, or one for each rod.")
      .field("range", modulus.range, range_of(Measure::kStress), kRequired, "Bounds.");
}

void describe(Fields& fields, FabricBrief& fabric) {
  const PairOf sheet = range_of(Measure::kForcePerLength), ratio = range_of(Measure::kRatio);
  fields.field("stiffness", fabric.stiffness, sheet, kOptional, "Bounds along axis 1; the ratio of both axes stays.")
      .field("stiffness_1", fabric.stiffness_1, sheet, kOptional, "Bounds along axis 1 alone.")
      .field("stiffness_2", fabric.stiffness_2, sheet, kOptional, "Bounds along axis 2 alone.")
      .field("poisson_ratio", fabric.poisson_ratio, ratio, kOptional, "Bounds of Poisson's ratio.")
      .field("thickness", fabric.thickness, range_of(Measure::kLength), kOptional,
             "Bounds of the thickness, which acts on bending.")
      .field("pre_stretch", fabric.pre_stretch, ratio, kOptional, "Bounds along axis 1; the ratio of both axes stays.");
}

void describe(Fields& fields, NaturalBrief& natural) {
  const PairOf curvature = range_of(Measure::kCurvature);
  fields.field("rods", natural.rods, ListOf<TextOf>{{false}}, kOptional, "Which rods; all when absent.")
      .field("curvature_b", natural.curvature_b, curvature, kOptional, "Bounds of the curvature towards b.")
      .field("curvature_n", natural.curvature_n, curvature, kOptional, "Bounds of the curvature towards n.")
      .field("twist", natural.twist, range_of(Measure::kTwistRate), kOptional, "Bounds of the twist rate.")
      .field("length_factor", natural.length_factor, range_of(Measure::kRatio), kOptional,
             "Bounds of the natural length over the drawn one.");
}

void describe(Fields& fields, PlanBrief& plan) {
  fields.field("points", plan.points, ListOf<TextOf>{{false}}, kOptional, "Which points; all when absent.")
      .field("radii", plan.radii, range_of(Measure::kLength), kOptional, "Bounds of the radii at these points.")
      .field("reach", plan.reach, NumberOf{Measure::kRatio, kPositive}, kOptional,
             "How far these points may move along x and y, over the size of the plan.")
      .field("pre_stretch", plan.pre_stretch, range_of(Measure::kRatio), kOptional, "Bounds of the pre-stretch.")
      .field("axes", plan.axes, ChoiceOf<PlanBrief::PreStretch>{kAxes}, kOptional,
             "Whether one factor changes the pre-stretch of both axes, or each has its own.");
}

void describe(Fields& fields, MirrorBrief& mirror) {
  fields.field("normal", mirror.normal, DirectionOf(), kRequired, "Normal of the plane.")
      .field("offset", mirror.offset, NumberOf{Measure::kLength}, kOptional, "Where the plane is, along the normal.")
      .field("within", mirror.tolerance, NumberOf{Measure::kLength, kPositive}, kOptional,
             "How far mirror images may be apart; 1e-4 of the size when absent.");
}

void describe(Fields& fields, WishesBrief& wishes) {
  const NumberOf weight{Measure::kRatio, kNotNegative};
  fields.field("closeness", wishes.closeness, weight, kOptional, "Weight of staying near the start.")
      .field("smoothness", wishes.smoothness, weight, kOptional,
             "Weight of neighbouring controls of radii and rest shapes being alike.")
      .field("clearance", wishes.clearance, NumberOf{Measure::kLength, kNotNegative}, kOptional,
             "Gap that rods should keep where they share no joint, such as what a printer needs.");
}

void describe(Fields& fields, DesignSettings& settings) {
  const NumberOf share{Measure::kRatio, between(0, 1)};
  fields.field("method", settings.method, MethodOf(), kOptional, "How second derivatives are had.")
      .field("control", settings.control, ChoiceOf<Control>{kControls}, kOptional, "How steps are kept in hand.")
      .field("pins", settings.pins, ChoiceOf<DesignSettings::Pins>{kPins}, kOptional,
             "Whether soft pins change such that pinned nodes miss their places as much as goals for positions are "
             "missed.")
      .field("iterations", settings.iterations, IntegerOf{1, 1'000'000}, kOptional,
             "At most, of each stage without a limit of its own.")
      .field("gradient_tolerance", settings.gradient_tolerance, share, kOptional,
             "Converged when no parameter promises more than this share of what the best one did at the start.")
      .field("decrease_tolerance", settings.decrease_tolerance, share, kOptional,
             "Converged when less than this share of the objective is left to be gained.")
      .field("constraint_tolerance", settings.constraint_tolerance, NumberOf{Measure::kRatio, kPositive}, kOptional,
             "How far hard goals may be missed, over their scales.")
      .field("solve_tolerance", settings.solve_tolerance, NumberOf{Measure::kRatio, kPositive}, kOptional,
             "Largest unbalanced force of an equilibrium, relative to the loads.");
}

void describe(Fields& fields, StageBrief& stage) {
  fields.field("parameters", stage.parameters, ListOf<ParameterBriefOf>{{}, 1}, kRequired, "What may change in it.")
      .field("iterations", stage.iterations, IntegerOf{1, 1'000'000}, kOptional, "At most.");
}

void describe(Fields& fields, Brief& brief) {
  fields
      .field("stages", brief.stages, ListOf<ObjectOf<StageBrief>>{{"design stage"}}, kOptional,
             "Stages with other parameters, usually fewer, that are worked on first.")
      .field("parameters", brief.parameters, ListOf<ParameterBriefOf>{{}, 1}, kRequired,
             "What may change; with stages, in the last one.")
      .field("goals", brief.goals, ListOf<GoalBriefOf>{{}, 1}, kRequired, "What is to be reached.")
      .field("wishes", brief.wishes, ObjectOf<WishesBrief>{"wishes"}, kOptional, "Wishes about the parameters.")
      .field("settings", brief.settings, ObjectOf<DesignSettings>{"design settings"}, kOptional,
             "How the design is worked on.");
}

void ParameterBriefOf::read(Reader& reader, const JsonValue& json, ParameterBrief& parameter) const {
  ParameterEntry e;
  kParameter.read(reader, json, e);
  if (reader.failed()) return;
  if (!exactly_one(reader,
                   {{"radii", e.radii.has_value()},
                    {"rest_shape", e.rest_shape.has_value()},
                    {"length", e.length.has_value()},
                    {"youngs_modulus", e.modulus.has_value()},
                    {"fabric", e.fabric.has_value()},
                    {"natural", e.natural.has_value()},
                    {"force", e.force.has_value()},
                    {"moment", e.moment.has_value()},
                    {"pin_target", e.pin_target.has_value()},
                    {"move", e.move.has_value()},
                    {"plan", e.plan.has_value()}},
                   "what may change")) {
    return;
  }
  if (e.radii) parameter.what = *e.radii;
  if (e.rest_shape) parameter.what = *e.rest_shape;
  if (e.length) parameter.what = *e.length;
  if (e.modulus) parameter.what = *e.modulus;
  if (e.fabric) parameter.what = *e.fabric;
  if (e.natural) parameter.what = *e.natural;
  if (e.force) parameter.what = e.force->load;
  if (e.moment) parameter.what = e.moment->load;
  if (e.pin_target) parameter.what = e.pin_target->load;
  if (e.move) parameter.what = e.move->load;
  if (e.plan) parameter.what = *e.plan;
  parameter.mirror = e.mirror;
  parameter.freedom = e.freedom;
}

JsonValue ParameterBriefOf::write(const ParameterBrief& parameter) const {
  ParameterEntry e;
  const auto put = [&parameter]<class T>(std::optional<T>& slot) {
    if (const T* what = std::get_if<T>(&parameter.what)) slot = *what;
  };
  put(e.radii);
  put(e.rest_shape);
  put(e.length);
  put(e.modulus);
  put(e.fabric);
  put(e.natural);
  put(e.plan);
  if (const LoadBrief* load = std::get_if<LoadBrief>(&parameter.what)) {
    if (load->kind == LoadBrief::Kind::kForce) e.force = ForceEntry{*load};
    if (load->kind == LoadBrief::Kind::kMoment) e.moment = MomentEntry{*load};
    if (load->kind == LoadBrief::Kind::kPinTarget) e.pin_target = PinEntry{*load};
    if (load->kind == LoadBrief::Kind::kMove) e.move = MoveEntry{*load};
  }
  e.mirror = parameter.mirror;
  e.freedom = parameter.freedom;
  return kParameter.write(e);
}

JsonValue ParameterBriefOf::schema(Schema& schema) const { return kParameter.schema(schema); }

void BriefOf::read(Reader& reader, const JsonValue& json, Brief& brief) const {
  ObjectOf<Brief>{"design"}.read(reader, json, brief);
}
JsonValue BriefOf::write(const Brief& brief) const { return ObjectOf<Brief>{"design"}.write(brief); }
JsonValue BriefOf::schema(Schema& schema) const { return ObjectOf<Brief>{"design"}.schema(schema); }

}  // namespace lissom
