#pragma once
/// Remedies that are one click: an edit that is known at once, or a job that finds it.

#include <nlohmann/json.hpp>
#include <optional>

#include "lissom/core/result.h"
#include "lissom/session/warnings.h"

namespace lissom {

class Desk;

/// The edit that mends it; nothing where none is known, or where it has to be computed first.
std::optional<nlohmann::json> remedy_edit(const Warning& warning, const Model& model);

/// Whether take_remedy() does something about it.
bool has_remedy(const Warning& warning, const Model& model);

/// Takes the remedy, or starts the job `remedy`, which ends as one step of history.
Result<nlohmann::json> take_remedy(Desk& desk, const Warning& warning);

}  // namespace lissom
