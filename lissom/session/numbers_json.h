#pragma once
/// Reads numbers that this program has written, and remembers the first mistake.

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/core/types.h"

namespace lissom {

class JsonNumbers {
 public:
  using Json = nlohmann::ordered_json;
  JsonNumbers(const Json& json, std::string where) : json_(json), where_(std::move(where)) {}

  const Status& status() const { return status_; }

  double number(const char* key) {
    const Json* entry = find(key);
    if (entry == nullptr) return 0;
    if (!entry->is_number() || !std::isfinite(entry->get<double>())) return fail(key, "a finite number"), 0;
    return entry->get<double>();
  }
  int integer(const char* key) {
    const Json* entry = find(key);
    if (entry == nullptr) return 0;
    if (!entry->is_number_integer()) return fail(key, "a whole number"), 0;
    return entry->get<int>();
  }
  bool flag(const char* key) {
    const Json* entry = find(key);
    if (entry == nullptr) return false;
    if (!entry->is_boolean()) return fail(key, "true or false"), false;
    return entry->get<bool>();
  }
  std::string text(const char* key) {
    const Json* entry = find(key);
    if (entry == nullptr) return {};
    if (!entry->is_string()) return fail(key, "text"), std::string();
    return entry->get<std::string>();
  }
  VecX vector(const char* key) {
    const Json* entry = list(key);
    if (entry == nullptr) return {};
    VecX values(static_cast<Eigen::Index>(entry->size()));
    for (std::size_t i = 0; i < entry->size(); ++i) {
      const Json& value = (*entry)[i];
      if (!value.is_number() || !std::isfinite(value.get<double>())) return fail(key, "finite numbers"), VecX();
      values[static_cast<Eigen::Index>(i)] = value.get<double>();
    }
    return values;
  }
  /// Null after a mistake.
  const Json* list(const char* key) {
    const Json* entry = find(key);
    if (entry != nullptr && !entry->is_array()) return fail(key, "a list"), nullptr;
    return entry;
  }
  const Json* object(const char* key) {
    const Json* entry = find(key);
    if (entry != nullptr && !entry->is_object()) return fail(key, "an object"), nullptr;
    return entry;
  }
  void fail(const char* key, const std::string& expected) {
    if (!status_) return;
    status_ =
        Error{ErrorCode::kType, where_ + "/" + key, expected + " is expected here", "was the file edited or cut off?"};
  }

 private:
  const Json* find(const char* key) {
    if (!status_) return nullptr;
    const auto found = json_.find(key);
    if (json_.is_object() && found != json_.end()) return &*found;
    fail(key, "something");
    return nullptr;
  }

  const Json& json_;
  std::string where_;
  Status status_;
};

inline nlohmann::ordered_json number_list(const VecX& values) {
  return std::vector<double>(values.data(), values.data() + values.size());
}

}  // namespace lissom
