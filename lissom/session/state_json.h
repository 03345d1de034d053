#pragma once
/// A state as JSON, complete and exact: lists of numbers in the order of the structure.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lissom/core/result.h"
#include "lissom/mechanics/state.h"

namespace lissom {

nlohmann::ordered_json state_to_json(const State& state);

/// Refuses missing lists, lists of unequal length and numbers that are not finite.
Result<State> state_from_json(const nlohmann::ordered_json& json, const std::string& where);

}  // namespace lissom
