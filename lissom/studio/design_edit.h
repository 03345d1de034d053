#pragma once
/// What tools have found as an edit, so that histories can be read and replayed.

#include <nlohmann/json.hpp>
#include <string>

#include "lissom/model/model.h"

namespace lissom {

/// `set_design` with all points and the pre-stretch of a model with a plan.
nlohmann::json design_edit(const Model& model, const std::string& title);

}  // namespace lissom
