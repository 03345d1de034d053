#pragma once
/// PLY and OBJ files in millimetres.

#include <optional>
#include <string>

#include "lissom/core/result.h"
#include "lissom/view/color_map.h"
#include "lissom/view/rod_drawing.h"

namespace lissom {

struct SurfaceExportOptions {
  int sides = 24;                   ///< around ellipses and tubes, even, 4 to 512
  std::string field;                ///< colours of PLY vertices; empty: none
  std::optional<ColorRange> range;  ///< as stored (SI); absent: fits the field

  Status validate() const;
};

/// Centrelines: one object with one `l` element per rod. Points that rods share are written once.
Result<std::string> obj_centrelines(const Drawing& drawing);

/// Closed surfaces, one object per rod.
Result<std::string> obj_surfaces(const Drawing& drawing, const SurfaceExportOptions& options = {});

/// Closed surfaces with the colour of a field at every vertex.
Result<std::string> ply_surfaces(const Drawing& drawing, const SurfaceExportOptions& options = {});

}  // namespace lissom
