#pragma once
/// What a document says about points and rods of its plan by name, after an edit has renamed, cut, joined or removed some.

#include "lissom/editing/edits_json.h"

namespace lissom {

/// Renames what selections, constraints, loads, designs and expectations name, as `outcome.names` says. A rod that was cut is
/// named by its parts, a place on it by the part that has it. What named nothing but what is gone goes too, and a note says
/// so. `before`: the model before the edit, which has a plan and is valid.
void keep_references(const Model& before, EditOutcome& outcome);

}  // namespace lissom
