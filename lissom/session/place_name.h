#pragma once
/// Places as people type them: "tip" (a set), "beam:0.5", "beam:start", "joints", "boundary", "all".

#include <string>

#include "lissom/core/result.h"
#include "lissom/model/model.h"

namespace lissom {

Result<Selector> parse_place(const Model& model, const std::string& text, const std::string& where);

}  // namespace lissom
