#include "lissom/model/codecs_json.h"

#include <charconv>
#include <cmath>

#include "lissom/core/assert.h"

namespace lissom {
namespace {

/// What a number of these limits has to be; empty when `value` is.
std::string limits_broken(double value, Limits limits) {
  switch (limits.kind) {
    case Limits::Kind::kAny:
      return {};
    case Limits::Kind::kPositive:
      return value > 0 ? "" : "has to be positive";
    case Limits::Kind::kNotNegative:
      return value >= 0 ? "" : "must not be negative";
    case Limits::Kind::kNotZero:
      return value != 0 ? "" : "must not be zero";
    case Limits::Kind::kBetween:
      if (value >= limits.low && value <= limits.high) return {};
      return "has to be between " + number_text(limits.low) + " and " + number_text(limits.high);
  }
  return {};
}

constexpr std::pair<std::string_view, int> kAxes[] = {{"x", 0}, {"y", 1}, {"z", 2}, {"-x", 3}, {"-y", 4}, {"-z", 5}};

Vec3 axis(int index) {
  Vec3 direction = Vec3::Zero();
  direction[index % 3] = index < 3 ? 1 : -1;
  return direction;
}

}  // namespace

JsonValue type_schema(std::string_view type) { return JsonValue::object().set("type", JsonValue::string(type)); }

JsonValue any_of(std::vector<JsonValue> options) {
  return JsonValue::object().set("anyOf", JsonValue::array(std::move(options)));
}

void NumberOf::read(Reader& reader, const JsonValue& json, double& value) const {
  const MeasureInfo& what = info(measure);
  if (json.is(JsonValue::Kind::kNumber)) {
    const std::optional<Unit>& unit = reader.units.units[static_cast<std::size_t>(measure)];
    const Result<double> si = to_si(json.text, unit ? *unit : Unit{});
    if (!si) return reader.fail(si.error());
    if (!unit && si.value() != 0) {
      return reader.fail(ErrorCode::kUnit, "this " + std::string(what.name) + " needs a unit",
                         "write for example \"" + std::string(what.example) + "\"");
    }
    value = si.value();
  } else if (json.is(JsonValue::Kind::kString)) {
    const Result<Quantity> quantity = parse_quantity(json.text);
    if (!quantity) {
      Error error = quantity.error();
      if (error.code == ErrorCode::kType) error.hint = "write for example \"" + std::string(what.example) + "\"";
      return reader.fail(std::move(error));
    }
    if (!compatible(dimension(measure), quantity.value().unit.dimension)) {
      return reader.fail(wrong_dimension(measure, quantity.value().unit.dimension));
    }
    value = quantity.value().value;
  } else {
    return reader.fail_kind(std::string(what.article) + " such as \"" + std::string(what.example) + "\"", json);
  }
  if (const std::string broken = limits_broken(value, limits); !broken.empty()) {
    const std::string subject = measure == Measure::kRatio ? "number" : std::string(what.name);
    reader.fail(ErrorCode::kRange, "this " + subject + " " + broken +
                                       (limits.kind == Limits::Kind::kNotZero ? std::string() : ", not " + json.text));
  }
}

JsonValue NumberOf::write(double value) const {
  if (!std::isfinite(value)) return {};
  if (measure == Measure::kRatio) return JsonValue::number(number_text(value));
  return JsonValue::string(write_quantity(value, measure));
}

JsonValue number_schema(Measure measure, Limits limits) {
  JsonValue number = type_schema("number");
  if (limits.kind == Limits::Kind::kPositive) number.set("exclusiveMinimum", JsonValue::integer(0));
  if (limits.kind == Limits::Kind::kNotNegative) number.set("minimum", JsonValue::integer(0));
  if (limits.kind == Limits::Kind::kBetween && measure == Measure::kRatio) {
    number.set("minimum", JsonValue::number(number_text(limits.low)));
    number.set("maximum", JsonValue::number(number_text(limits.high)));
  }
  JsonValue text = type_schema("string");
  text.set("pattern", JsonValue::string("^\\s*[-+]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)?\\s*[^\\s0-9.,].*$|"
                                        "^\\s*[-+]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)?\\s+1\\s*/.*$"));
  text.set("examples", JsonValue::array({JsonValue::string(info(measure).example)}));
  return any_of({std::move(number), std::move(text)});
}

JsonValue NumberOf::schema(Schema& schema) const {
  std::string name = "number_" + std::string(info(measure).key);
  if (limits.kind == Limits::Kind::kPositive) name += "_positive";
  if (limits.kind == Limits::Kind::kNotNegative) name += "_not_negative";
  if (limits.kind == Limits::Kind::kBetween) {
    name += "_from_" + number_text(limits.low) + "_to_" + number_text(limits.high);
  }
  return schema.reference(name, [this](Schema&) { return number_schema(measure, limits); });
}

void IntegerOf::read(Reader& reader, const JsonValue& json, int& value) const {
  if (!json.is(JsonValue::Kind::kNumber)) return reader.fail_kind("a whole number", json);
  const char* end = json.text.data() + json.text.size();
  long long number = 0;
  const auto [last, code] = std::from_chars(json.text.data(), end, number);
  if (code == std::errc() && last != end) {
    return reader.fail(ErrorCode::kType, "expected a whole number, got " + json.text.substr(0, 40));
  }
  if (code != std::errc() || number < low || number > high) {
    return reader.fail(ErrorCode::kRange, "expected a whole number between " + std::to_string(low) + " and " +
                                              std::to_string(high) + ", got " + json.text.substr(0, 40));
  }
  value = static_cast<int>(number);
}

JsonValue IntegerOf::schema(Schema&) const {
  return type_schema("integer").set("minimum", JsonValue::integer(low)).set("maximum", JsonValue::integer(high));
}

void TextOf::read(Reader& reader, const JsonValue& json, std::string& value) const {
  if (!json.is(JsonValue::Kind::kString)) return reader.fail_kind("text in quotes", json);
  if (!may_be_empty && json.text.empty()) return reader.fail(ErrorCode::kType, "this text must not be empty");
  value = json.text;
}

JsonValue TextOf::schema(Schema&) const {
  JsonValue json = type_schema("string");
  if (!may_be_empty) json.set("minLength", JsonValue::integer(1));
  return json;
}

void FlagOf::read(Reader& reader, const JsonValue& json, bool& value) const {
  if (!json.is(JsonValue::Kind::kBool)) return reader.fail_kind("true or false", json);
  value = json.flag;
}

JsonValue FlagOf::schema(Schema&) const { return type_schema("boolean"); }

void VectorOf::read(Reader& reader, const JsonValue& json, Vec3& value) const {
  if (!json.is(JsonValue::Kind::kArray)) return reader.fail_kind("three numbers [x, y, z]", json);
  if (json.items.size() != 3) {
    return reader.fail(ErrorCode::kType, "expected three numbers [x, y, z], got " + std::to_string(json.items.size()));
  }
  for (std::size_t i = 0; i < 3 && !reader.failed(); ++i) {
    const Reader::Step step(reader, i);
    NumberOf{measure}.read(reader, json.items[i], value[static_cast<Eigen::Index>(i)]);
  }
}

JsonValue VectorOf::write(const Vec3& value) const {
  JsonValue json = JsonValue::array();
  const std::string_view unit = info(measure).default_unit;
  const bool bare = measure == Measure::kLength || measure == Measure::kRatio;
  for (const double x : value) {
    if (!std::isfinite(x)) return {};
    if (bare) {
      json.items.push_back(JsonValue::number(in_unit(x, parse_unit(unit).value())));
    } else {
      json.items.push_back(x == 0 ? JsonValue::number(number_text(x)) : NumberOf{measure}.write(x));
    }
  }
  return json;
}

JsonValue VectorOf::schema(Schema& schema) const {
  return schema.reference("vector_" + std::string(info(measure).key), [this](Schema& inner) {
    return ListOf<NumberOf>{{measure}, 3, 3}.schema(inner);
  });
}

Vec3 unit_direction(const Vec3& value) {
  constexpr double kRounding = 1e-14;
  const double largest = value.cwiseAbs().maxCoeff();
  if (!(largest > 0)) return value;
  if (std::abs(value.norm() - 1) < kRounding) return value;
  return (value / largest).normalized();
}

void DirectionOf::read(Reader& reader, const JsonValue& json, Vec3& value) const {
  if (json.is(JsonValue::Kind::kString)) {
    int index = 0;
    ChoiceOf<int>{kAxes}.read(reader, json, index);
    if (!reader.failed()) value = axis(index);
    return;
  }
  if (!json.is(JsonValue::Kind::kArray)) return reader.fail_kind("a direction [x, y, z] or \"x\", \"y\", \"z\"", json);
  VectorOf{Measure::kRatio}.read(reader, json, value);
  if (reader.failed()) return;
  if (value.isZero(0))
    return reader.fail(ErrorCode::kRange, "a direction must not be zero", "write for example [0, 0, 1]");
  value = unit_direction(value);
}

JsonValue DirectionOf::write(const Vec3& value) const { return VectorOf{Measure::kRatio}.write(value); }

JsonValue DirectionOf::schema(Schema& schema) const {
  return schema.reference("direction", [](Schema& inner) {
    return any_of({ChoiceOf<int>{kAxes}.schema(inner), ListOf<NumberOf>{{Measure::kRatio}, 3, 3}.schema(inner)});
  });
}

void PairOf::read(Reader& reader, const JsonValue& json, Vec2& value) const {
  if (!json.is(JsonValue::Kind::kArray) || json.items.size() != 2) {
    return reader.fail(ErrorCode::kType, "expected two numbers [" + std::string(info(first).name) + ", " +
                                             std::string(info(second).name) + "]");
  }
  for (std::size_t i = 0; i < 2 && !reader.failed(); ++i) {
    const Reader::Step step(reader, i);
    NumberOf{i == 0 ? first : second}.read(reader, json.items[i], value[static_cast<Eigen::Index>(i)]);
  }
}

JsonValue PairOf::write(const Vec2& value) const {
  return JsonValue::array({NumberOf{first}.write(value[0]), NumberOf{second}.write(value[1])});
}

JsonValue PairOf::schema(Schema& schema) const {
  return type_schema("array")
      .set("prefixItems", JsonValue::array({NumberOf{first}.schema(schema), NumberOf{second}.schema(schema)}))
      .set("minItems", JsonValue::integer(2))
      .set("maxItems", JsonValue::integer(2));
}

void OneOrPairOf::read(Reader& reader, const JsonValue& json, Vec2& value) const {
  const NumberOf number{measure, limits};
  if (!json.is(JsonValue::Kind::kArray)) {
    number.read(reader, json, value[0]);
    value[1] = value[0];
    return;
  }
  if (json.items.size() != 2) {
    return reader.fail(ErrorCode::kType,
                       "expected one number or two, [along 1, along 2], got " + std::to_string(json.items.size()));
  }
  for (std::size_t i = 0; i < 2 && !reader.failed(); ++i) {
    const Reader::Step step(reader, i);
    number.read(reader, json.items[i], value[static_cast<Eigen::Index>(i)]);
  }
}

JsonValue OneOrPairOf::write(const Vec2& value) const {
  const NumberOf number{measure, limits};
  if (value[0] == value[1]) return number.write(value[0]);
  return JsonValue::array({number.write(value[0]), number.write(value[1])});
}

JsonValue OneOrPairOf::schema(Schema& schema) const {
  const NumberOf number{measure, limits};
  return any_of({number.schema(schema), ListOf<NumberOf>{number, 2, 2}.schema(schema)});
}

}  // namespace lissom
