#pragma once
/// The plan as the studio's page sees it: the event `plan` of docs/studio/protocol.md.

#include <nlohmann/json.hpp>

#include "lissom/model/model.h"

namespace lissom {

/// The fields of the event `plan` but for `event` and `revision`, mm and degrees. The model has a plan.
nlohmann::json plan_to_json(const Model& model);

/// The rods as lines, for small drawings: [[[x, y], ...], ...], mm. Ghosts are left out. Empty for a model without a plan.
nlohmann::json plan_lines_json(const Model& model);

}  // namespace lissom
