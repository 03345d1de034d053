#include <cmath>

#include "lissom/model/entries_json.h"
#include "lissom/model/limits.h"

namespace lissom {
namespace {

/// A number whose dimension only the measured quantity knows: text with a unit, or a bare number in SI.
struct FreeNumberOf {
  Limits limits = kAny;
  void read(Reader& reader, const JsonValue& json, double& value) const {
    if (json.is(JsonValue::Kind::kNumber)) {
      const Result<double> si = to_si(json.text, Unit{});
      if (!si) return reader.fail(si.error());
      value = si.value();
    } else if (json.is(JsonValue::Kind::kString)) {
      const Result<Quantity> quantity = parse_quantity(json.text);
      if (!quantity) return reader.fail(quantity.error());
      value = quantity.value().value;
    } else {
      return reader.fail_kind("a number, or text with a unit", json);
    }
    if (limits.kind == Limits::Kind::kNotZero && value == 0) {
      reader.fail(ErrorCode::kRange, "this number must not be zero");
    }
  }
  JsonValue write(double value) const {
    return std::isfinite(value) ? JsonValue::number(number_text(value)) : JsonValue();
  }
  JsonValue schema(Schema& schema) const {
    return schema.reference("number_with_any_unit", [](Schema&) {
      return any_of({type_schema("number"), type_schema("string")});
    });
  }
};

Unit unit_named(const std::string& text) {
  Result<Unit> unit = parse_unit(text.empty() ? "1" : text);
  return unit ? std::move(unit).value() : Unit{};
}

struct UnitNameOf {
  void read(Reader& reader, const JsonValue& json, std::string& value) const {
    TextOf{false}.read(reader, json, value);
    if (reader.failed()) return;
    if (const Result<Unit> unit = parse_unit(value); !unit) reader.fail(unit.error());
  }
  JsonValue write(const std::string& value) const { return JsonValue::string(value); }
  JsonValue schema(Schema& schema) const { return TextOf{false}.schema(schema); }
};

/// A claimed number: bare in `unit`, or text with a unit of the same dimension. `unit` is taken from the text when empty.
struct ClaimOf {
  std::string* unit;

  void read(Reader& reader, const JsonValue& json, double& value) const {
    if (!json.is(JsonValue::Kind::kString)) {
      if (!json.is(JsonValue::Kind::kNumber)) return reader.fail_kind("a number, or text with a unit", json);
      const Result<double> si = to_si(json.text, unit_named(*unit));
      if (!si) return reader.fail(si.error());
      value = si.value();
      return;
    }
    const Result<Quantity> quantity = parse_quantity(json.text);
    if (!quantity) return reader.fail(quantity.error());
    if (unit->empty()) *unit = quantity.value().unit.text;
    const Dimension wanted = unit_named(*unit).dimension, got = quantity.value().unit.dimension;
    if (!compatible(wanted, got)) {
      return reader.fail(ErrorCode::kUnit, "expected a value in \"" + *unit + "\", got " + in_words(got));
    }
    value = quantity.value().value;
  }
  JsonValue write(double value) const {
    if (!std::isfinite(value)) return {};
    const Unit wanted = unit_named(*unit);
    std::string number = in_unit(value, wanted);
    if (!number.empty()) return JsonValue::number(std::move(number));
    return JsonValue::string(number_text(value) + " " + si_unit(wanted.dimension));
  }
  JsonValue schema(Schema& schema) const { return FreeNumberOf().schema(schema); }
};

/// "0.5 %" is relative, anything else absolute.
struct Tolerance {
  double relative = 0, absolute = 0;
};

struct ToleranceOf {
  std::string* unit;

  void read(Reader& reader, const JsonValue& json, Tolerance& tolerance) const {
    const bool relative = json.is(JsonValue::Kind::kString) && json.text.ends_with('%');
    double value = 0;
    if (relative) {
      NumberOf{Measure::kRatio}.read(reader, json, value);
    } else {
      ClaimOf{unit}.read(reader, json, value);
    }
    if (!reader.failed() && !(value > 0)) {
      reader.fail(ErrorCode::kRange, "a tolerance has to be positive", "write for example \"0.5 %\"");
    }
    (relative ? tolerance.relative : tolerance.absolute) = value;
  }
  JsonValue write(const Tolerance& tolerance) const {
    if (tolerance.relative == 0) return ClaimOf{unit}.write(tolerance.absolute);
    return JsonValue::string(in_unit(tolerance.relative, parse_unit("%").value()) + " %");
  }
  JsonValue schema(Schema& schema) const { return FreeNumberOf().schema(schema); }
};

struct ExpectationEntry {
  Expectation model;
  std::optional<std::string> pose;
  std::optional<double> fraction;
  std::optional<int> mode;
  Tolerance tolerance;
};

void describe(Fields& fields, ExpectationEntry& entry) {
  Expectation& e = entry.model;
  const FreeNumberOf free;
  fields.field("label", e.label, TextOf(), kOptional, "Free text, printed.")
      .field("quantity", e.quantity, TextOf{false}, kRequired,
             "What is measured; `lissom verify --quantities` lists them.")
      .field("pose", entry.pose, TextOf{false}, kOptional, "The pose to measure in.")
      .field("poses", e.poses, ListOf<TextOf>{{false}}, kOptional,
             "Several poses, one value each; all in order when absent.")
      .field("at", e.at, SelectorOf(), kOptional, "Where.")
      .field("to", e.to, SelectorOf(), kOptional, "Second place, for distances and differences.")
      .field("axis", e.axis, DirectionOf(), kOptional, "Direction in which it is measured.")
      .field("rod", e.rod, TextOf(), kOptional, "Rod, for quantities of rods.")
      .field("membrane", e.membrane, TextOf(), kOptional, "Membrane, for quantities of one membrane.")
      .field("fabric_test", e.fabric_test, TextOf(), kOptional, "Test, for quantities that are fitted to one.")
      .field("parameter", e.parameter, TextOf(), kOptional, "Parameter of the design; the only one when absent.")
      .field("fraction", entry.fraction, NumberOf{Measure::kRatio, between(0, 1)}, kOptional,
             "Place along the rod, as a fraction of its rest length.")
      .field("mode", entry.mode, IntegerOf{}, kOptional, "Number of a mode, 0 is the lowest.")
      .field("mode_kind", e.mode_kind, TextOf(), kOptional,
             "Which modes are counted: \"bending\", \"axial\" or \"torsional\".")
      .field("edges", e.edges, ListOf<IntegerOf>{{1, kMostNodes}, 1}, kOptional,
             "Numbers of edges, for orders of convergence and extrapolated values.")
      .field("combine", e.combine, TextOf{false}, kOptional,
             "What is made of several measurements: \"difference\", \"ratio\", \"order\" or \"limit\".")
      .field("divide_by", e.scale, FreeNumberOf{kNotZero}, kOptional,
             "The measured value is divided by this; bare numbers are SI.")
      .field("offset", e.offset, free, kOptional, "This is subtracted first; bare numbers are SI.")
      .field("unit", e.unit, UnitNameOf(), kOptional,
             "Unit of bare numbers in value and tolerance, and of the printed table.")
      .field("value", e.value, OneOrListOf<ClaimOf>{{&e.unit}}, kRequired,
             "The claimed value; a list has one per pose.")
      .field("tolerance", entry.tolerance, ToleranceOf{&e.unit}, kRequired,
             "Allowed deviation: \"0.5 %\" of the value, or a number like the value.")
      .field("source", e.source, TextOf(), kOptional, "Where the value comes from.");
}

constexpr ObjectOf<ExpectationEntry> kExpectation{"expectation"};

}  // namespace

void ExpectationOf::read(Reader& reader, const JsonValue& json, Expectation& expectation) const {
  ExpectationEntry entry;
  kExpectation.read(reader, json, entry);
  if (reader.failed()) return;
  if (entry.pose && !entry.model.poses.empty()) {
    return reader.fail(ErrorCode::kConflict, "both \"pose\" and \"poses\" are given", "keep one of them");
  }
  expectation = std::move(entry.model);
  if (entry.pose) expectation.poses = {*entry.pose};
  expectation.fraction = entry.fraction.value_or(-1);
  expectation.mode = entry.mode.value_or(-1);
  expectation.tolerance_relative = entry.tolerance.relative;
  expectation.tolerance_absolute = entry.tolerance.absolute;
}

JsonValue ExpectationOf::write(const Expectation& expectation) const {
  ExpectationEntry entry;
  entry.model = expectation;
  if (expectation.poses.size() == 1) {
    entry.pose = expectation.poses[0];
    entry.model.poses.clear();
  }
  if (expectation.fraction >= 0) entry.fraction = expectation.fraction;
  if (expectation.mode >= 0) entry.mode = expectation.mode;
  entry.tolerance = {expectation.tolerance_relative, expectation.tolerance_absolute};
  return kExpectation.write(entry);
}

JsonValue ExpectationOf::schema(Schema& schema) const { return kExpectation.schema(schema); }

}  // namespace lissom
