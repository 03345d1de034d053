#include "lissom/editing/edit_reader.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "lissom/core/nearest_name.h"
#include "lissom/editing/people_units.h"
#include "lissom/model/json_value.h"
#include "lissom/model/limits.h"

namespace lissom {

namespace {

constexpr std::size_t kAny = static_cast<std::size_t>(-1);

std::string_view kind_of(const nlohmann::json& value) {
  switch (value.type()) {
    case nlohmann::json::value_t::null:
      return "nothing";
    case nlohmann::json::value_t::boolean:
      return "true or false";
    case nlohmann::json::value_t::string:
      return "text";
    case nlohmann::json::value_t::array:
      return "a list";
    case nlohmann::json::value_t::object:
      return "an object";
    default:
      return "a number";
  }
}

}  // namespace

std::string EditReader::at(std::string_view key) const { return where_ + "/" + pointer_step(key); }

void EditReader::fail_at(ErrorCode code, std::string where, std::string message, std::string hint) {
  if (!failed()) *status_ = Error{code, std::move(where), std::move(message), std::move(hint)};
}

void EditReader::fail(ErrorCode code, std::string_view key, std::string message, std::string hint) {
  fail_at(code, key.empty() ? where_ : at(key), std::move(message), std::move(hint));
}

void EditReader::wrong(const std::string& where, std::string_view expected, const Json& value) {
  fail_at(ErrorCode::kType, where, fmt::format("expected {}, got {}", expected, kind_of(value)));
}

void EditReader::only(std::span<const std::string_view> keys) {
  if (!json_->is_object()) return wrong(where_, "an object", *json_);
  for (const auto& [key, value] : json_->items()) {
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    const std::vector<std::string> known(keys.begin(), keys.end());
    return fail(ErrorCode::kUnknown, key, fmt::format("there is no field \"{}\" here", key), suggestion(key, known));
  }
}

const EditReader::Json* EditReader::find(std::string_view key) {
  if (failed()) return nullptr;
  if (!json_->is_object()) return wrong(where_, "an object", *json_), nullptr;
  const auto found = json_->find(std::string(key));
  if (found != json_->end()) return &*found;
  fail_at(ErrorCode::kType, where_, fmt::format("the field \"{}\" is missing", key), "give it");
  return nullptr;
}

std::vector<std::string> EditReader::point_names() const {
  std::vector<std::string> names;
  for (const PlanPoint& point : plan_->points) names.push_back(point.name);
  return names;
}

std::vector<std::string> EditReader::rod_names() const {
  std::vector<std::string> names;
  for (const PlanRod& rod : plan_->rods) names.push_back(rod.name);
  return names;
}

int EditReader::named(const Json& value, const std::string& where, const std::vector<std::string>& names,
                      const char* what) {
  if (failed()) return 0;
  if (!value.is_string()) return wrong(where, fmt::format("the name of a {}", what), value), 0;
  const auto found = std::find(names.begin(), names.end(), value.get_ref<const std::string&>());
  if (found != names.end()) return static_cast<int>(found - names.begin());
  const std::string name = value.get<std::string>();
  fail_at(ErrorCode::kUnknown, where, fmt::format("the plan has no {} named \"{}\"", what, name),
          suggestion(name, names));
  return 0;
}

std::vector<int> EditReader::list(const Json& value, const std::string& where, const std::vector<std::string>& names,
                                  const char* what, std::size_t least, std::size_t most) {
  std::vector<int> all;
  if (failed()) return all;
  if (!value.is_array()) return wrong(where, fmt::format("a list of names of {}s", what), value), all;
  if (value.size() < least || value.size() > most) {
    const std::string wanted = least == most ? std::to_string(least) : fmt::format("at least {}", least);
    fail_at(ErrorCode::kType, where, fmt::format("there are {} {}s here", value.size(), what), "name " + wanted);
  }
  for (std::size_t i = 0; i < value.size() && !failed(); ++i) {
    const std::string own = fmt::format("{}/{}", where, i);
    const int index = named(value[i], own, names, what);
    if (failed()) break;
    if (std::find(all.begin(), all.end(), index) != all.end()) {
      fail_at(ErrorCode::kConflict, own,
              fmt::format("the {} \"{}\" is named twice", what, names[static_cast<std::size_t>(index)]),
              "name it once");
    }
    all.push_back(index);
  }
  return all;
}

int EditReader::point(std::string_view key) {
  const Json* value = find(key);
  return value == nullptr ? 0 : named(*value, at(key), point_names(), "point");
}

int EditReader::rod(std::string_view key) {
  const Json* value = find(key);
  return value == nullptr ? 0 : named(*value, at(key), rod_names(), "rod");
}

std::vector<int> EditReader::points(std::string_view key, std::size_t least) {
  const Json* value = find(key);
  return value == nullptr ? std::vector<int>() : list(*value, at(key), point_names(), "point", least, kAny);
}

std::vector<int> EditReader::rods(std::string_view key, std::size_t least) {
  const Json* value = find(key);
  return value == nullptr ? std::vector<int>() : list(*value, at(key), rod_names(), "rod", least, kAny);
}

std::vector<std::vector<int>> EditReader::point_lists(std::string_view key, std::size_t least, std::size_t most) {
  std::vector<std::vector<int>> lists;
  const Json* value = find(key);
  if (value == nullptr) return lists;
  if (!value->is_array()) return wrong(at(key), "a list of lists of points", *value), lists;
  const std::vector<std::string> names = point_names();
  for (std::size_t i = 0; i < value->size() && !failed(); ++i) {
    lists.push_back(list((*value)[i], fmt::format("{}/{}", at(key), i), names, "point", least, most));
  }
  return lists;
}

double EditReader::finite(const Json& value, const std::string& where) {
  if (failed()) return 0;
  if (!value.is_number()) return wrong(where, "a number", value), 0;
  const double number = value.get<double>();
  if (std::isfinite(number)) return number;
  fail_at(ErrorCode::kRange, where, "this number is not finite", "give an ordinary number");
  return 0;
}

double EditReader::metres(const Json& value, const std::string& where) {
  const double mm = finite(value, where);
  if (failed()) return 0;
  const std::optional<double> m = metres_of(mm);
  if (m && std::abs(*m) <= kLargest) return *m;
  fail_at(ErrorCode::kRange, where, "this length is too small or too large", "it is taken as mm");
  return 0;
}

Vec2 EditReader::two(std::string_view key, double (EditReader::*read)(const Json&, const std::string&)) {
  const Json* value = find(key);
  if (value == nullptr) return Vec2::Zero();
  if (!value->is_array() || value->size() != 2) {
    fail(ErrorCode::kType, key, "expected two numbers", "write [x, y]");
    return Vec2::Zero();
  }
  const double x = (this->*read)((*value)[0], at(key) + "/0"), y = (this->*read)((*value)[1], at(key) + "/1");
  return {x, y};
}

Vec2 EditReader::place(std::string_view key) { return two(key, &EditReader::metres); }
Vec2 EditReader::pair(std::string_view key) { return two(key, &EditReader::finite); }

double EditReader::length(std::string_view key) {
  const Json* value = find(key);
  return value == nullptr ? 0 : metres(*value, at(key));
}

double EditReader::number(std::string_view key) {
  const Json* value = find(key);
  return value == nullptr ? 0 : finite(*value, at(key));
}

double EditReader::angle(std::string_view key) { return radians_of(number(key)); }

double EditReader::positive(std::string_view key) {
  const double value = number(key);
  if (!failed() && !(value > 0)) fail(ErrorCode::kRange, key, fmt::format("{:g} is not above zero", value));
  return value;
}

int EditReader::whole(std::string_view key) {
  const Json* value = find(key);
  if (value == nullptr) return 0;
  constexpr std::int64_t kMost = 1'000'000'000;
  if (!value->is_number_integer() || value->get<std::int64_t>() < -kMost || value->get<std::int64_t>() > kMost) {
    return wrong(at(key), "a whole number", *value), 0;
  }
  return value->get<int>();
}

bool EditReader::flag(std::string_view key) {
  const Json* value = find(key);
  if (value == nullptr) return false;
  if (!value->is_boolean()) return wrong(at(key), "true or false", *value), false;
  return value->get<bool>();
}

std::string EditReader::text(std::string_view key) {
  const Json* value = find(key);
  if (value == nullptr) return {};
  if (!value->is_string()) return wrong(at(key), "text", *value), std::string();
  return value->get<std::string>();
}

std::string EditReader::name(std::string_view key) {
  std::string all = text(key);
  constexpr std::size_t kLongest = 200;
  if (failed()) return all;
  if (all.empty() || all.size() > kLongest) {
    fail(ErrorCode::kType, key, all.empty() ? "the name is empty" : "the name is too long", "write a short name");
  }
  for (const char c : all) {
    if (static_cast<unsigned char>(c) >= ' ' && c != '\x7f') continue;
    fail(ErrorCode::kType, key, "a name has no line breaks and no other control characters", "write a short name");
  }
  return all;
}

std::size_t EditReader::choice(std::string_view key, std::span<const std::string_view> words) {
  const std::string word = text(key);
  if (failed()) return 0;
  const auto found = std::find(words.begin(), words.end(), word);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  fail(ErrorCode::kUnknown, key, fmt::format("\"{}\" is not known here", word),
       suggestion(word, std::vector<std::string>(words.begin(), words.end())));
  return 0;
}

std::vector<EditReader> EditReader::items(std::string_view key, std::size_t least) {
  std::vector<EditReader> all;
  const Json* value = find(key);
  if (value == nullptr) return all;
  if (!value->is_array()) return wrong(at(key), "a list", *value), all;
  if (value->size() < least) {
    fail(ErrorCode::kType, key, fmt::format("there are {} here", value->size()), fmt::format("give {}", least));
  }
  for (std::size_t i = 0; i < value->size(); ++i) {
    all.emplace_back((*value)[i], fmt::format("{}/{}", at(key), i), *plan_, *status_);
  }
  return all;
}

EditReader EditReader::object(std::string_view key) {
  const Json* value = find(key);
  return {value == nullptr ? *json_ : *value, at(key), *plan_, *status_};
}

std::optional<double> EditReader::optional_length(std::string_view key) {
  return has(key) ? std::optional(length(key)) : std::nullopt;
}
std::optional<double> EditReader::optional_angle(std::string_view key) {
  return has(key) ? std::optional(angle(key)) : std::nullopt;
}
std::optional<double> EditReader::optional_number(std::string_view key) {
  return has(key) ? std::optional(number(key)) : std::nullopt;
}
std::optional<std::string> EditReader::optional_name(std::string_view key) {
  return has(key) ? std::optional(name(key)) : std::nullopt;
}

}  // namespace lissom
