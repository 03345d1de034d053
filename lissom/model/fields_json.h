#pragma once
/// One description per struct of the document, `describe(Fields&, T&)`, from which reading, writing and the JSON schema all
/// follow. A field names its key, the member, a codec (how a value looks in JSON) and one sentence for people.
///
/// A codec for a type T is a struct with
///   void read(Reader&, const JsonValue&, T&) const;   reports mistakes to the reader
///   JsonValue write(const T&) const;                  null: leave the key out
///   JsonValue schema(Schema&) const;

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lissom/core/nearest_name.h"
#include "lissom/model/json_value.h"
#include "lissom/model/units.h"

namespace lissom {

/// Units of bare numbers, one per Measure; absent where a number needs its unit.
struct UnitSettings {
  std::array<std::optional<Unit>, kMeasures> units;
  UnitSettings();
};

/// Where reading stands, and the first mistake that was met. After a mistake nothing more is read.
class Reader {
 public:
  explicit Reader(std::filesystem::path base) : folder(std::move(base)) {}

  bool failed() const { return error_.has_value(); }
  const Error& error() const { return *error_; }
  void fail(ErrorCode code, std::string message, std::string hint = {});
  /// The same for a mistake with a text but no place.
  void fail(Error error);
  /// "expected a list, got a number".
  void fail_kind(std::string_view expected, const JsonValue& got);
  std::string where() const;

  /// One step down the document for the life of the object.
  class Step {
   public:
    Step(Reader& reader, std::string_view key) : reader_(reader) { reader.path_.emplace_back(key); }
    Step(Reader& reader, std::size_t index) : reader_(reader) { reader.path_.push_back(std::to_string(index)); }
    ~Step() { reader_.path_.pop_back(); }
    Step(const Step&) = delete;
    Step& operator=(const Step&) = delete;

   private:
    Reader& reader_;
  };

  UnitSettings units;
  std::filesystem::path folder;  ///< of the document

 private:
  std::vector<std::string> path_;
  std::optional<Error> error_;
};

/// `title` as the name of a definition, which has to be a valid piece of a URI: spaces become underscores.
std::string definition_name(std::string_view title);

/// Definitions collected while the schema is written.
class Schema {
 public:
  /// {"$ref": "#/$defs/NAME"}; `make` is called the first time only, and may itself refer to NAME.
  template <class Make>
  JsonValue reference(const std::string& name, const Make& make) {
    if (!definitions_.find(name)) {
      const std::size_t place = definitions_.items.size();
      definitions_.set(name, {});
      JsonValue definition = make(*this);
      definitions_.items[place] = std::move(definition);
    }
    return JsonValue::object().set("$ref", JsonValue::string("#/$defs/" + name));
  }
  const JsonValue& definitions() const { return definitions_; }

 private:
  JsonValue definitions_ = JsonValue::object();
};

enum class Presence { kRequired, kOptional };
constexpr Presence kRequired = Presence::kRequired;
constexpr Presence kOptional = Presence::kOptional;

/// Visits the fields of one object, in one of three ways.
class Fields {
 public:
  /// Reads `object`, which has to outlive this.
  Fields(Reader& reader, const JsonValue& object) : reader_(&reader), source_(&object) {}
  /// Collects what is written.
  Fields() = default;
  /// Collects the schema; `defaults` is the written form of a default value.
  Fields(Schema& schema, const JsonValue& defaults) : schema_(&schema), source_(&defaults) {}

  template <class T, class Codec>
  Fields& field(std::string_view key, T& value, const Codec& codec, Presence presence, std::string_view text) {
    keys_.emplace_back(key);
    if (reader_) {
      if (const JsonValue* json = begin(key, presence, text)) {
        const Reader::Step step(*reader_, key);
        codec.read(*reader_, *json, value);
      }
    } else if (schema_) {
      add_schema(key, codec.schema(*schema_), presence, text);
    } else {
      add_written(key, codec.write(value), presence);
    }
    return *this;
  }

  template <class T, class Codec>
  Fields& field(std::string_view key, std::optional<T>& value, const Codec& codec, Presence presence,
                std::string_view text) {
    keys_.emplace_back(key);
    if (reader_) {
      if (const JsonValue* json = begin(key, presence, text)) {
        const Reader::Step step(*reader_, key);
        codec.read(*reader_, *json, value.emplace());
      }
    } else if (schema_) {
      add_schema(key, codec.schema(*schema_), presence, text);
    } else {
      add_written(key, value ? codec.write(*value) : JsonValue(), presence);
    }
    return *this;
  }

  /// After all fields, when reading: refuses unknown keys, then missing ones.
  void finish_reading(std::string_view title);
  /// After all fields, when writing: `defaults` (from a default value) are left out unless the field is required.
  JsonValue finish_writing(const JsonValue* defaults);
  JsonValue finish_schema(std::string_view title) const;

 private:
  const JsonValue* begin(std::string_view key, Presence presence, std::string_view text);
  void add_written(std::string_view key, JsonValue value, Presence presence);
  void add_schema(std::string_view key, JsonValue schema, Presence presence, std::string_view text);

  Reader* reader_ = nullptr;
  Schema* schema_ = nullptr;
  const JsonValue* source_ = nullptr;
  std::vector<std::string> keys_;
  std::string missing_, missing_text_;  ///< first required key that is absent, and its sentence
  std::vector<std::string> required_;
  JsonValue written_ = JsonValue::object();
};

/// An object whose fields `describe` lists. `title` names its schema and is what messages call it.
template <class T>
struct ObjectOf {
  std::string_view title;

  void read(Reader& reader, const JsonValue& json, T& value) const {
    if (!json.is(JsonValue::Kind::kObject)) return reader.fail_kind("an object {...}", json);
    Fields fields(reader, json);
    describe(fields, value);
    fields.finish_reading(title);
  }
  JsonValue write(const T& value) const {
    T copy = value, defaults{};
    Fields fields, default_fields;
    describe(default_fields, defaults);
    const JsonValue plain = default_fields.finish_writing(nullptr);
    describe(fields, copy);
    return fields.finish_writing(&plain);
  }
  JsonValue schema(Schema& schema) const {
    return schema.reference(definition_name(title), [this](Schema& inner) {
      T defaults{};
      Fields written;
      describe(written, defaults);
      const JsonValue plain = written.finish_writing(nullptr);
      Fields fields(inner, plain);
      T value{};
      describe(fields, value);
      return fields.finish_schema(title);
    });
  }
};

/// A type T that looks in JSON like another struct: `to_model(Reader&, const Entry&, T&)` and `Entry to_entry(const T&)`.
template <class T, class Entry>
struct ConvertedOf {
  std::string_view title;

  void read(Reader& reader, const JsonValue& json, T& value) const {
    Entry entry;
    ObjectOf<Entry>{title}.read(reader, json, entry);
    if (!reader.failed()) to_model(reader, entry, value);
  }
  JsonValue write(const T& value) const {
    Entry entry;
    to_entry(value, entry);
    return ObjectOf<Entry>{title}.write(entry);
  }
  JsonValue schema(Schema& schema) const { return ObjectOf<Entry>{title}.schema(schema); }
};

}  // namespace lissom
