#pragma once
/// From how rods should lie on a surface to the lines on which they do.

#include <optional>
#include <string>

#include "lissom/core/context.h"
#include "lissom/geometry/obj_lines.h"
#include "lissom/geometry/surface_network.h"
#include "lissom/model/rod_mesh.h"

namespace lissom {

/// `drawn` (m) for a topology of drawn lines. One connected network; errors at `where`.
Result<SurfaceNetwork> lay_out(const Surface& surface, const Topology& topology, const MeshRods& rods,
                               const std::optional<ObjLines>& drawn, const std::string& where, const Context& context);

}  // namespace lissom
