#pragma once
/// The unit of a surface file, which the file itself does not tell.

#include "lissom/core/result.h"
#include "lissom/geometry/surface_file.h"

namespace lissom {

/// One of the two: what the numbers are in, or how large the surface is to be.
struct SurfaceScale {
  double unit = 0;  ///< m per unit of the file; 0: not said
  double size = 0;  ///< m, the largest extent of the box around the surface along an axis; 0: not said
};

/// Largest extents of surfaces that a unit alone is believed for; a size that is given is always believed.
constexpr double kSmallestSurface = 0.005, kLargestSurface = 5;  // m

/// The surface in metres. Without a unit and a size the error says how large it would be in each unit; a unit that
/// makes it smaller than kSmallestSurface or larger than kLargestSurface is refused with the units that would not.
Result<Surface> surface_in_metres(const RawSurface& raw, const SurfaceScale& scale);

}  // namespace lissom
