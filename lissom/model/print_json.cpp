#include <nlohmann/json.hpp>

#include "lissom/model/json_value.h"

namespace lissom {
namespace {

constexpr std::size_t kColumns = 100;

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// On one line; stops early once `limit` characters are exceeded.
void print_flat(const JsonValue& value, std::string& out, std::size_t limit) {
  switch (value.kind) {
    case JsonValue::Kind::kNull:
      out += "null";
      return;
    case JsonValue::Kind::kBool:
      out += value.flag ? "true" : "false";
      return;
    case JsonValue::Kind::kNumber:
      out += value.text;
      return;
    case JsonValue::Kind::kString:
      out += quoted(value.text);
      return;
    case JsonValue::Kind::kArray:
    case JsonValue::Kind::kObject:
      break;
  }
  const bool object = value.is(JsonValue::Kind::kObject);
  out += object ? '{' : '[';
  for (std::size_t i = 0; i < value.items.size() && out.size() <= limit; ++i) {
    if (i) out += ", ";
    if (object) out += quoted(value.keys[i]) + ": ";
    print_flat(value.items[i], out, limit);
  }
  out += object ? '}' : ']';
}

void print(const JsonValue& value, std::size_t indent, std::size_t used, std::string& out) {
  const bool object = value.is(JsonValue::Kind::kObject);
  std::string flat;
  print_flat(value, flat, kColumns);
  if (used + flat.size() <= kColumns || value.items.empty()) {
    out += flat;
    return;
  }
  out += object ? '{' : '[';
  const std::string margin(indent + 2, ' ');
  for (std::size_t i = 0; i < value.items.size(); ++i) {
    out += (i ? ",\n" : "\n") + margin;
    const std::string key = object ? quoted(value.keys[i]) + ": " : std::string();
    out += key;
    print(value.items[i], indent + 2, indent + 2 + key.size(), out);
  }
  out += "\n" + std::string(indent, ' ') + (object ? '}' : ']');
}

}  // namespace

std::string print_json(const JsonValue& value) {
  std::string out;
  if (value.is(JsonValue::Kind::kObject) && !value.items.empty()) {
    print(value, 0, kColumns, out);  // the document itself is never squeezed onto one line
  } else {
    print(value, 0, 0, out);
  }
  return out + "\n";
}

}  // namespace lissom
