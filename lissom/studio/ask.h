#pragma once
/// Reads the fields of a request, and remembers the first mistake.

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/core/types.h"

namespace lissom {

class Ask {
 public:
  /// `body`: an object, which has to outlive this.
  explicit Ask(const nlohmann::json& body) : body_(body) {}

  bool has(const char* key) const { return body_.contains(key); }
  std::string text(const char* key);
  std::optional<std::string> optional_text(const char* key);
  double number(const char* key);
  std::optional<double> optional_number(const char* key);
  /// A whole number of at least `least`.
  int integer(const char* key, int least);
  bool flag(const char* key);
  Vec3 vector(const char* key);
  std::vector<int> integers(const char* key);
  std::vector<std::string> texts(const char* key);
  const nlohmann::json& object(const char* key);
  /// Whatever is there; null where there is nothing.
  nlohmann::json value(const char* key) const;

  /// To be asked before what was read is used.
  const Status& status() const { return status_; }

 private:
  const nlohmann::json* find(const char* key, bool (nlohmann::json::*fits)() const noexcept, const char* expected);
  void fail(const char* key, ErrorCode code, const std::string& message, const std::string& hint);

  const nlohmann::json& body_;
  Status status_;
};

}  // namespace lissom
