#pragma once
/// `surface`: a surface that somebody brings: read, measured, mended, written.

#include <filesystem>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/geometry/surface_repair.h"
#include "lissom/geometry/surface_scale.h"
#include "lissom/geometry/surface_topology.h"

namespace lissom {

struct BroughtSurface {
  std::string format;         ///< "OBJ", "binary STL", ...
  int points = 0, faces = 0;  ///< vertices and triangles as read
  Surface surface;            ///< mended
  SurfaceFacts facts;
  std::vector<SurfaceNote> notes;  ///< of the reader, then of the repair
};

/// Reads a file and mends what it holds: how every command gets its surface.
Result<BroughtSurface> bring_surface(const std::filesystem::path& file, const SurfaceScale& scale,
                                     const SurfaceRepairOptions& options);

struct SurfaceCommand {
  std::filesystem::path file;
  SurfaceScale scale;
  SurfaceRepairOptions repair;
  std::filesystem::path output;  ///< .ply or .obj, in mm; empty: nothing is written
};

struct SurfaceReport {
  BroughtSurface brought;
  std::vector<std::filesystem::path> files;  ///< written
  std::string summary;                       ///< JSON, one line
};

Result<SurfaceReport> surface_command(const SurfaceCommand& command);

}  // namespace lissom
