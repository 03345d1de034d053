#pragma once
/// `convert`: between documents, line networks, drawings of plans, and the files of other programs.

#include <filesystem>
#include <string>
#include <vector>

#include "lissom/model/import_network.h"
#include "lissom/model/plan_drawing.h"
#include "lissom/session/drawable.h"
#include "lissom/session/shape_files.h"

namespace lissom {

struct ConvertCommand {
  ObjContent obj = ObjContent::kCentrelines;  ///< of an OBJ file that is written
  std::string field;                          ///< colours of a PLY file; empty: none
  std::filesystem::path file;                 ///< .lissom, .obj, .vtu, .vtp, .ply; of a plan .svg or .dxf
};

/// The line network of an OBJ file as a document; notes say what was left out of it, and how large it is.
Result<Document> import_document(const std::filesystem::path& path, const NetworkOptions& options,
                                 std::vector<std::string>& notes);

/// Whether a file is a drawing of a plan by its ending: .svg or .dxf.
bool is_plan_drawing(const std::filesystem::path& path);

/// The plan that an SVG or DXF drawing shows as a document; notes say what was left out of it, and how large it is.
Result<Document> import_plan(const std::filesystem::path& path, const DrawingOptions& options,
                             std::vector<std::string>& notes);

Status convert_command(const Drawable& drawable, const ConvertCommand& command);

}  // namespace lissom
