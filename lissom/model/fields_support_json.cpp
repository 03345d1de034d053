#include "lissom/model/entries_json.h"

namespace lissom {
namespace {

constexpr std::pair<std::string_view, SupportKind> kKinds[] = {{"pin", SupportKind::kPin},
                                                               {"clamp", SupportKind::kClamp},
                                                               {"clamp_edge", SupportKind::kClampEdge},
                                                               {"symmetry", SupportKind::kSymmetry}};
constexpr std::string_view kDirectionWords[] = {"x", "y", "z"};
constexpr std::string_view kRotationWords[] = {"rx", "ry", "rz"};

/// A direction or axis that is none of x, y, z.
struct HeldEntry {
  std::optional<Vec3> along, about;
};

void describe(Fields& fields, HeldEntry& entry) {
  fields.field("along", entry.along, DirectionOf(), kOptional, "Direction along which the displacement is held.")
      .field("about", entry.about, DirectionOf(), kOptional, "Axis about which the rotation is held.");
}

constexpr ObjectOf<HeldEntry> kHeld{"held direction"};

/// "clamp", ... or a list of what is held.
struct Hold {
  SupportKind kind = SupportKind::kPin;
  std::vector<Vec3> directions, rotations;
  bool roll = false;
};

void read_held_word(Reader& reader, const std::string& word, Hold& hold) {
  for (int i = 0; i < 3; ++i) {
    if (word == kDirectionWords[i]) return hold.directions.push_back(Vec3::Unit(i));
    if (word == kRotationWords[i]) return hold.rotations.push_back(Vec3::Unit(i));
  }
  if (word == "roll") {
    hold.roll = true;
    return;
  }
  reader.fail(
      ErrorCode::kUnknown, "\"" + word + "\" cannot be held",
      "known: \"x\", \"y\", \"z\", \"rx\", \"ry\", \"rz\", \"roll\", {\"along\": [...]} and {\"about\": [...]}");
}

void read_held(Reader& reader, const JsonValue& json, Hold& hold) {
  if (json.is(JsonValue::Kind::kString)) return read_held_word(reader, json.text, hold);
  HeldEntry entry;
  kHeld.read(reader, json, entry);
  if (reader.failed()) return;
  if (entry.along.has_value() == entry.about.has_value()) {
    return reader.fail(ErrorCode::kType, "a held direction says either \"along\" or \"about\"");
  }
  entry.along ? hold.directions.push_back(*entry.along) : hold.rotations.push_back(*entry.about);
}

JsonValue write_held(const Vec3& direction, const std::string_view (&words)[3], bool along) {
  for (int i = 0; i < 3; ++i) {
    if (direction == Vec3::Unit(i)) return JsonValue::string(words[i]);
  }
  HeldEntry entry;
  (along ? entry.along : entry.about) = direction;
  return kHeld.write(entry);
}

struct HoldOf {
  void read(Reader& reader, const JsonValue& json, Hold& hold) const {
    hold = {};
    if (json.is(JsonValue::Kind::kString)) return ChoiceOf<SupportKind>{kKinds}.read(reader, json, hold.kind);
    if (!json.is(JsonValue::Kind::kArray)) {
      return reader.fail_kind("\"pin\", \"clamp\", \"clamp_edge\", \"symmetry\" or a list such as [\"x\", \"z\"]",
                              json);
    }
    if (json.items.empty())
      return reader.fail(ErrorCode::kType, "this support holds nothing", "remove it, or list what is held");
    hold.kind = SupportKind::kFree;
    for (std::size_t i = 0; i < json.items.size() && !reader.failed(); ++i) {
      const Reader::Step step(reader, i);
      read_held(reader, json.items[i], hold);
    }
  }
  JsonValue write(const Hold& hold) const {
    if (hold.kind != SupportKind::kFree) return ChoiceOf<SupportKind>{kKinds}.write(hold.kind);
    JsonValue json = JsonValue::array();
    for (const Vec3& direction : hold.directions) json.items.push_back(write_held(direction, kDirectionWords, true));
    for (const Vec3& axis : hold.rotations) json.items.push_back(write_held(axis, kRotationWords, false));
    if (hold.roll) json.items.push_back(JsonValue::string("roll"));
    return json;
  }
  JsonValue schema(Schema& schema) const {
    JsonValue words = JsonValue::array();
    for (const std::string_view word : kDirectionWords) words.items.push_back(JsonValue::string(word));
    for (const std::string_view word : kRotationWords) words.items.push_back(JsonValue::string(word));
    words.items.push_back(JsonValue::string("roll"));
    JsonValue list = type_schema("array").set("minItems", JsonValue::integer(1));
    list.set("items", any_of({JsonValue::object().set("enum", std::move(words)), kHeld.schema(schema)}));
    return any_of({ChoiceOf<SupportKind>{kKinds}.schema(schema), std::move(list)});
  }
};

struct TurnEntry {
  Vec3 axis = Vec3::UnitZ();
  double angle = 0;
};

void describe(Fields& fields, TurnEntry& turn) {
  fields.field("axis", turn.axis, DirectionOf(), kRequired, "Axis of the turn, right-handed.")
      .field("angle", turn.angle, NumberOf{Measure::kAngle}, kRequired, "Angle at load factor 1; any number of turns.");
}

/// [[a, b, c], ...], three rows.
struct MatrixOf {
  void read(Reader& reader, const JsonValue& json, Mat3& value) const {
    std::vector<Vec3> rows;
    ListOf<VectorOf>{{Measure::kRatio}, 3, 3}.read(reader, json, rows);
    for (int i = 0; i < 3 && !reader.failed(); ++i) value.row(i) = rows[i];
  }
  JsonValue write(const Mat3& value) const {
    const std::vector<Vec3> rows{value.row(0), value.row(1), value.row(2)};
    return ListOf<VectorOf>{{Measure::kRatio}, 3, 3}.write(rows);
  }
  JsonValue schema(Schema& schema) const { return ListOf<VectorOf>{{Measure::kRatio}, 3, 3}.schema(schema); }
};

struct SupportEntry {
  Selector at;
  Hold hold;
  std::optional<Vec3> normal;
  Vec3 move = Vec3::Zero();
  std::optional<double> move_inwards;
  double shrink = 0;
  Mat3 deform = Mat3::Identity();
  std::optional<TurnEntry> turn;
};

void describe(Fields& fields, SupportEntry& support) {
  fields.field("at", support.at, SelectorOf(), kRequired, "The nodes that are held.")
      .field("hold", support.hold, HoldOf(), kRequired,
             "How: \"pin\" (position), \"clamp\" (position and frame), \"clamp_edge\" (the end edge), \"symmetry\" "
             "(mirror "
             "plane), or a list of directions (\"x\"), rotations (\"rx\") and \"roll\".")
      .field("normal", support.normal, DirectionOf(), kOptional, "Normal of the mirror plane.")
      .field("move", support.move, VectorOf{Measure::kLength}, kOptional, "Displacement at load factor 1.")
      .field("move_inwards", support.move_inwards, NumberOf{Measure::kLength}, kOptional,
             "Displacement towards the centroid of the held nodes at load factor 1, in addition to move.")
      .field(
          "shrink", support.shrink, NumberOf{Measure::kRatio}, kOptional,
          "Share by which the held nodes come closer to their centroid at load factor 1, such as 2 %; in addition to "
          "move.")
      .field("deform", support.deform, MatrixOf(), kOptional,
             "Three rows of a linear map: drawn places X are taken to F X at load factor 1, in addition to move.")
      .field("turn", support.turn, ObjectOf<TurnEntry>{"turn"}, kOptional, "Turn of the held frames.");
}

constexpr ObjectOf<SupportEntry> kSupport{"support"};

}  // namespace

void SupportOf::read(Reader& reader, const JsonValue& json, Support& support) const {
  SupportEntry entry;
  kSupport.read(reader, json, entry);
  if (reader.failed()) return;
  const bool symmetry = entry.hold.kind == SupportKind::kSymmetry;
  if (symmetry && !entry.normal) {
    return reader.fail(ErrorCode::kType, "the normal of the mirror plane is missing",
                       "add for example \"normal\": [1, 0, 0]");
  }
  if (!symmetry && entry.normal) {
    const Reader::Step step(reader, "normal");
    return reader.fail(ErrorCode::kConflict, "only \"hold\": \"symmetry\" has a normal", "remove it");
  }
  support = {};
  support.at = entry.at;
  support.kind = entry.hold.kind;
  support.directions = entry.hold.directions;
  support.rotations = entry.hold.rotations;
  support.roll = entry.hold.roll;
  if (entry.normal) support.normal = *entry.normal;
  support.move = entry.move;
  support.move_inwards = entry.move_inwards;
  support.shrink = entry.shrink;
  support.deform = entry.deform;
  if (entry.turn) {
    support.turn_axis = entry.turn->axis;
    support.turn_angle = entry.turn->angle;
  }
}

JsonValue SupportOf::write(const Support& support) const {
  SupportEntry entry;
  entry.at = support.at;
  entry.hold = {support.kind, support.directions, support.rotations, support.roll};
  if (support.kind == SupportKind::kSymmetry) entry.normal = support.normal;
  entry.move = support.move;
  entry.move_inwards = support.move_inwards;
  entry.shrink = support.shrink;
  entry.deform = support.deform;
  if (support.turn_angle != 0 || support.turn_axis != Vec3::UnitZ()) {
    entry.turn = TurnEntry{support.turn_axis, support.turn_angle};
  }
  return kSupport.write(entry);
}

JsonValue SupportOf::schema(Schema& schema) const { return kSupport.schema(schema); }

}  // namespace lissom
