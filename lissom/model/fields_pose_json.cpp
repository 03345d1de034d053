#include "lissom/model/entries_json.h"

namespace lissom {
namespace {

constexpr std::pair<std::string_view, Seed::Shape> kSeedShapes[] = {{"bump", Seed::Shape::kBump},
                                                                    {"saddle", Seed::Shape::kSaddle}};
constexpr std::pair<std::string_view, Scaling> kScalings[] = {{"proportional", Scaling::kProportional},
                                                              {"constant", Scaling::kConstant}};
constexpr ChoiceOf<Scaling> kScaling{kScalings};
constexpr std::string_view kScalingText = "Whether it grows with the load factor or acts in full throughout.";

constexpr std::pair<std::string_view, LoadPath::Follow> kFollows[] = {{"load", LoadPath::Follow::kLoad},
                                                                      {"arc_length", LoadPath::Follow::kArcLength}};

constexpr std::pair<std::string_view, RigidMotion> kRigidMotions[] = {{"remove_neutral", RigidMotion::kRemoveNeutral},
                                                                      {"remove", RigidMotion::kRemove}};

/// true, "9.81 m/s^2" (downwards, along -z), [x, y, z], or an object.
struct GravityOf {
  void read(Reader& reader, const JsonValue& json, Gravity& gravity) const {
    gravity = {};
    const NumberOf magnitude{Measure::kAcceleration, kNotNegative};
    switch (json.kind) {
      case JsonValue::Kind::kBool:
        if (!json.flag)
          reader.fail(ErrorCode::kType, "gravity is either true or given", "remove the key where there is none");
        return;
      case JsonValue::Kind::kArray:
        return VectorOf{Measure::kAcceleration}.read(reader, json, gravity.acceleration);
      case JsonValue::Kind::kObject:
        return object().read(reader, json, gravity);
      default: {
        double g = 0;
        magnitude.read(reader, json, g);
        gravity.acceleration = Vec3(0, 0, -g);
      }
    }
  }
  JsonValue write(const Gravity& gravity) const {
    if (gravity.scaling == Scaling::kConstant) return object().write(gravity);
    if (gravity.acceleration == Gravity().acceleration) return JsonValue::boolean(true);
    return VectorOf{Measure::kAcceleration}.write(gravity.acceleration);
  }
  JsonValue schema(Schema& schema) const {
    return any_of({JsonValue::object().set("const", JsonValue::boolean(true)),
                   NumberOf{Measure::kAcceleration, kNotNegative}.schema(schema),
                   VectorOf{Measure::kAcceleration}.schema(schema), object().schema(schema)});
  }

 private:
  static ObjectOf<Gravity> object() { return {"gravity"}; }
};

}  // namespace

// Found by argument-dependent lookup, hence in the namespace of the structs.
void describe(Fields& fields, Gravity& gravity) {
  fields
      .field("acceleration", gravity.acceleration, VectorOf{Measure::kAcceleration}, kOptional,
             "Acceleration; 9.81 m/s^2 along -z when absent.")
      .field("scaling", gravity.scaling, kScaling, kOptional, kScalingText);
}

void describe(Fields& fields, SoftPin& pin) {
  fields.field("at", pin.at, SelectorOf(), kRequired, "The nodes that are pulled.")
      .field("stiffness", pin.stiffness, NumberOf{Measure::kForcePerLength, kPositive}, kRequired,
             "Spring stiffness per node.")
      .field("target", pin.target, VectorOf{Measure::kLength}, kOptional,
             "Where to; where the node is drawn when absent.");
}

void describe(Fields& fields, PointForce& force) {
  fields.field("at", force.at, SelectorOf(), kRequired, "The loaded nodes.")
      .field("force", force.force, VectorOf{Measure::kForce}, kRequired,
             "Dead force on each node, or on all when shared.")
      .field("shared", force.shared, FlagOf(), kOptional, "Whether the force is split equally among the nodes.")
      .field("scaling", force.scaling, kScaling, kOptional, kScalingText);
}

void describe(Fields& fields, PointMoment& moment) {
  fields.field("at", moment.at, SelectorOf(), kRequired, "The loaded nodes.")
      .field("moment", moment.moment, VectorOf{Measure::kMoment}, kRequired,
             "Moment on each node, axes fixed in space.")
      .field("scaling", moment.scaling, kScaling, kOptional, kScalingText);
}

void describe(Fields& fields, LineLoad& load) {
  fields.field("rods", load.rods, ListOf<TextOf>{{false}}, kOptional, "Names of the loaded rods; all when absent.")
      .field("force_per_length", load.force_per_length, VectorOf{Measure::kForcePerLength}, kRequired,
             "Dead force per rest length.")
      .field("scaling", load.scaling, kScaling, kOptional, kScalingText);
}

void describe(Fields& fields, EdgeLoad& load) {
  fields.field("at", load.at, SelectorOf(), kRequired, "Vertices; loaded are the rim edges between them.")
      .field("force_per_length", load.force_per_length, VectorOf{Measure::kForcePerLength}, kRequired,
             "Dead force per rest length.")
      .field("scaling", load.scaling, kScaling, kOptional, kScalingText);
}

void describe(Fields& fields, LoadPath& path) {
  fields.field("from", path.from, NumberOf{}, kOptional, "First load factor.")
      .field("to", path.to, NumberOf{}, kOptional, "Last load factor.")
      .field("steps", path.steps, IntegerOf{1, 1'000'000}, kOptional, "Number of recorded states.")
      .field("follow", path.follow, ChoiceOf<LoadPath::Follow>{kFollows}, kOptional,
             "What is stepped: the load factor, or the length of the path (passes folds).")
      .field("stop_at_critical", path.stop_at_critical, FlagOf(), kOptional,
             "Whether the path ends at the first critical point.")
      .field("switch_branch", path.switch_branch, FlagOf(), kOptional,
             "Whether the path continues on the other branch at the first bifurcation.");
}

void describe(Fields& fields, Seed& seed) {
  fields
      .field("shape", seed.shape, ChoiceOf<Seed::Shape>{kSeedShapes}, kOptional,
             "A bump over each rod or over a network, or a smooth saddle over the plan.")
      .field("direction", seed.direction, DirectionOf(), kOptional, "Direction of the displacement.")
      .field("amplitude", seed.amplitude, NumberOf{Measure::kLength}, kRequired,
             "Largest height; 0 starts from the drawn shape itself.");
}

void describe(Fields& fields, FormFinding& form) {
  fields.field("rounds", form.rounds, IntegerOf{2, 1'000'000}, kOptional, "Most times that the rest shape is renewed.")
      .field("tolerance", form.tolerance, NumberOf{Measure::kRatio, kPositive}, kOptional,
             "Largest movement across the membrane in a round that counts as none, over the size of the structure.");
}

void describe(Fields& fields, Pose& pose) {
  fields.field("name", pose.name, TextOf{false}, kRequired, "Name of the pose.")
      .field(
          "rigid_motion", pose.rigid_motion, ChoiceOf<RigidMotion>{kRigidMotions}, kOptional,
          "Which rigid motions are taken out that no support prevents: those that the loads do not notice, or all on "
          "which they do no work.")
      .field("supports", pose.supports, ListOf<SupportOf>{}, kOptional, "What is held, moved and turned.")
      .field("soft_pins", pose.soft_pins, ListOf<ObjectOf<SoftPin>>{{"soft pin"}}, kOptional,
             "Springs to points in space.")
      .field("forces", pose.forces, ListOf<ObjectOf<PointForce>>{{"force"}}, kOptional, "Point forces.")
      .field("moments", pose.moments, ListOf<ObjectOf<PointMoment>>{{"moment"}}, kOptional, "Point moments.")
      .field("line_loads", pose.line_loads, ListOf<ObjectOf<LineLoad>>{{"line load"}}, kOptional,
             "Loads spread along rods.")
      .field("edge_loads", pose.edge_loads, ListOf<ObjectOf<EdgeLoad>>{{"edge load"}}, kOptional,
             "Loads spread along the rims of membranes.")
      .field("gravity", pose.gravity, GravityOf(), kOptional,
             "true (9.81 m/s^2 along -z), a magnitude, a vector, or an object; absent: none.")
      .field("pre_stretch", pose.stretch_scaling, kScaling, kOptional,
             "Whether the pre-stretch of membranes grows from 1 with the load factor.")
      .field("path", pose.path, ObjectOf<LoadPath>{"path"}, kOptional, "Load factors to visit.")
      .field("seed", pose.seed, ObjectOf<Seed>{"seed"}, kOptional,
             "A shape to start from. When absent, flat rods on pre-stretched membranes start from a saddle of 5 % of "
             "their "
             "extent, everything else as drawn.")
      .field("form_finding", pose.form_finding, ObjectOf<FormFinding>{"form finding"}, kOptional,
             "Whether membranes take the shape found as their rest shape, again and again until nothing moves.")
      .field("frozen", pose.frozen, FlagOf(), kOptional, "Whether everything stays where it is drawn.");
}

void PoseOf::read(Reader& reader, const JsonValue& json, Pose& pose) const {
  ObjectOf<Pose>{"pose"}.read(reader, json, pose);
}
JsonValue PoseOf::write(const Pose& pose) const { return ObjectOf<Pose>{"pose"}.write(pose); }
JsonValue PoseOf::schema(Schema& schema) const { return ObjectOf<Pose>{"pose"}.schema(schema); }

}  // namespace lissom
