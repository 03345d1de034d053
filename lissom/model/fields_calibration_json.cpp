#include "lissom/model/brief_json.h"

namespace lissom {
namespace {

using Prescribed = ForceLengthBrief::Prescribed;
constexpr std::pair<std::string_view, Prescribed> kPrescribed[] = {{"force", Prescribed::kForce},
                                                                   {"length", Prescribed::kLength}};

/// What is measured of a pair may be a force or a length.
struct Sigma {
  double value = 0;
  Measure measure = Measure::kLength;
};

struct SigmaOf {
  void read(Reader& reader, const JsonValue& json, Sigma& sigma) const {
    if (!json.is(JsonValue::Kind::kString)) return reader.fail_kind("text with a unit such as \"0.1 mm\"", json);
    const Result<Quantity> quantity = parse_quantity(json.text);
    if (!quantity) return reader.fail(quantity.error());
    for (const Measure measure : {Measure::kLength, Measure::kForce}) {
      if (compatible(dimension(measure), quantity.value().unit.dimension)) sigma.measure = measure;
    }
    NumberOf{sigma.measure, kPositive}.read(reader, json, sigma.value);
  }
  JsonValue write(const Sigma& sigma) const { return JsonValue::string(write_quantity(sigma.value, sigma.measure)); }
  JsonValue schema(Schema&) const { return type_schema("string"); }
};

constexpr Measure measured_of(Prescribed prescribed) {
  return prescribed == Prescribed::kForce ? Measure::kLength : Measure::kForce;
}

struct ForceLengthEntry {
  ForceLengthBrief brief;
  std::optional<Sigma> sigma;
};

void describe(Fields& fields, ForceLengthEntry& entry) {
  ForceLengthBrief& b = entry.brief;
  fields.field("pose", b.pose, TextOf{false}, kOptional, "How it was held and loaded; the only one when absent.")
      .field("file", b.file, TextOf{false}, kRequired,
             "CSV file with the columns force and length (or displacement), units in the header.")
      .field("from", b.from, SelectorOf(), kOptional, "One end of the length; where `to` is drawn when absent.")
      .field("to", b.to, SelectorOf(), kRequired, "The other end of the length.")
      .field("axis", b.axis, DirectionOf(), kOptional,
             "Direction along which the length counts; the distance of the ends when absent.")
      .field("prescribed", b.prescribed, ChoiceOf<Prescribed>{kPrescribed}, kOptional,
             "What was set, so that the other one was measured.")
      .field("sigma", entry.sigma, SigmaOf(), kOptional,
             "Standard deviation of what was measured, where the file has no column for it.");
}

struct ForceLengthOf {
  static ObjectOf<ForceLengthEntry> object() { return {"force-length measurement"}; }
  void read(Reader& reader, const JsonValue& json, ForceLengthBrief& brief) const {
    ForceLengthEntry entry;
    object().read(reader, json, entry);
    if (reader.failed()) return;
    brief = std::move(entry.brief);
    if (!entry.sigma) return;
    const Measure measured = measured_of(brief.prescribed);
    if (entry.sigma->measure != measured) {
      const Reader::Step step(reader, "sigma");
      return reader.fail(wrong_dimension(measured, dimension(entry.sigma->measure)));
    }
    brief.sigma = entry.sigma->value;
  }
  JsonValue write(const ForceLengthBrief& brief) const {
    ForceLengthEntry entry{brief, {}};
    if (brief.sigma > 0) entry.sigma = Sigma{brief.sigma, measured_of(brief.prescribed)};
    return object().write(entry);
  }
  JsonValue schema(Schema& schema) const { return object().schema(schema); }
};

struct MeasurementEntry {
  std::optional<ForceLengthBrief> force_length;
  std::optional<ShapesBrief> shapes;
};

void describe(Fields& fields, MeasurementEntry& m) {
  fields.field("force_length", m.force_length, ForceLengthOf(), kOptional, "Pairs of a force and a length.")
      .field("shapes", m.shapes, ObjectOf<ShapesBrief>{"shapes measurement"}, kOptional, "Or places of nodes.");
}

struct MeasurementOf {
  static ObjectOf<MeasurementEntry> object() { return {"measurement"}; }
  void read(Reader& reader, const JsonValue& json, MeasurementBrief& brief) const {
    MeasurementEntry entry;
    object().read(reader, json, entry);
    if (reader.failed() ||
        !exactly_one(reader, {{"force_length", entry.force_length.has_value()}, {"shapes", entry.shapes.has_value()}},
                     "what was measured")) {
      return;
    }
    if (entry.force_length) brief = std::move(*entry.force_length);
    if (entry.shapes) brief = std::move(*entry.shapes);
  }
  JsonValue write(const MeasurementBrief& brief) const {
    MeasurementEntry entry;
    if (const auto* force_length = std::get_if<ForceLengthBrief>(&brief)) entry.force_length = *force_length;
    if (const auto* shapes = std::get_if<ShapesBrief>(&brief)) entry.shapes = *shapes;
    return object().write(entry);
  }
  JsonValue schema(Schema& schema) const { return object().schema(schema); }
};

}  // namespace

// Found by argument-dependent lookup, hence in the namespace of the structs.
void describe(Fields& fields, ShapesBrief& shapes) {
  fields.field("pose", shapes.pose, TextOf{false}, kOptional, "Of rows that name none; the only one when absent.")
      .field("file", shapes.file, TextOf{false}, kRequired,
             "CSV file with the columns pose, place or node, x, y and z, units in the header.")
      .field("sigma", shapes.sigma, NumberOf{Measure::kLength, kNotNegative}, kOptional,
             "Standard deviation of a coordinate, where the file has no column for it; 0: not known.");
}

void describe(Fields& fields, Calibration& calibration) {
  fields
      .field("parameters", calibration.parameters, ListOf<ParameterBriefOf>{{}, 1}, kRequired,
             "Which numbers of materials are unknown, with their bounds; the document has the values to start from.")
      .field("measurements", calibration.measurements, ListOf<MeasurementOf>{{}, 1}, kRequired, "What was measured.")
      .field("confidence", calibration.confidence, NumberOf{Measure::kRatio, between(0.5, 0.9999)}, kOptional,
             "Of the intervals.")
      .field("iterations", calibration.iterations, IntegerOf{1, 1'000'000}, kOptional, "At most.")
      .field("solve_tolerance", calibration.solve_tolerance, NumberOf{Measure::kRatio, kPositive}, kOptional,
             "Largest unbalanced force of an equilibrium, relative to the loads.");
}

void CalibrationOf::read(Reader& reader, const JsonValue& json, Calibration& calibration) const {
  ObjectOf<Calibration>{"calibration"}.read(reader, json, calibration);
}
JsonValue CalibrationOf::write(const Calibration& calibration) const {
  return ObjectOf<Calibration>{"calibration"}.write(calibration);
}
JsonValue CalibrationOf::schema(Schema& schema) const { return ObjectOf<Calibration>{"calibration"}.schema(schema); }

}  // namespace lissom
