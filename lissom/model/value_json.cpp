#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include "lissom/model/json_value.h"

namespace lissom {

JsonValue JsonValue::boolean(bool value) {
  JsonValue json;
  json.kind = Kind::kBool;
  json.flag = value;
  return json;
}

JsonValue JsonValue::number(std::string text) {
  JsonValue json;
  json.kind = Kind::kNumber;
  json.text = std::move(text);
  return json;
}

JsonValue JsonValue::integer(long long value) { return number(std::to_string(value)); }

JsonValue JsonValue::string(std::string_view text) {
  JsonValue json;
  json.kind = Kind::kString;
  json.text = text;
  return json;
}

JsonValue JsonValue::array(std::vector<JsonValue> items) {
  JsonValue json;
  json.kind = Kind::kArray;
  json.items = std::move(items);
  return json;
}

JsonValue JsonValue::object() {
  JsonValue json;
  json.kind = Kind::kObject;
  return json;
}

const JsonValue* JsonValue::find(std::string_view key) const {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i] == key) return &items[i];
  }
  return nullptr;
}

JsonValue& JsonValue::set(std::string key, JsonValue value) {
  keys.push_back(std::move(key));
  items.push_back(std::move(value));
  return *this;
}

std::string_view in_words(JsonValue::Kind kind) {
  switch (kind) {
    case JsonValue::Kind::kNull:
      return "null";
    case JsonValue::Kind::kBool:
      return "true or false";
    case JsonValue::Kind::kNumber:
      return "a number";
    case JsonValue::Kind::kString:
      return "text";
    case JsonValue::Kind::kArray:
      return "a list";
    case JsonValue::Kind::kObject:
      return "an object";
  }
  return {};
}

std::string pointer_step(std::string_view key) {
  std::string step;
  for (const char c : key) {
    if (c == '~') {
      step += "~0";
    } else if (c == '/') {
      step += "~1";
    } else {
      step += c;
    }
  }
  return step;
}

namespace {

/// Builds the tree from the events of the parser, which itself does not recurse.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view text, int depth) : text_(text), depth_(depth) {}

  bool null() override { return add({}); }
  bool boolean(bool value) override { return add(JsonValue::boolean(value)); }
  bool number_integer(number_integer_t value) override { return add(JsonValue::integer(value)); }
  bool number_unsigned(number_unsigned_t value) override { return add(JsonValue::number(std::to_string(value))); }
  bool number_float(number_float_t, const string_t& text) override { return add(JsonValue::number(text)); }
  bool string(string_t& text) override { return add(JsonValue::string(text)); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(JsonValue::object()); }
  bool start_array(std::size_t) override { return open(JsonValue::array()); }
  bool end_array() override { return close(); }
  bool end_object() override { return close(); }

  bool key(string_t& key) override {
    if (!open_.back().known.insert(key).second) {
      return refuse(ErrorCode::kConflict, pointer(open_.size()) + "/" + pointer_step(key),
                    "the key \"" + key + "\" appears twice", "keep one of the two");
    }
    open_.back().value.keys.push_back(key);
    return true;
  }

  bool parse_error(std::size_t position, const std::string& last, const nlohmann::detail::exception& problem) override {
    explain(position, last, problem.what());
    return false;
  }

  JsonValue& root() { return root_; }
  const Error& error() const { return error_; }

 private:
  struct Open {
    JsonValue value;
    std::unordered_set<std::string> known;
  };

  bool add(JsonValue value) {
    (open_.empty() ? root_ : open_.back().value.items.emplace_back()) = std::move(value);
    return true;
  }

  bool open(JsonValue value) {
    if (static_cast<int>(open_.size()) >= depth_) {
      return refuse(ErrorCode::kSyntax, pointer(kShownSteps),
                    "the brackets are nested deeper than " + std::to_string(depth_), {});
    }
    open_.push_back({std::move(value), {}});
    return true;
  }

  bool close() {
    JsonValue value = std::move(open_.back().value);
    open_.pop_back();
    return add(std::move(value));
  }

  bool refuse(ErrorCode code, std::string where, std::string message, std::string hint) {
    error_ = {code, std::move(where), std::move(message), std::move(hint)};
    return false;
  }

  static constexpr std::size_t kShownSteps = 4;  ///< of a place that is nested absurdly deep

  std::string pointer(std::size_t steps) const {
    std::string where;
    for (std::size_t i = 0; i < steps && i + 1 < open_.size(); ++i) {
      const JsonValue& value = open_[i].value;
      where += "/" + (value.is(JsonValue::Kind::kObject) ? pointer_step(value.keys.back())
                                                         : std::to_string(value.items.size()));
    }
    return where;
  }

  /// `position` counts the bytes read so far; the last of them is where reading stopped.
  std::string line_and_column(std::size_t position) const {
    const std::string_view before = text_.substr(0, std::min(position > 0 ? position - 1 : 0, text_.size()));
    const std::size_t line = 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    const std::size_t start = before.rfind('\n') + 1;  // npos + 1 is 0
    const auto starts_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
    const auto column =
        1 + std::count_if(before.begin() + static_cast<std::ptrdiff_t>(start), before.end(), starts_character);
    return "line " + std::to_string(line) + ", column " + std::to_string(column);
  }

  void explain(std::size_t position, const std::string& last, std::string_view what) {
    const auto says = [what](std::string_view part) { return what.find(part) != std::string_view::npos; };
    std::string message = "this is not valid JSON", hint;
    if (position > text_.size() && !says("UTF-8")) {
      message = text_.find_first_not_of(" \t\r\n") == std::string_view::npos ? "the document is empty"
                                                                             : "the document ends too early";
      hint = "a closing bracket, brace or quote is missing";
      if (message == "the document is empty") hint = "a smallest document is {\"lissom\": 1, \"rods\": [...]}";
    } else if (says("UTF-8")) {
      message = "the text is not valid UTF-8";
      hint = "save the file with the encoding UTF-8";
    } else if (says("number overflow")) {
      message = "the number " + last.substr(0, 40) + " is too large to be held";
      hint = "check its exponent";
    } else if (says("control character")) {
      message = "a text runs over the end of its line or holds a control character";
      hint = "is the closing quote missing?";
    } else if (says("backslash") || says("'\\u'") || says("surrogate")) {
      message = "the backslash in this text starts no known escape";
      hint = "a backslash itself is written \"\\\\\"";
    } else if (says("expected end of input")) {
      message = "there is more text after the end of the document";
      hint = "is a brace closed too early?";
    } else if (position > 0 && position <= text_.size() && text_[position - 1] == '/') {
      message = "a comment is not allowed here";
      hint = "JSON has no comments; use \"title\" and \"source\"";
    } else if (says("while parsing object key")) {
      message = "a key in quotes is expected here";
      hint = "is there a comma too many before a closing brace, or a key without quotes?";
    } else if (says("while parsing object separator")) {
      message = "a colon is expected after the key";
    } else if (says("while parsing object")) {
      message = "a comma or a closing brace is expected here";
    } else if (says("while parsing array")) {
      message = "a comma or a closing bracket is expected here";
    } else if (says("while parsing value")) {
      message = "a value is expected here";
      hint = "values are numbers, texts in double quotes, true, false, [...] or {...}";
    }
    error_ = {ErrorCode::kSyntax, line_and_column(position), std::move(message), std::move(hint)};
  }

  std::string_view text_;
  int depth_;
  JsonValue root_;
  std::vector<Open> open_;
  Error error_{ErrorCode::kSyntax, {}, "this is not valid JSON", {}};
};

}  // namespace

Result<JsonValue> parse_json(std::string_view text, int depth) {
  TreeBuilder builder(text, depth);
  try {
    if (nlohmann::json::sax_parse(text, &builder)) return std::move(builder.root());
  } catch (const std::exception& problem) {
    return Error{ErrorCode::kSyntax, {}, "this is not valid JSON: " + std::string(problem.what()), {}};
  }
  return builder.error();
}

}  // namespace lissom
