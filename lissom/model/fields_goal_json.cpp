#include <fmt/format.h>

#include "lissom/core/file_io.h"
#include "lissom/geometry/obj_lines.h"
#include "lissom/model/brief_json.h"
#include "lissom/model/document.h"

namespace lissom {
namespace {

constexpr ListOf<TextOf> kNames{{false}};

/// Text with a unit, for what has no Measure. Bare numbers are refused: nobody guesses their unit.
struct UnitTextOf {
  std::string_view unit, example;
  void read(Reader& reader, const JsonValue& json, double& value) const {
    if (json.is(JsonValue::Kind::kNumber) && json.text == "0") {
      value = 0;
      return;
    }
    if (!json.is(JsonValue::Kind::kString)) {
      return reader.fail_kind(fmt::format("text with a unit such as \"{}\"", example), json);
    }
    const Result<Quantity> quantity = parse_quantity(json.text);
    if (!quantity) return reader.fail(quantity.error());
    if (!compatible(parse_unit(unit).value().dimension, quantity.value().unit.dimension)) {
      return reader.fail(ErrorCode::kUnit, fmt::format("expected a value such as \"{}\", got {}", example,
                                                       in_words(quantity.value().unit.dimension)));
    }
    value = quantity.value().value;
  }
  JsonValue write(double value) const { return JsonValue::string(fmt::format("{} {}", number_text(value), unit)); }
  JsonValue schema(Schema&) const {
    return any_of({type_schema("string"), JsonValue::object().set("const", JsonValue::integer(0))});
  }
};

/// A kind of goal that is a number, as written: exactly one of three.
template <class T>
struct NumberEntry {
  T goal;
  std::optional<double> reach, at_most, at_least;
};

template <class T, class Codec>
void describe_wanted(Fields& fields, NumberEntry<T>& entry, const Codec& codec) {
  fields.field("reach", entry.reach, codec, kOptional, "The value that is wanted.")
      .field("at_most", entry.at_most, codec, kOptional, "Or the largest value that is good.")
      .field("at_least", entry.at_least, codec, kOptional, "Or the smallest value that is good.");
}

template <class T>
void describe(Fields& fields, NumberEntry<T>& entry) {
  T& goal = entry.goal;
  if constexpr (requires { goal.at; }) {
    fields.field("at", goal.at, SelectorOf(), kRequired, "The nodes that are held.")
        .field("axis", goal.axis, DirectionOf(), kRequired, "Direction of the force.");
    describe_wanted(fields, entry, NumberOf{Measure::kForce});
  }
  if constexpr (requires { goal.from; }) {
    fields.field("from", goal.from, ListOf<SelectorOf>{{}, 2, 2}, kRequired, "Two nodes: the first direction.")
        .field("to", goal.to, ListOf<SelectorOf>{{}, 2, 2}, kRequired, "Two nodes: the second direction.")
        .field("axis", goal.axis, DirectionOf(), kOptional, "About which the angle is signed.");
    describe_wanted(fields, entry, NumberOf{Measure::kAngle});
  }
  if constexpr (requires { goal.rods; }) {
    fields.field("rods", goal.rods, kNames, kOptional, "Which rods; all when absent.");
  }
  if constexpr (requires { goal.membranes; }) {
    fields.field("membranes", goal.membranes, kNames, kOptional, "Which membranes; all when absent.");
  }
  if constexpr (std::is_same_v<T, AreaGoal>) describe_wanted(fields, entry, UnitTextOf{"m^2", "12 cm^2"});
  if constexpr (std::is_same_v<T, VolumeGoal>) describe_wanted(fields, entry, UnitTextOf{"m^3", "12 cm^3"});
  if constexpr (std::is_same_v<T, EnergyGoal>) describe_wanted(fields, entry, UnitTextOf{"J", "5 mJ"});
  if constexpr (std::is_same_v<T, MassGoal>) describe_wanted(fields, entry, NumberOf{Measure::kMass, kPositive});
  if constexpr (std::is_same_v<T, StretchGoal> || std::is_same_v<T, StrainGoal>) {
    describe_wanted(fields, entry, NumberOf{Measure::kRatio, kNotNegative});
  }
  if constexpr (std::is_same_v<T, StabilityGoal>) describe_wanted(fields, entry, UnitTextOf{"N/m", "0.5 N/m"});
}

/// A goal T with a member `wanted`.
template <class T>
struct NumberGoalOf {
  std::string_view title;

  void read(Reader& reader, const JsonValue& json, T& goal) const {
    NumberEntry<T> entry;
    object().read(reader, json, entry);
    if (reader.failed() || !exactly_one(reader,
                                        {{"reach", entry.reach.has_value()},
                                         {"at_most", entry.at_most.has_value()},
                                         {"at_least", entry.at_least.has_value()}},
                                        "what is wanted")) {
      return;
    }
    goal = std::move(entry.goal);
    if (entry.reach) goal.wanted = {GoalValue::Kind::kReach, *entry.reach};
    if (entry.at_most) goal.wanted = {GoalValue::Kind::kAtMost, *entry.at_most};
    if (entry.at_least) goal.wanted = {GoalValue::Kind::kAtLeast, *entry.at_least};
  }
  JsonValue write(const T& goal) const {
    NumberEntry<T> entry{goal, {}, {}, {}};
    const double value = goal.wanted.value;
    if (goal.wanted.kind == GoalValue::Kind::kReach) entry.reach = value;
    if (goal.wanted.kind == GoalValue::Kind::kAtMost) entry.at_most = value;
    if (goal.wanted.kind == GoalValue::Kind::kAtLeast) entry.at_least = value;
    return object().write(entry);
  }
  JsonValue schema(Schema& schema) const { return object().schema(schema); }

 private:
  ObjectOf<NumberEntry<T>> object() const { return {title}; }
};

struct PositionsEntry {
  Selector at;
  std::vector<Vec3> targets;
  std::optional<std::string> file, unit;
  std::vector<double> weights;
};

void describe(Fields& fields, PositionsEntry& entry) {
  fields.field("at", entry.at, SelectorOf(), kOptional, "The nodes; all when absent.")
      .field("targets", entry.targets, ListOf<VectorOf>{{Measure::kLength}}, kOptional,
             "A place for each of these nodes, in the order of their numbers, or for every node of the structure.")
      .field("file", entry.file, TextOf{false}, kOptional, "Or an OBJ file whose points (\"v\") are these places.")
      .field("unit", entry.unit, TextOf{false}, kOptional, "Unit of the coordinates in the file.")
      .field("weights", entry.weights, ListOf<NumberOf>{{Measure::kRatio, kNotNegative}}, kOptional,
             "One for each target; equal when absent.");
}

void read_file_targets(Reader& reader, PositionsEntry& entry) {
  const Reader::Step step(reader, "file");
  const Result<std::string> text = read_file_below(reader.folder, *entry.file, kLargestDocument);
  if (!text) return reader.fail(text.error());
  const Result<ObjLines> lines = read_obj_lines(text.value(), *entry.file);
  if (!lines) return reader.fail(lines.error());
  const Result<Unit> unit = parse_unit(*entry.unit);
  if (!unit) return reader.fail(unit.error());
  if (!compatible(dimension(Measure::kLength), unit.value().dimension)) {
    return reader.fail(wrong_dimension(Measure::kLength, unit.value().dimension));
  }
  for (const Vec3& point : lines.value().points) {
    Vec3 target;
    for (int i = 0; i < 3; ++i) {
      const Result<double> si = to_si(number_text(point[i]), unit.value());
      if (!si) return reader.fail(si.error());
      target[i] = si.value();
    }
    entry.targets.push_back(target);
  }
}

/// Targets of files are written one by one: the document of a design then stands for itself.
struct PositionsOf {
  static ObjectOf<PositionsEntry> object() { return {"positions goal"}; }
  void read(Reader& reader, const JsonValue& json, PositionsGoal& goal) const {
    PositionsEntry entry;
    object().read(reader, json, entry);
    if (reader.failed() || !exactly_one(reader, {{"targets", !entry.targets.empty()}, {"file", entry.file.has_value()}},
                                        "the place of the nodes")) {
      return;
    }
    if (entry.file && !entry.unit) {
      return reader.fail(ErrorCode::kUnit, "the unit of the coordinates in the file is missing",
                         "write \"unit\": \"mm\", for example");
    }
    if (entry.file) read_file_targets(reader, entry);
    if (reader.failed()) return;
    goal = {std::move(entry.at), std::move(entry.targets), std::move(entry.weights)};
  }
  JsonValue write(const PositionsGoal& goal) const {
    return object().write(PositionsEntry{goal.at, goal.targets, {}, {}, goal.weights});
  }
  JsonValue schema(Schema& schema) const { return object().schema(schema); }
};

struct GoalEntry {
  std::optional<PositionsGoal> positions;
  std::optional<PlaceGoal> place;
  std::optional<AngleGoal> angle;
  std::optional<ReactionGoal> reaction;
  std::optional<AreaGoal> area;
  std::optional<VolumeGoal> volume;
  std::optional<MassGoal> mass;
  std::optional<EnergyGoal> energy;
  std::optional<StretchGoal> stretch;
  std::optional<StrainGoal> strain;
  std::optional<StabilityGoal> stability;
  std::string pose;
  bool hard = false;
  double weight = 1;
};

void describe(Fields& fields, GoalEntry& g) {
  fields.field("positions", g.positions, PositionsOf(), kOptional, "Places of nodes.")
      .field("place", g.place, ObjectOf<PlaceGoal>{"place goal"}, kOptional, "Mean place of a set of nodes.")
      .field("angle", g.angle, NumberGoalOf<AngleGoal>{"angle goal"}, kOptional, "Angle between two directions.")
      .field("reaction", g.reaction, NumberGoalOf<ReactionGoal>{"reaction goal"}, kOptional, "What supports carry.")
      .field("area", g.area, NumberGoalOf<AreaGoal>{"area goal"}, kOptional, "Area of stretched membranes.")
      .field("enclosed_volume", g.volume, NumberGoalOf<VolumeGoal>{"volume goal"}, kOptional,
             "Volume between membranes and their rims.")
      .field("mass", g.mass, NumberGoalOf<MassGoal>{"mass goal"}, kOptional, "Mass.")
      .field("strain_energy", g.energy, NumberGoalOf<EnergyGoal>{"energy goal"}, kOptional, "Elastic energy.")
      .field("smallest_stretch", g.stretch, NumberGoalOf<StretchGoal>{"stretch goal"}, kOptional,
             "Smaller principal stretch of every triangle.")
      .field("rod_strain", g.strain, NumberGoalOf<StrainGoal>{"strain goal"}, kOptional,
             "Largest strain of the sections of rods.")
      .field("stability_margin", g.stability, NumberGoalOf<StabilityGoal>{"stability goal"}, kOptional,
             "Stiffness of the softest mode.")
      .field("pose", g.pose, TextOf{false}, kOptional, "In which pose; the only one when absent.")
      .field("hard", g.hard, FlagOf(), kOptional, "Whether it is a constraint.")
      .field("weight", g.weight, NumberOf{Measure::kRatio, kPositive}, kOptional, "Against the other goals.");
}

constexpr ObjectOf<GoalEntry> kGoal{"goal"};

/// Calls what(key, slot) for every kind of goal.
template <class What>
void for_kinds(GoalEntry& g, const What& what) {
  what("positions", g.positions);
  what("place", g.place);
  what("angle", g.angle);
  what("reaction", g.reaction);
  what("area", g.area);
  what("enclosed_volume", g.volume);
  what("mass", g.mass);
  what("strain_energy", g.energy);
  what("smallest_stretch", g.stretch);
  what("rod_strain", g.strain);
  what("stability_margin", g.stability);
}

}  // namespace

// Found by argument-dependent lookup, hence in the namespace of the struct.
void describe(Fields& fields, PlaceGoal& goal) {
  fields.field("at", goal.at, SelectorOf(), kRequired, "The nodes.")
      .field("reach", goal.target, VectorOf{Measure::kLength}, kRequired, "Where their mean should be.");
}

void GoalBriefOf::read(Reader& reader, const JsonValue& json, GoalBrief& goal) const {
  GoalEntry entry;
  kGoal.read(reader, json, entry);
  if (reader.failed()) return;
  std::vector<std::string> given;
  for_kinds(entry, [&](const char* key, auto& slot) {
    if (!slot) return;
    given.emplace_back(key);
    goal.what = std::move(*slot);
  });
  if (given.empty()) {
    return reader.fail(ErrorCode::kType, "what is to be reached is missing",
                       "give for example \"positions\", \"reaction\" or \"mass\"");
  }
  if (given.size() > 1) {
    return reader.fail(ErrorCode::kConflict, fmt::format("\"{}\" and \"{}\" are both given", given[0], given[1]),
                       "make them two goals");
  }
  goal.pose = entry.pose;
  goal.strength = entry.hard ? GoalStrength::kHard : GoalStrength::kSoft;
  goal.weight = entry.weight;
}

JsonValue GoalBriefOf::write(const GoalBrief& goal) const {
  GoalEntry entry;
  for_kinds(entry, [&]<class T>(const char*, std::optional<T>& slot) {
    if (const T* what = std::get_if<T>(&goal.what)) slot = *what;
  });
  entry.pose = goal.pose;
  entry.hard = goal.strength == GoalStrength::kHard;
  entry.weight = goal.weight;
  return kGoal.write(entry);
}

JsonValue GoalBriefOf::schema(Schema& schema) const { return kGoal.schema(schema); }

}  // namespace lissom
