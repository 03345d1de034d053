#include "lissom/model/entries_json.h"

namespace lissom {
namespace {

/// "start", "end", or a fraction of the rod's length.
struct PlaceOf {
  void read(Reader& reader, const JsonValue& json, double& fraction) const {
    if (json.is(JsonValue::Kind::kString) && (json.text == "start" || json.text == "end")) {
      fraction = json.text == "end" ? 1 : 0;
      return;
    }
    if (json.is(JsonValue::Kind::kString) && json.text.find_first_of("0123456789") == std::string::npos) {
      return reader.fail(ErrorCode::kUnknown, "\"" + json.text + "\" is not a place on a rod",
                         "write \"start\", \"end\", or a fraction of its length such as 0.5 or \"50 %\"");
    }
    kFraction.read(reader, json, fraction);
  }
  JsonValue write(double fraction) const {
    if (fraction == 0) return JsonValue::string("start");
    return fraction == 1 ? JsonValue::string("end") : kFraction.write(fraction);
  }
  JsonValue schema(Schema& schema) const {
    JsonValue words = JsonValue::array({JsonValue::string("start"), JsonValue::string("end")});
    return any_of({JsonValue::object().set("enum", std::move(words)), kFraction.schema(schema)});
  }

 private:
  static constexpr NumberOf kFraction{Measure::kRatio, between(0, 1)};
};

constexpr std::pair<std::string_view, Selector::Rim> kRims[] = {
    {"all", Selector::Rim::kAll}, {"outer", Selector::Rim::kOuter}, {"inner", Selector::Rim::kInner}};

/// The object form of a selector.
struct SelectorEntry {
  std::optional<std::string> rod, plan_point;
  std::optional<double> at, within;
  std::optional<Vec3> point;
  std::optional<std::vector<Vec3>> box;
  std::optional<std::string> membrane;
  std::optional<Selector::Rim> rim;
};

void describe(Fields& fields, SelectorEntry& entry) {
  const VectorOf point{Measure::kLength};
  fields.field("rod", entry.rod, TextOf{false}, kOptional, "All nodes of this rod, or the one at \"at\".")
      .field("at", entry.at, PlaceOf(), kOptional, "Place on the rod, as a fraction of its rest length.")
      .field("point", entry.point, point, kOptional, "The node nearest to this point.")
      .field("within", entry.within, NumberOf{Measure::kLength, kPositive}, kOptional,
             "How far it may be away; half a mean edge when absent.")
      .field("plan_point", entry.plan_point, TextOf{false}, kOptional, "The node at this point of the plan.")
      .field("box", entry.box, ListOf<VectorOf>{point, 2, 2}, kOptional,
             "All nodes between the low and the high corner.")
      .field("membrane", entry.membrane, TextOf{false}, kOptional, "All vertices of this membrane.")
      .field("rim", entry.rim, ChoiceOf<Selector::Rim>{kRims}, kOptional,
             "Only those at its edge: at all of it, at the outer line, or at the edges of holes.");
}

constexpr ObjectOf<SelectorEntry> kSelector{"selector"};

void selector_of(Reader& reader, const SelectorEntry& entry, Selector& selector) {
  const int kinds = entry.rod.has_value() + entry.point.has_value() + entry.box.has_value() +
                    entry.membrane.has_value() + entry.plan_point.has_value();
  if (kinds != 1) {
    return reader.fail(
        kinds == 0 ? ErrorCode::kType : ErrorCode::kConflict,
        kinds == 0 ? "the selector names nothing" : "the selector names more than one thing",
        "give one of \"rod\", \"membrane\", \"point\", \"plan_point\" and \"box\"; a list of selectors is "
        "their union");
  }
  if ((entry.at && !entry.rod) || (entry.within && !entry.point)) {
    const Reader::Step step(reader, entry.at && !entry.rod ? "at" : "within");
    return reader.fail(ErrorCode::kConflict,
                       entry.at && !entry.rod ? "\"at\" is a place on a rod, but no rod is named"
                                              : "\"within\" belongs to a \"point\", which is missing",
                       "add it, or remove this key");
  }
  if (entry.rim && !entry.membrane) {
    const Reader::Step step(reader, "rim");
    return reader.fail(ErrorCode::kConflict, "\"rim\" belongs to a \"membrane\", which is missing",
                       "add it, or remove this key");
  }
  if (entry.membrane) {
    selector.kind = entry.rim ? Selector::Kind::kRim : Selector::Kind::kMembrane;
    selector.name = *entry.membrane;
    selector.rim = entry.rim.value_or(Selector::Rim::kAll);
  } else if (entry.rod) {
    selector.kind = Selector::Kind::kRod;
    selector.name = *entry.rod;
    selector.fraction = entry.at.value_or(-1);
  } else if (entry.point) {
    selector.kind = Selector::Kind::kPoint;
    selector.point = *entry.point;
    selector.tolerance = entry.within.value_or(0);
  } else if (entry.plan_point) {
    selector.kind = Selector::Kind::kPlanPoint;
    selector.name = *entry.plan_point;
  } else {
    selector.kind = Selector::Kind::kBox;
    selector.low = (*entry.box)[0];
    selector.high = (*entry.box)[1];
  }
}

}  // namespace

void SelectorOf::read(Reader& reader, const JsonValue& json, Selector& selector) const {
  selector = {};
  if (json.is(JsonValue::Kind::kString)) {
    if (json.text.empty()) return reader.fail(ErrorCode::kUnknown, "the name of the set is empty");
    selector.kind = Selector::Kind::kSet;
    for (const auto& [word, kind] : selector_words()) {
      if (word == json.text) selector.kind = kind;
    }
    if (selector.kind == Selector::Kind::kSet) selector.name = json.text;
  } else if (json.is(JsonValue::Kind::kArray)) {
    selector.kind = Selector::Kind::kUnion;
    ListOf<SelectorOf>{{}, 1}.read(reader, json, selector.parts);
  } else if (json.is(JsonValue::Kind::kObject)) {
    SelectorEntry entry;
    kSelector.read(reader, json, entry);
    if (!reader.failed()) selector_of(reader, entry, selector);
  } else {
    reader.fail_kind("a selector such as \"all\", the name of a set, or {\"rod\": \"beam\", \"at\": \"end\"}", json);
  }
}

JsonValue SelectorOf::write(const Selector& selector) const {
  for (const auto& [word, kind] : selector_words()) {
    if (kind == selector.kind) return JsonValue::string(word);
  }
  SelectorEntry entry;
  switch (selector.kind) {
    case Selector::Kind::kSet:
      return JsonValue::string(selector.name);
    case Selector::Kind::kUnion:
      return ListOf<SelectorOf>{{}, 1}.write(selector.parts);
    case Selector::Kind::kRod:
      entry.rod = selector.name;
      if (selector.fraction >= 0) entry.at = selector.fraction;
      break;
    case Selector::Kind::kPoint:
      entry.point = selector.point;
      if (selector.tolerance > 0) entry.within = selector.tolerance;
      break;
    case Selector::Kind::kRim:
      entry.rim = selector.rim;
      [[fallthrough]];
    case Selector::Kind::kMembrane:
      entry.membrane = selector.name;
      break;
    case Selector::Kind::kPlanPoint:
      entry.plan_point = selector.name;
      break;
    default:
      entry.box = {selector.low, selector.high};
  }
  return kSelector.write(entry);
}

JsonValue SelectorOf::schema(Schema& schema) const {
  return schema.reference("nodes", [](Schema& inner) {
    JsonValue name = TextOf{false}.schema(inner);
    name.set("description", JsonValue::string("\"all\", \"joints\", \"boundary\", or the name of a set."));
    return any_of({std::move(name), kSelector.schema(inner), ListOf<SelectorOf>{{}, 1}.schema(inner)});
  });
}

}  // namespace lissom
