#include "lissom/model/element_map.h"

#include <cmath>
#include <fmt/format.h>

#include "lissom/model/limits.h"

namespace lissom {

Status check_element_map(const std::vector<double>& map, std::size_t elements, const ElementWords& element,
                         ZeroMultiplier zero, const std::string& where) {
  if (map.empty()) return {};
  if (map.size() != elements) {
    return Error{ErrorCode::kType, where,
                 fmt::format("the list has {} number{}, the mesh has {} {}", map.size(), map.size() == 1 ? "" : "s",
                             elements, elements == 1 ? element.one : element.many),
                 fmt::format("give one number for each {}, or leave the list out", element.one)};
  }
  for (std::size_t i = 0; i < map.size(); ++i) {
    const bool possible = std::isfinite(map[i]) && map[i] <= kLargest &&
                          (map[i] >= kSmallest || (zero == ZeroMultiplier::kAllowed && map[i] == 0));
    if (possible) continue;
    return Error{ErrorCode::kRange, fmt::format("{}/{}", where, i),
                 fmt::format("{} {} is multiplied by {:g}", element.one, i, map[i]),
                 zero == ZeroMultiplier::kAllowed ? "give zero or a positive number; 1 leaves the material as it is"
                                                  : "give a positive number; 1 leaves the material as it is"};
  }
  return {};
}

Status check_element_maps(const std::vector<double>& stiffness, const std::vector<double>& density,
                          std::size_t elements, const ElementWords& element, const std::string& where) {
  Status status = check_element_map(stiffness, elements, element, ZeroMultiplier::kRefused, where + "/stiffness");
  if (!status) return status;
  return check_element_map(density, elements, element, ZeroMultiplier::kAllowed, where + "/density");
}

}  // namespace lissom
