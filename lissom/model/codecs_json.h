#pragma once
/// How single values look in a document: numbers with units, directions, choices, lists, tables of named things.

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lissom/core/types.h"
#include "lissom/model/fields_json.h"

namespace lissom {

/// What a number may be, in SI.
struct Limits {
  enum class Kind { kAny, kPositive, kNotNegative, kNotZero, kBetween } kind = Kind::kAny;
  double low = 0, high = 0;  ///< kBetween, both allowed
};
constexpr Limits kAny{};
constexpr Limits kPositive{Limits::Kind::kPositive};
constexpr Limits kNotNegative{Limits::Kind::kNotNegative};
constexpr Limits kNotZero{Limits::Kind::kNotZero};
constexpr Limits between(double low, double high) { return {Limits::Kind::kBetween, low, high}; }

/// A JSON number in the document's unit, or text with a unit.
struct NumberOf {
  Measure measure = Measure::kRatio;
  Limits limits = kAny;
  void read(Reader& reader, const JsonValue& json, double& value) const;
  JsonValue write(double value) const;
  JsonValue schema(Schema& schema) const;
};
JsonValue number_schema(Measure measure, Limits limits);

struct IntegerOf {
  int low = 0, high = 1'000'000;
  void read(Reader& reader, const JsonValue& json, int& value) const;
  JsonValue write(int value) const { return JsonValue::integer(value); }
  JsonValue schema(Schema& schema) const;
};

struct TextOf {
  bool may_be_empty = true;
  void read(Reader& reader, const JsonValue& json, std::string& value) const;
  JsonValue write(const std::string& value) const { return JsonValue::string(value); }
  JsonValue schema(Schema& schema) const;
};

struct FlagOf {
  void read(Reader& reader, const JsonValue& json, bool& value) const;
  JsonValue write(bool value) const { return JsonValue::boolean(value); }
  JsonValue schema(Schema& schema) const;
};

/// [x, y, z], each a NumberOf.
struct VectorOf {
  Measure measure = Measure::kLength;
  void read(Reader& reader, const JsonValue& json, Vec3& value) const;
  JsonValue write(const Vec3& value) const;
  JsonValue schema(Schema& schema) const;
};

/// [x, y, z] without unit, or "x", "-y", ...; brought to unit length.
struct DirectionOf {
  void read(Reader& reader, const JsonValue& json, Vec3& value) const;
  JsonValue write(const Vec3& value) const;
  JsonValue schema(Schema& schema) const;
};

/// `value` at unit length; left alone when its length is 1 to rounding, so that reading twice changes nothing.
Vec3 unit_direction(const Vec3& value);

/// [a, b] with a measure each.
struct PairOf {
  Measure first, second;
  void read(Reader& reader, const JsonValue& json, Vec2& value) const;
  JsonValue write(const Vec2& value) const;
  JsonValue schema(Schema& schema) const;
};

/// One number for both, or [a, b].
struct OneOrPairOf {
  Measure measure;
  Limits limits = kAny;
  void read(Reader& reader, const JsonValue& json, Vec2& value) const;
  JsonValue write(const Vec2& value) const;
  JsonValue schema(Schema& schema) const;
};

/// One of a few words.
template <class E>
struct ChoiceOf {
  std::span<const std::pair<std::string_view, E>> words;

  void read(Reader& reader, const JsonValue& json, E& value) const {
    if (!json.is(JsonValue::Kind::kString)) return reader.fail_kind("one of " + list(), json);
    for (const auto& [word, meaning] : words) {
      if (word == json.text) {
        value = meaning;
        return;
      }
    }
    std::vector<std::string> known;
    for (const auto& entry : words) known.emplace_back(entry.first);
    const std::string near = nearest_name(json.text, known);
    reader.fail(ErrorCode::kUnknown, "\"" + json.text + "\" is not one of " + list(),
                near.empty() ? std::string() : "did you mean \"" + near + "\"?");
  }
  JsonValue write(E value) const {
    for (const auto& [word, meaning] : words) {
      if (meaning == value) return JsonValue::string(word);
    }
    return {};
  }
  JsonValue schema(Schema&) const {
    JsonValue options = JsonValue::array();
    for (const auto& entry : words) options.items.push_back(JsonValue::string(entry.first));
    return JsonValue::object().set("enum", std::move(options));
  }

 private:
  std::string list() const {
    std::string text;
    for (const auto& entry : words) text += (text.empty() ? "\"" : ", \"") + std::string(entry.first) + "\"";
    return text;
  }
};

/// A list of at least `least` (and at most `most`, when not 0) entries.
template <class Codec>
struct ListOf {
  Codec codec;
  std::size_t least = 0, most = 0;

  template <class T>
  void read(Reader& reader, const JsonValue& json, std::vector<T>& value) const {
    if (!json.is(JsonValue::Kind::kArray)) return reader.fail_kind("a list [...]", json);
    const std::size_t n = json.items.size();
    if (n < least || (most > 0 && n > most)) {
      const std::string wanted = least == most ? std::to_string(least)
                                 : n < least   ? "at least " + std::to_string(least)
                                               : "at most " + std::to_string(most);
      return reader.fail(ErrorCode::kType, "expected " + wanted +
                                               (wanted == "1" || wanted.ends_with(" 1") ? " entry" : " entries") +
                                               ", got " + std::to_string(n));
    }
    value.resize(n);
    for (std::size_t i = 0; i < n && !reader.failed(); ++i) {
      const Reader::Step step(reader, i);
      codec.read(reader, json.items[i], value[i]);
    }
  }
  template <class T>
  JsonValue write(const std::vector<T>& value) const {
    JsonValue json = JsonValue::array();
    for (const T& item : value) json.items.push_back(codec.write(item));
    return json;
  }
  JsonValue schema(Schema& schema) const {
    JsonValue json = JsonValue::object().set("type", JsonValue::string("array")).set("items", codec.schema(schema));
    if (least > 0) json.set("minItems", JsonValue::integer(static_cast<long long>(least)));
    if (most > 0) json.set("maxItems", JsonValue::integer(static_cast<long long>(most)));
    return json;
  }
};

/// One value, or a list of them.
template <class Codec>
struct OneOrListOf {
  Codec codec;

  template <class T>
  void read(Reader& reader, const JsonValue& json, std::vector<T>& value) const {
    if (json.is(JsonValue::Kind::kArray)) return ListOf<Codec>{codec, 1}.read(reader, json, value);
    value.resize(1);
    codec.read(reader, json, value[0]);
  }
  template <class T>
  JsonValue write(const std::vector<T>& value) const {
    if (value.size() == 1) return codec.write(value[0]);
    return ListOf<Codec>{codec, 1}.write(value);
  }
  JsonValue schema(Schema& schema) const {
    JsonValue options = JsonValue::array();
    options.items.push_back(codec.schema(schema));
    options.items.push_back(ListOf<Codec>{codec, 1}.schema(schema));
    return JsonValue::object().set("anyOf", std::move(options));
  }
};

/// {"name": value, ...}: a list of things that carry their name in a member.
template <class Codec, class T>
struct TableOf {
  Codec codec;
  std::string T::*name;

  void read(Reader& reader, const JsonValue& json, std::vector<T>& value) const {
    if (!json.is(JsonValue::Kind::kObject)) return reader.fail_kind("an object {\"name\": ...}", json);
    for (std::size_t i = 0; i < json.items.size() && !reader.failed(); ++i) {
      const Reader::Step step(reader, json.keys[i]);
      if (json.keys[i].empty()) return reader.fail(ErrorCode::kUnknown, "a name must not be empty");
      T& item = value.emplace_back();
      codec.read(reader, json.items[i], item);
      item.*name = json.keys[i];
    }
  }
  JsonValue write(const std::vector<T>& value) const {
    JsonValue json = JsonValue::object();
    for (const T& item : value) json.set(item.*name, codec.write(item));
    return json;
  }
  JsonValue schema(Schema& schema) const {
    return JsonValue::object()
        .set("type", JsonValue::string("object"))
        .set("additionalProperties", codec.schema(schema));
  }
};

/// {"type": NAME} and {"anyOf": [...]}.
JsonValue type_schema(std::string_view type);
JsonValue any_of(std::vector<JsonValue> options);

}  // namespace lissom
