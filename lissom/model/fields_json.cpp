#include "lissom/model/fields_json.h"

#include <algorithm>

namespace lissom {

UnitSettings::UnitSettings() {
  for (int i = 0; i < kMeasures; ++i) {
    const std::string_view unit = info(static_cast<Measure>(i)).default_unit;
    if (!unit.empty()) units[static_cast<std::size_t>(i)] = parse_unit(unit).value();
  }
}

void Reader::fail(ErrorCode code, std::string message, std::string hint) {
  if (!error_) error_ = Error{code, where(), std::move(message), std::move(hint)};
}

void Reader::fail(Error error) { fail(error.code, std::move(error.message), std::move(error.hint)); }

void Reader::fail_kind(std::string_view expected, const JsonValue& got) {
  fail(ErrorCode::kType, "expected " + std::string(expected) + ", got " + std::string(in_words(got.kind)));
}

std::string Reader::where() const {
  std::string text;
  for (const std::string& step : path_) text.append("/").append(pointer_step(step));
  return text;
}

std::string definition_name(std::string_view title) {
  std::string name(title);
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

const JsonValue* Fields::begin(std::string_view key, Presence presence, std::string_view text) {
  if (reader_->failed()) return nullptr;
  const JsonValue* json = source_->find(key);
  if (!json && presence == kRequired && missing_.empty()) {
    missing_ = key;
    missing_text_ = text.substr(0, text.find_last_not_of('.') + 1);
  }
  return json;
}

void Fields::finish_reading(std::string_view title) {
  if (reader_->failed()) return;
  for (const std::string& key : source_->keys) {
    if (std::find(keys_.begin(), keys_.end(), key) != keys_.end()) continue;
    const Reader::Step step(*reader_, key);
    return reader_->fail(ErrorCode::kUnknown, "unknown key \"" + key + "\" in a " + std::string(title),
                         suggestion(key, keys_));
  }
  if (!missing_.empty()) {
    reader_->fail(ErrorCode::kType, "the key \"" + missing_ + "\" is missing in this " + std::string(title),
                  "add \"" + missing_ + "\": " + missing_text_);
  }
}

void Fields::add_written(std::string_view key, JsonValue value, Presence presence) {
  if (value.is(JsonValue::Kind::kNull)) return;
  if (presence == kRequired) required_.emplace_back(key);
  written_.set(std::string(key), std::move(value));
}

JsonValue Fields::finish_writing(const JsonValue* defaults) {
  if (!defaults) return written_;
  JsonValue kept = JsonValue::object();
  for (std::size_t i = 0; i < written_.keys.size(); ++i) {
    const std::string& key = written_.keys[i];
    const JsonValue* plain = defaults->find(key);
    const bool needed = std::find(required_.begin(), required_.end(), key) != required_.end();
    if (needed || !plain || !(*plain == written_.items[i])) kept.set(key, written_.items[i]);
  }
  return kept;
}

void Fields::add_schema(std::string_view key, JsonValue schema, Presence presence, std::string_view text) {
  schema.set("description", JsonValue::string(text));
  const JsonValue* plain = source_->find(key);
  const bool empty = !plain || (plain->items.empty() && plain->text.empty() && !plain->is(JsonValue::Kind::kBool));
  if (presence == kRequired) {
    required_.emplace_back(key);
  } else if (!empty) {
    schema.set("default", *plain);
  }
  written_.set(std::string(key), std::move(schema));
}

JsonValue Fields::finish_schema(std::string_view title) const {
  JsonValue schema = JsonValue::object();
  schema.set("title", JsonValue::string(title)).set("type", JsonValue::string("object"));
  schema.set("additionalProperties", JsonValue::boolean(false));
  if (!required_.empty()) {
    JsonValue list = JsonValue::array();
    for (const std::string& key : required_) list.items.push_back(JsonValue::string(key));
    schema.set("required", std::move(list));
  }
  return schema.set("properties", written_);
}

}  // namespace lissom
