#pragma once
/// All numbers of a design that parameters act on in a linear way, and a design with other ones: the inverse of
/// rest_input_values. Description and discretised structure change together, so that the description, discretised anew,
/// gives the same rest numbers to rounding.

#include <vector>

#include "lissom/core/result.h"
#include "lissom/design/design.h"

namespace lissom {

struct PoseValues {
  VecX loads;  ///< in the order of LoadNumbers
  VecX moves;  ///< m, of each support x, y, z
};

struct DesignValues {
  VecX inputs;  ///< in the order of RestInputs
  std::vector<PoseValues> poses;
};

DesignValues values_of(const Design& design);

/// Changes what differs and leaves the rest as it was:
///  - half-extents: profiles with two values to an edge, which meet the middle of every edge;
///  - places: rods become polylines with one direction per edge for their normals (redrawn.h);
///  - moduli: a material that no longer is that of all its rods or membranes gets a copy for each, "PLA of rod-1".
/// Targets of soft pins that follow the drawing are not set.
/// kUnsupported for numbers that the description has in one place for several; kGeometry where an edge would lose its length.
Result<Design> with_values(Design design, const DesignValues& values);

}  // namespace lissom
