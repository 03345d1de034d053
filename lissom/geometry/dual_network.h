#pragma once
/// The dual of a decimated surface as a network of lines [thesis 5.4, dinosaur]: a joint at the centre of every triangle that
/// is left, a line between every two that share an edge.

#include "lissom/geometry/surface_network.h"

namespace lissom {

struct DualOptions {
  int triangles = 222;  ///< left of the surface, at least 4: as many joints inside
};

/// Lines to boundaries end in joints there, and lines run along boundaries. kRange at `where` for fewer than 4 triangles;
/// kGeometry for surfaces that cannot be decimated so far, with how far.
Result<SurfaceNetwork> dual_network(const Surface& surface, const DualOptions& options, const std::string& where);

}  // namespace lissom
