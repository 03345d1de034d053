#pragma once
/// The list of objectives, for help, schemas and documents.

#include <span>
#include <string_view>

namespace lissom {

struct ObjectiveInfo {
  std::string_view name;     ///< Objective::name
  std::string_view unit;     ///< SI, Objective::unit
  std::string_view meaning;  ///< one sentence
};

std::span<const ObjectiveInfo> objectives();

/// Of this name, or null.
const ObjectiveInfo* find_objective(std::string_view name);

}  // namespace lissom
