#pragma once
/// A JSON text as a tree. Numbers stay text until their unit is known, so that 0.1 of a millimetre is the double nearest
/// to 0.0001. Objects keep the order of their keys.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lissom/core/result.h"

namespace lissom {

struct JsonValue {
  enum class Kind { kNull, kBool, kNumber, kString, kArray, kObject };
  Kind kind = Kind::kNull;
  bool flag = false;              ///< kBool
  std::string text;               ///< kString, and kNumber as written
  std::vector<std::string> keys;  ///< kObject, as many as `items`
  std::vector<JsonValue> items;   ///< kArray, kObject

  static JsonValue boolean(bool value);
  static JsonValue number(std::string text);
  static JsonValue integer(long long value);
  static JsonValue string(std::string_view text);
  static JsonValue array(std::vector<JsonValue> items = {});
  static JsonValue object();

  bool is(Kind k) const { return kind == k; }
  const JsonValue* find(std::string_view key) const;  ///< null when absent
  JsonValue& set(std::string key, JsonValue value);   ///< appends a key; returns *this
  bool operator==(const JsonValue&) const = default;
};

/// "a number", "text", "a list", ... for messages.
std::string_view in_words(JsonValue::Kind kind);

/// Refuses syntax errors with line and column, repeated keys, invalid UTF-8, brackets nested deeper than `depth`.
Result<JsonValue> parse_json(std::string_view text, int depth);

/// Two-space indent; lists and objects that fit into 100 columns stay on one line; final newline.
std::string print_json(const JsonValue& value);

/// `key` as a step of a JSON pointer: "~" -> "~0", "/" -> "~1".
std::string pointer_step(std::string_view key);

}  // namespace lissom
