#pragma once
/// Whether a surface bounds a solid, so that printers can take it.

#include <string>

#include "lissom/core/context.h"
#include "lissom/core/types.h"
#include "lissom/geometry/surface.h"

namespace lissom {

struct SolidCheck {
  /// Empty, or what is wrong: "an edge has one triangle", "two triangles intersect", ...
  std::string problem;
  Vec3 place = Vec3::Zero();  ///< m, where
  double volume = 0;          ///< m^3
  int parts = 0;              ///< connected ones

  bool ok() const { return problem.empty(); }
};

/// Every edge has two triangles that run along it in opposite directions, the triangles at every vertex are one fan, no part
/// is inside out, and no two triangles intersect (with exact predicates).
SolidCheck check_solid(const Surface& surface, const Context& context);

/// Takes away parts that are inside out: the walls of closed cavities, which nobody could empty. Says how many.
int fill_cavities(Surface& surface);

/// Takes away parts of less than this volume (m^3). Says how many.
int drop_flakes(Surface& surface, double least);

}  // namespace lissom
