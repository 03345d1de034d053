#include "lissom/session/shape_files.h"

#include <fmt/format.h>

#include "lissom/model/document.h"
#include "lissom/model/plan_drawing.h"
#include "lissom/model/plan_dxf.h"
#include "lissom/model/plan_svg.h"
#include "lissom/view/mesh_export.h"
#include "lissom/view/vtk_export.h"

namespace lissom {

namespace {

/// The lines of the plan, which has to be there.
Result<PlanDrawing> plan_lines(const ShapeToWrite& shape) {
  if (shape.model.plan) return drawing_of_plan(*shape.model.plan);
  return Error{ErrorCode::kUnsupported, shape.where, "the document has no plan to draw",
               "write .obj for rods in space, or use `lissom draw` for a picture"};
}

/// One line per kind of file.
struct Writer {
  std::string_view ending;
  Result<std::string> (*bytes)(const ShapeToWrite&);
};
constexpr Writer kWriters[] = {
    {".lissom",
     [](const ShapeToWrite& s) -> Result<std::string> { return write_document(s.model, NetworkText::kRods); }},
    {".obj",
     [](const ShapeToWrite& s) {
       return s.obj == ObjContent::kSurfaces ? obj_surfaces(s.drawing) : obj_centrelines(s.drawing);
     }},
    {".vtu", [](const ShapeToWrite& s) { return vtu_bytes(s.drawing); }},
    {".vtp", [](const ShapeToWrite& s) { return vtp_bytes(s.drawing); }},
    {".svg",
     [](const ShapeToWrite& s) -> Result<std::string> {
       const Result<PlanDrawing> lines = plan_lines(s);
       if (!lines) return lines.error();
       return write_svg_drawing(lines.value(), s.name);
     }},
    {".dxf",
     [](const ShapeToWrite& s) -> Result<std::string> {
       const Result<PlanDrawing> lines = plan_lines(s);
       if (!lines) return lines.error();
       return write_dxf_drawing(lines.value());
     }},
    {".ply", [](const ShapeToWrite& s) { return ply_surfaces(s.drawing, {.field = s.field}); }},
};

}  // namespace

Result<std::string> shape_file(std::string_view ending, const ShapeToWrite& shape) {
  std::string known;
  for (const Writer& writer : kWriters) {
    if (writer.ending == ending) return writer.bytes(shape);
    known += (known.empty() ? "" : ", ") + std::string(writer.ending);
  }
  return Error{ErrorCode::kUnsupported, shape.where, fmt::format("files ending in \"{}\" cannot be written", ending),
               "known: " + known};
}

}  // namespace lissom
