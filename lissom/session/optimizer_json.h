#pragma once
/// The memory of an inverse design between its iterations as JSON, complete and exact: a run that goes on from it ends with
/// the same bytes.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lissom/core/result.h"
#include "lissom/design/augmented_lagrangian.h"

namespace lissom {

nlohmann::ordered_json effort_to_json(const DesignEffort& effort);

nlohmann::ordered_json record_to_json(const DesignRecord& record);
Result<DesignRecord> record_from_json(const nlohmann::ordered_json& json, const std::string& where);

/// Without constraints the multipliers are an empty list.
nlohmann::ordered_json descent_to_json(const ConstrainedState& state);

/// kType, with `where` + "/cap" and the like, for what is missing or of the wrong kind.
Result<ConstrainedState> descent_from_json(const nlohmann::ordered_json& json, const std::string& where);

}  // namespace lissom
