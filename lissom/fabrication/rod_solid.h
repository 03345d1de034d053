#pragma once
/// Rods as one solid for printers: the union of their swept sections, with rounded valleys where they meet.

#include <string>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/core/result.h"
#include "lissom/geometry/surface.h"
#include "lissom/model/structure.h"

namespace lissom {

struct SolidOptions {
  double tolerance = 1e-4;  ///< m, between the surface and its triangles

  Status validate() const;
};

/// Of the rods of one material.
struct RodSolid {
  std::string material;
  Surface surface;       ///< m, closed, outwards, without self-intersections; parts that do not touch are allowed
  double volume = 0;     ///< m^3
  double tolerance = 0;  ///< m, reached: above the one asked for where triangles would have been too many
  double cell = 0;       ///< m, of the coarsest lattice: gaps that are narrower may be closed
  int parts = 0;         ///< connected ones; flakes that are smaller than a rod is thick are left out
  int tubes = 0;         ///< stretches where rods run alone and are rings of sections
  int joints = 0;        ///< places where rods are near each other, whose surface was looked for on a lattice
  int cavities = 0;      ///< closed ones that were filled
  int attempts = 1;      ///< above 1: the first surface had a fault, and was made another way
};

/// Drawn shapes of the rods of every material, in the order of their first rods. Tubes are taken as full: a printer prints
/// walls. Free ends are flat, at the drawn end; joints are round. Whatever is returned has passed check_solid; kGeometry with
/// the rod and the place where no way of making it did.
Result<std::vector<RodSolid>> rod_solids(const Structure& structure, const SolidOptions& options,
                                         const Context& context);

}  // namespace lissom
