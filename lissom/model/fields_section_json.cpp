#include <algorithm>

#include "lissom/model/entries_json.h"

namespace lissom {
namespace {

using Lengths = std::vector<double>;

constexpr std::pair<std::string_view, SectionShape> kShapes[] = {
    {"ellipse", SectionShape::kEllipse}, {"rectangle", SectionShape::kRectangle}, {"tube", SectionShape::kTube}};

/// A cross-section as written. Ellipses have half-axes, laths full extents, because that is how they are sold.
struct SectionEntry {
  SectionShape shape = SectionShape::kEllipse;
  std::optional<Lengths> radius, r_n, r_b, thickness, width;
  std::optional<double> wall;
};

void describe(Fields& fields, SectionEntry& entry) {
  const OneOrListOf<NumberOf> lengths{{Measure::kLength, kPositive}};
  fields.field("shape", entry.shape, ChoiceOf<SectionShape>{kShapes}, kOptional, "Shape of the cross-section.")
      .field(
          "radius", entry.radius, lengths, kOptional,
          "Radius of a round rod or outer radius of a tube; a list gives values at evenly spaced places along the rod.")
      .field("r_n", entry.r_n, lengths, kOptional, "Half-axis of an ellipse along the material axis n (out of plane).")
      .field("r_b", entry.r_b, lengths, kOptional, "Half-axis of an ellipse along b = n x t (in plane).")
      .field("thickness", entry.thickness, lengths, kOptional, "Full thickness of a rectangle along n.")
      .field("width", entry.width, lengths, kOptional, "Full width of a rectangle along b.")
      .field("wall", entry.wall, NumberOf{Measure::kLength, kPositive}, kOptional, "Wall thickness of a tube.");
}

/// Repeats a single value so that both lists are equally long; false when neither is single.
bool match_lengths(Lengths& a, Lengths& b) {
  if (a.size() == 1) a.assign(b.size(), a[0]);
  if (b.size() == 1) b.assign(a.size(), b[0]);
  return a.size() == b.size();
}

struct Extent {
  const std::optional<Lengths>* value;
  std::string_view key;
  bool wanted;
};

void section_of(Reader& reader, const SectionEntry& entry, SectionProfile& section) {
  section = {};
  section.shape = entry.shape;
  const bool ellipse = entry.shape == SectionShape::kEllipse, tube = entry.shape == SectionShape::kTube;
  const bool rectangle = entry.shape == SectionShape::kRectangle;
  const bool round = tube || (ellipse && !entry.r_n && !entry.r_b);
  const std::string_view name = ellipse ? "an ellipse" : tube ? "a tube" : "a rectangle";
  const std::string hint = ellipse ? "give \"radius\", or \"r_n\" and \"r_b\""
                           : tube  ? "give \"radius\" and \"wall\""
                                   : "give \"thickness\" and \"width\"";
  const Extent extents[] = {{&entry.radius, "radius", round},
                            {&entry.r_n, "r_n", ellipse && !round},
                            {&entry.r_b, "r_b", ellipse && !round},
                            {&entry.thickness, "thickness", rectangle},
                            {&entry.width, "width", rectangle}};
  for (const Extent& extent : extents) {
    if (!extent.value->has_value() || extent.wanted) continue;
    const Reader::Step step(reader, extent.key);
    return reader.fail(
        ErrorCode::kConflict,
        "\"" + std::string(extent.key) + "\" does not belong to this section, which is " + std::string(name), hint);
  }
  for (const Extent& extent : extents) {
    if (extent.wanted && !extent.value->has_value()) {
      return reader.fail(ErrorCode::kType, "\"" + std::string(extent.key) + "\" of the section is missing", hint);
    }
  }
  if (tube != entry.wall.has_value()) {
    if (tube) return reader.fail(ErrorCode::kType, "\"wall\" of the section is missing", hint);
    const Reader::Step step(reader, "wall");
    return reader.fail(ErrorCode::kConflict, "only a tube has a wall", "add \"shape\": \"tube\", or remove \"wall\"");
  }
  section.wall = entry.wall.value_or(0);
  section.r_n = round ? *entry.radius : ellipse ? *entry.r_n : *entry.thickness;
  section.r_b = round ? *entry.radius : ellipse ? *entry.r_b : *entry.width;
  if (!match_lengths(section.r_n, section.r_b)) {
    return reader.fail(ErrorCode::kConflict,
                       "the two lists of this section have " + std::to_string(section.r_n.size()) + " and " +
                           std::to_string(section.r_b.size()) + " entries",
                       "give both at the same places along the rod, or one of them as a single number");
  }
  if (rectangle) {
    for (double& x : section.r_n) x /= 2;
    for (double& x : section.r_b) x /= 2;
  }
}

Lengths doubled(Lengths values) {
  for (double& x : values) x *= 2;
  return values;
}

constexpr ObjectOf<SectionEntry> kSection{"section"};

/// The object form of material axes.
struct AxesEntry {
  std::optional<Vec3> normal, transport;
  std::optional<std::vector<Vec3>> per_point;
};

void describe(Fields& fields, AxesEntry& entry) {
  fields
      .field("normal", entry.normal, DirectionOf(), kOptional,
             "n is this direction, made perpendicular to the tangent of the rod.")
      .field("transport", entry.transport, DirectionOf(), kOptional,
             "n starts from this direction and is carried along the rod without twist.")
      .field("per_point", entry.per_point, ListOf<DirectionOf>{{}, 2}, kOptional,
             "n at evenly spaced places along the rod, interpolated.");
}

constexpr ObjectOf<AxesEntry> kAxes{"axes"};

/// The object form of a natural shape.
struct NaturalEntry {
  std::optional<Natural::Kind> shape;
  std::optional<double> curvature_b, curvature_n, twist, length_factor;
  std::optional<Curve> curve;
  std::optional<MaterialAxes> axes;
};

constexpr ConvertedOf<Curve, CurveEntry> kCurve{"curve"};
constexpr std::pair<std::string_view, Natural::Kind> kNaturalWords[] = {{"as_drawn", Natural::Kind::kAsDrawn},
                                                                        {"straight", Natural::Kind::kStraight}};

void describe(Fields& fields, NaturalEntry& entry) {
  fields
      .field("shape", entry.shape, ChoiceOf<Natural::Kind>{kNaturalWords}, kOptional,
             "The same as the word alone; as drawn when nothing else is said.")
      .field("curvature_b", entry.curvature_b, NumberOf{Measure::kCurvature}, kOptional,
             "Constant curvature towards b.")
      .field("curvature_n", entry.curvature_n, NumberOf{Measure::kCurvature}, kOptional,
             "Constant curvature towards n.")
      .field("twist", entry.twist, NumberOf{Measure::kTwistRate}, kOptional, "Constant twist per length.")
      .field("curve", entry.curve, kCurve, kOptional, "Another curve that is free of stress, cut into the same edges.")
      .field("axes", entry.axes, AxesOf(), kOptional, "Material axes on that curve; those of the rod when absent.")
      .field("length_factor", entry.length_factor, NumberOf{Measure::kRatio, kPositive}, kOptional,
             "Natural length over that of the shape that the rest describes; 1 when absent.");
}

constexpr ObjectOf<NaturalEntry> kNatural{"natural shape"};

}  // namespace

void SectionOf::read(Reader& reader, const JsonValue& json, SectionProfile& section) const {
  SectionEntry entry;
  kSection.read(reader, json, entry);
  if (!reader.failed()) section_of(reader, entry, section);
}

JsonValue SectionOf::write(const SectionProfile& section) const {
  SectionEntry entry;
  entry.shape = section.shape;
  if (section.shape == SectionShape::kRectangle) {
    entry.thickness = doubled(section.r_n);
    entry.width = doubled(section.r_b);
  } else if (section.shape == SectionShape::kTube || section.r_n == section.r_b) {
    entry.radius = section.r_n;
  } else {
    entry.r_n = section.r_n;
    entry.r_b = section.r_b;
  }
  if (section.shape == SectionShape::kTube) entry.wall = section.wall;
  return kSection.write(entry);
}

JsonValue SectionOf::schema(Schema& schema) const { return kSection.schema(schema); }

void AxesOf::read(Reader& reader, const JsonValue& json, MaterialAxes& axes) const {
  axes = {};
  if (json.is(JsonValue::Kind::kString)) {
    axes.kind = MaterialAxes::Kind::kJoints;
    if (json.text != "joints") {
      reader.fail(ErrorCode::kUnknown, "\"" + json.text + "\" is not a way to orient a rod",
                  "write \"joints\", {\"normal\": [0, 0, 1]}, {\"transport\": ...} or {\"per_point\": [...]}");
    }
    return;
  }
  AxesEntry entry;
  kAxes.read(reader, json, entry);
  if (reader.failed()) return;
  const int kinds = entry.normal.has_value() + entry.transport.has_value() + entry.per_point.has_value();
  if (kinds != 1) {
    return reader.fail(kinds == 0 ? ErrorCode::kType : ErrorCode::kConflict,
                       kinds == 0 ? "the axes say nothing" : "the axes are given in more than one way",
                       "give one of \"normal\", \"transport\" and \"per_point\"");
  }
  if (entry.normal || entry.transport) axes.normal = entry.normal ? *entry.normal : *entry.transport;
  if (entry.transport) axes.kind = MaterialAxes::Kind::kTransport;
  if (entry.per_point) {
    axes.kind = MaterialAxes::Kind::kPerPoint;
    axes.normals = *entry.per_point;
  }
}

JsonValue AxesOf::write(const MaterialAxes& axes) const {
  AxesEntry entry;
  switch (axes.kind) {
    case MaterialAxes::Kind::kDirection:
      entry.normal = axes.normal;
      break;
    case MaterialAxes::Kind::kTransport:
      entry.transport = axes.normal;
      break;
    case MaterialAxes::Kind::kPerPoint:
      entry.per_point = axes.normals;
      break;
    case MaterialAxes::Kind::kJoints:
      return JsonValue::string("joints");
  }
  return kAxes.write(entry);
}

JsonValue AxesOf::schema(Schema& schema) const {
  return any_of({JsonValue::object().set("const", JsonValue::string("joints")), kAxes.schema(schema)});
}

void NaturalOf::read(Reader& reader, const JsonValue& json, Natural& natural) const {
  natural = {};
  if (json.is(JsonValue::Kind::kString)) {
    if (json.text == "straight") {
      natural.kind = Natural::Kind::kStraight;
    } else if (json.text != "as_drawn") {
      reader.fail(ErrorCode::kUnknown, "\"" + json.text + "\" is not a natural shape",
                  "write \"as_drawn\", \"straight\", {\"curvature_b\": \"20 1/m\"} or {\"curve\": {...}}");
    }
    return;
  }
  NaturalEntry entry;
  kNatural.read(reader, json, entry);
  if (reader.failed()) return;
  const bool rates = entry.curvature_b || entry.curvature_n || entry.twist;
  if (rates && entry.curve) {
    return reader.fail(ErrorCode::kConflict, "a natural shape is either a curve or has constant curvature and twist",
                       "give \"curve\", or some of \"curvature_b\", \"curvature_n\" and \"twist\"");
  }
  const bool described = rates || entry.curve;
  if (described && entry.shape) {
    const Reader::Step step(reader, "shape");
    return reader.fail(ErrorCode::kConflict, "the natural shape is named and described",
                       "leave out \"shape\", or what else describes it");
  }
  if (!described && !entry.shape && !entry.length_factor) {
    return reader.fail(ErrorCode::kType, "the natural shape says nothing",
                       "give \"curve\", or some of \"curvature_b\", \"curvature_n\" and \"twist\"");
  }
  if (entry.axes && !entry.curve) {
    const Reader::Step step(reader, "axes");
    return reader.fail(ErrorCode::kConflict, "the axes of a natural shape belong to its \"curve\", which is missing",
                       "orient the rod by its own \"axes\"");
  }
  natural.kind = rates         ? Natural::Kind::kCurved
                 : entry.curve ? Natural::Kind::kCurve
                               : entry.shape.value_or(Natural::Kind::kAsDrawn);
  natural.length_factor = entry.length_factor.value_or(1);
  natural.curvature_b = entry.curvature_b.value_or(0);
  natural.curvature_n = entry.curvature_n.value_or(0);
  natural.twist = entry.twist.value_or(0);
  natural.curve = entry.curve;
  natural.axes = entry.axes;
}

JsonValue NaturalOf::write(const Natural& natural) const {
  const bool word = natural.kind == Natural::Kind::kAsDrawn || natural.kind == Natural::Kind::kStraight;
  if (word && natural.length_factor == 1) return ChoiceOf<Natural::Kind>{kNaturalWords}.write(natural.kind);
  NaturalEntry entry;
  if (natural.length_factor != 1) entry.length_factor = natural.length_factor;
  if (word) {
    entry.shape = natural.kind;
  } else if (natural.kind == Natural::Kind::kCurve) {
    entry.curve = natural.curve;
    entry.axes = natural.axes;
  } else {
    entry.curvature_b = natural.curvature_b;
    entry.curvature_n = natural.curvature_n;
    entry.twist = natural.twist;
  }
  return kNatural.write(entry);
}

JsonValue NaturalOf::schema(Schema& schema) const {
  JsonValue words = JsonValue::array({JsonValue::string("as_drawn"), JsonValue::string("straight")});
  return any_of({JsonValue::object().set("enum", std::move(words)), kNatural.schema(schema)});
}

}  // namespace lissom
