#pragma once
/// Surfaces of objects that are to be printed as meshes of rods, drawn by formulas.

#include "lissom/core/result.h"
#include "lissom/geometry/surface.h"

namespace lissom::scene_models {

/// A hat with a brim, 0.23 m long and 0.2 m wide, open below; z up, front at +x.
Surface hat_surface();

/// A dinosaur on four legs, 0.21 m from the tip of the tail (-x) to the nose (+x), feet on z = 0.
Result<Surface> dinosaur_surface();

/// A sheet, 0.25 m wide, with a serious face painted on it in the x-y plane: dark eyes and a straight dark mouth.
Surface face_surface();

}  // namespace lissom::scene_models
