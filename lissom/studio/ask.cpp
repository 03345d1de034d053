#include "lissom/studio/ask.h"

#include <cmath>
#include <limits>

namespace lissom {

namespace {

using Json = nlohmann::json;

}  // namespace

void Ask::fail(const char* key, ErrorCode code, const std::string& message, const std::string& hint) {
  if (status_) status_ = Error{code, std::string("/") + key, message, hint};
}

const Json* Ask::find(const char* key, bool (Json::*fits)() const noexcept, const char* expected) {
  const auto found = body_.find(key);
  if (found == body_.end()) {
    fail(key, ErrorCode::kUnknown, "the request lacks this field", std::string("give ") + expected);
    return nullptr;
  }
  if ((*found.*fits)()) return &*found;
  fail(key, ErrorCode::kType, std::string("expected ") + expected, "see docs/studio/protocol.md");
  return nullptr;
}

std::string Ask::text(const char* key) {
  const Json* found = find(key, &Json::is_string, "a text");
  return found != nullptr ? found->get<std::string>() : std::string();
}

std::optional<std::string> Ask::optional_text(const char* key) {
  if (!has(key)) return std::nullopt;
  return text(key);
}

double Ask::number(const char* key) {
  const Json* found = find(key, &Json::is_number, "a number");
  const double value = found != nullptr ? found->get<double>() : 0;
  if (!std::isfinite(value)) fail(key, ErrorCode::kRange, "the number is not finite", "give a finite number");
  return value;
}

std::optional<double> Ask::optional_number(const char* key) {
  if (!has(key)) return std::nullopt;
  return number(key);
}

int Ask::integer(const char* key, int least) {
  const Json* found = find(key, &Json::is_number_integer, "a whole number");
  if (found == nullptr) return least;
  const auto value = found->get<std::int64_t>();
  if (value >= least && value <= std::numeric_limits<int>::max()) return static_cast<int>(value);
  fail(key, ErrorCode::kRange, "the number is out of range",
       "give a whole number of at least " + std::to_string(least));
  return least;
}

bool Ask::flag(const char* key) {
  const Json* found = find(key, &Json::is_boolean, "true or false");
  return found != nullptr && found->get<bool>();
}

Vec3 Ask::vector(const char* key) {
  const Json* found = find(key, &Json::is_array, "three numbers");
  Vec3 value = Vec3::Zero();
  if (found == nullptr) return value;
  if (found->size() != 3) fail(key, ErrorCode::kType, "expected three numbers", "give x, y and z");
  for (std::size_t i = 0; i < 3 && i < found->size(); ++i) {
    const Json& entry = (*found)[i];
    const double number = entry.is_number() ? entry.get<double>() : NAN;
    if (!std::isfinite(number)) fail(key, ErrorCode::kType, "expected three finite numbers", "give x, y and z");
    value[static_cast<Eigen::Index>(i)] = std::isfinite(number) ? number : 0;
  }
  return value;
}

std::vector<int> Ask::integers(const char* key) {
  const Json* found = find(key, &Json::is_array, "a list of whole numbers");
  std::vector<int> values;
  if (found == nullptr) return values;
  for (const Json& entry : *found) {
    const bool whole = entry.is_number_integer() && entry.get<std::int64_t>() >= 0 &&
                       entry.get<std::int64_t>() <= std::numeric_limits<int>::max();
    if (!whole)
      return fail(key, ErrorCode::kType, "expected whole numbers from 0 on", "name nodes by their numbers"), values;
    values.push_back(entry.get<int>());
  }
  return values;
}

std::vector<std::string> Ask::texts(const char* key) {
  const Json* found = find(key, &Json::is_array, "a list of texts");
  std::vector<std::string> values;
  if (found == nullptr) return values;
  for (const Json& entry : *found) {
    if (!entry.is_string()) return fail(key, ErrorCode::kType, "expected texts", "give names"), values;
    values.push_back(entry.get<std::string>());
  }
  return values;
}

Json Ask::value(const char* key) const { return has(key) ? body_[key] : Json(); }

const Json& Ask::object(const char* key) {
  static const Json nothing = Json::object();
  const Json* found = find(key, &Json::is_object, "an object");
  return found != nullptr ? *found : nothing;
}

}  // namespace lissom
