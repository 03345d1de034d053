#pragma once
/// The Sheet with what it is to reach: wanted shapes that other sheets take, and the stages of the thesis' chapter 5.

#include "lissom/core/context.h"
#include "lissom/core/result.h"
#include "lissom/model/model.h"

namespace lissom::scene_models {

enum class SheetTargets {
  kOtherRadii,  ///< of sheet_targets(): another sheet for each pose, which no single one can be
  kHidden,      ///< one sheet of the last stage's parameters, at random: it can be found
};

/// 392 radii of 1 to 5 mm and 588 coordinates of the rest shape. Radii first, at 2, 3 and 4 places of each rod, then both.
/// Soft pins adapt where no sheet can reach the targets.
Result<Model> sheet_with_brief(SheetTargets targets, const Context& context);

/// The same for the list of scenes.
Model sheet_design();

}  // namespace lissom::scene_models
