#pragma once
/// The lines of a network on a surface as rods: evenly sampled, with normals from the surface [thesis 5.4].

#include <vector>

#include "lissom/geometry/surface_network.h"
#include "lissom/model/model.h"
#include "lissom/model/rod_mesh.h"

namespace lissom {

struct SurfaceRods {
  std::vector<Rod> rods;                          ///< "rod 1", ..., one per line
  std::vector<std::vector<SurfacePlace>> places;  ///< per rod and node: where on the surface it lies
};

SurfaceRods rods_on_surface(const Surface& surface, const SurfaceNetwork& network, const MeshRods& rods);

}  // namespace lissom
