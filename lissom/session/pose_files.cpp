#include "lissom/session/pose_files.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "lissom/core/nearest_name.h"
#include "lissom/model/limits.h"

namespace lissom {

Result<std::vector<int>> pose_numbers(const Model& model, const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const Pose& pose : model.poses) known.push_back(pose.name);
  std::vector<int> numbers;
  for (const std::string& name : names) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) {
      return Error{ErrorCode::kUnknown, "--pose", "there is no pose \"" + name + "\"", suggestion(name, known)};
    }
    numbers.push_back(static_cast<int>(found - known.begin()));
  }
  if (names.empty()) {
    for (int i = 0; i < static_cast<int>(known.size()); ++i) numbers.push_back(i);
  }
  if (!numbers.empty()) return numbers;
  return Error{ErrorCode::kConflict, "/poses", "the document has no pose, so there is nothing to solve",
               "add one that says what is held and loaded"};
}

Status check_load_factor(double factor, const std::string& option) {
  if (std::abs(factor) <= kLargest) return {};
  return Error{ErrorCode::kRange, option, fmt::format("the load factor is {:g}", factor),
               "give a number such as 1: it multiplies loads and prescribed motions"};
}

std::vector<std::string> pose_file_names(const Document& document) {
  std::vector<std::string> names;
  for (const Pose& pose : document.model.poses) {
    const std::string plain = file_name_part(document.name + "-" + pose.name);
    std::string name = plain;
    for (int i = 2; std::find(names.begin(), names.end(), name) != names.end(); ++i)
      name = plain + "-" + std::to_string(i);
    names.push_back(name);
  }
  return names;
}

}  // namespace lissom
