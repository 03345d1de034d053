#pragma once
/// PLY and OBJ files in millimetres.

#include <optional>
#include <string>

#include "lissom/core/result.h"
#include "lissom/view/color_map.h"
#include "lissom/view/rod_drawing.h"

namespace lissom {

struct PlyOptions {
  int sides = 24;                        ///< around ellipses and tubes, even, 4 to 512
  std::string field = {};                ///< its colours at the vertices; empty: no colours
  std::optional<ColorRange> range = {};  ///< as stored (SI); absent: fits the field
};

/// Centrelines: one object with one `l` element per rod, then one with the triangles of each membrane. Points that rods
/// and membranes share are written once.
Result<std::string> obj_centrelines(const Drawing& drawing);

/// Closed surfaces, one object per rod, then the open one of each membrane. `sides` as in PlyOptions.
Result<std::string> obj_surfaces(const Drawing& drawing, int sides = 24);

/// The same surfaces with the colour of a field at every vertex.
Result<std::string> ply_surfaces(const Drawing& drawing, const PlyOptions& options = {});

}  // namespace lissom
