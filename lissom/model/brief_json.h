#pragma once
/// Codecs that the two files of the "design" section share.

#include <array>
#include <string>
#include <vector>

#include "lissom/model/codecs_json.h"
#include "lissom/model/entries_json.h"

namespace lissom {

/// {"radii": {...}, ...}: one kind of parameter.
struct ParameterBriefOf {
  void read(Reader& reader, const JsonValue& json, ParameterBrief& parameter) const;
  JsonValue write(const ParameterBrief& parameter) const;
  JsonValue schema(Schema& schema) const;
};

/// {"positions": {...}, ...}: one kind of goal.
struct GoalBriefOf {
  void read(Reader& reader, const JsonValue& json, GoalBrief& goal) const;
  JsonValue write(const GoalBrief& goal) const;
  JsonValue schema(Schema& schema) const;
};

/// Fails unless exactly one of these keys was given.
inline bool exactly_one(Reader& reader, std::initializer_list<std::pair<const char*, bool>> keys, const char* what) {
  std::string all, given;
  int count = 0;
  for (const auto& [key, present] : keys) {
    all += (all.empty() ? "\"" : ", \"") + std::string(key) + "\"";
    if (!present) continue;
    given += (given.empty() ? "\"" : " and \"") + std::string(key) + "\"";
    ++count;
  }
  if (count > 1) reader.fail(ErrorCode::kConflict, given + " are both given", "keep one of them");
  if (count == 0) reader.fail(ErrorCode::kType, std::string(what) + " is missing", "give one of " + all);
  return count == 1;
}

}  // namespace lissom
