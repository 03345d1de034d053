#pragma once
/// A shape as text, for the next session: the document that its mesh was made from, and the state.

#include <optional>
#include <string>
#include <string_view>

#include "lissom/studio/live_shape.h"

namespace lissom {

/// Empty where there is no shape.
std::string write_kept_state(const ShapeSnapshot& shape);

/// Nothing where the text is empty or no longer makes sense: the plan is then released anew.
std::optional<ShapeSnapshot> read_kept_state(std::string_view text);

}  // namespace lissom
