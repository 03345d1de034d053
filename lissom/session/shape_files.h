#pragma once
/// A shape, or its plan, as the files of other programs: one list, by their endings.

#include <string>
#include <string_view>
#include <vector>

#include "lissom/model/model.h"
#include "lissom/view/rod_drawing.h"

namespace lissom {

enum class ObjContent { kCentrelines, kSurfaces };

/// What is written.
struct ShapeToWrite {
  const Model& model;
  const std::string& name;  ///< of the document
  const Drawing& drawing;   ///< of the shape, with its fields
  std::string where;        ///< the file, for errors
  std::string field = {};   ///< colours of a PLY file; empty: none
  ObjContent obj = ObjContent::kCentrelines;
};

/// The bytes of a file with this ending: ".lissom", ".obj", ".vtu", ".vtp", ".ply"; of a plan ".svg" or ".dxf".
/// kUnsupported, with all endings, for others.
Result<std::string> shape_file(std::string_view ending, const ShapeToWrite& shape);

}  // namespace lissom
