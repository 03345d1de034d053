#include "lissom/session/command_convert.h"

#include <fmt/format.h>

#include "lissom/core/file_io.h"
#include "lissom/geometry/obj_lines.h"
#include "lissom/model/document.h"
#include "lissom/model/plan_dxf.h"
#include "lissom/model/plan_svg.h"
#include "lissom/session/fields.h"
#include "lissom/session/output.h"
#include "lissom/view/mesh_export.h"
#include "lissom/view/vtk_export.h"

namespace lissom {

namespace {

struct Request {
  const Drawable& drawable;
  const ConvertCommand& command;
  const Drawing& drawing;
};

/// The lines of the plan, which has to be there.
Result<PlanDrawing> plan_lines(const Request& r) {
  const Model& model = r.drawable.document.model;
  if (model.plan) return drawing_of_plan(*model.plan);
  return Error{ErrorCode::kUnsupported, r.command.file.string(), "the document has no plan to draw",
               "write .obj for rods in space, or use `lissom draw` for a picture"};
}

/// One line per kind of file.
struct Writer {
  std::string_view ending;
  Result<std::string> (*bytes)(const Request&);
};
constexpr Writer kWriters[] = {
    {".lissom",
     [](const Request& r) -> Result<std::string> {
       return write_document(r.drawable.document.model, NetworkText::kRods);
     }},
    {".obj",
     [](const Request& r) {
       return r.command.obj == ObjContent::kSurfaces ? obj_surfaces(r.drawing) : obj_centrelines(r.drawing);
     }},
    {".vtu", [](const Request& r) { return vtu_bytes(r.drawing); }},
    {".vtp", [](const Request& r) { return vtp_bytes(r.drawing); }},
    {".svg",
     [](const Request& r) -> Result<std::string> {
       const Result<PlanDrawing> lines = plan_lines(r);
       if (!lines) return lines.error();
       return write_svg_drawing(lines.value(), r.drawable.document.name);
     }},
    {".dxf",
     [](const Request& r) -> Result<std::string> {
       const Result<PlanDrawing> lines = plan_lines(r);
       if (!lines) return lines.error();
       return write_dxf_drawing(lines.value());
     }},
    {".ply", [](const Request& r) { return ply_surfaces(r.drawing, {.field = r.command.field}); }},
};

}  // namespace

Result<Document> import_document(const std::filesystem::path& path, const NetworkOptions& options,
                                 std::vector<std::string>& notes) {
  const Result<std::string> text = read_file(path);
  if (!text) return text.error();
  const Result<ObjLines> lines = read_obj_lines(text.value(), path.string());
  if (!lines) return lines.error();
  Result<ImportedNetwork> network = import_network(lines.value(), options);
  if (!network) return network.error();
  const Vec3 size = 1000 * network.value().extent;
  notes = network.value().notes;
  notes.push_back(fmt::format("{} rods, {:.4g} x {:.4g} x {:.4g} mm", network.value().model.rods.size(), size.x(),
                              size.y(), size.z()));
  Document document{path.stem().string(), path.parent_path(), std::move(network.value().model)};
  if (document.model.title.empty()) document.model.title = document.name;
  if (const Status s = document.model.validate(); !s) return s.error();
  return document;
}

bool is_plan_drawing(const std::filesystem::path& path) {
  return path.extension() == ".svg" || path.extension() == ".dxf";
}

Result<Document> import_plan(const std::filesystem::path& path, const DrawingOptions& options,
                             std::vector<std::string>& notes) {
  const Result<std::string> text = read_file(path);
  if (!text) return text.error();
  const Result<PlanDrawing> drawing = path.extension() == ".svg" ? read_svg_drawing(text.value(), path.string())
                                                                 : read_dxf_drawing(text.value(), path.string());
  if (!drawing) return drawing.error();
  Result<Plan> plan = plan_from_drawing(drawing.value(), options, path.string(), notes);
  if (!plan) return plan.error();
  const DrawingFrame frame = frame_of(drawing.value());
  const Vec2 size = 1000 * (frame.high - frame.low);
  notes.push_back(fmt::format("{} rods through {} points, {:.4g} x {:.4g} mm", plan.value().rods.size(),
                              plan.value().points.size(), size.x(), size.y()));
  Document document{path.stem().string(), path.parent_path(), {}};
  document.model.title = document.name;
  document.model.plan = std::move(plan).value();
  if (const Status s = document.model.validate(); !s) return s.error();
  return document;
}

Status convert_command(const Drawable& drawable, const ConvertCommand& command) {
  const std::string ending = command.file.extension().string();
  for (const Writer& writer : kWriters) {
    if (writer.ending != ending) continue;
    const Result<Drawing> drawing = draw(drawable, Shape::kDeformed);
    if (!drawing) return drawing.error();
    Output output(command.file.parent_path());
    return output.write(command.file.filename(), writer.bytes({drawable, command, drawing.value()}));
  }
  std::string known;
  for (const Writer& writer : kWriters) known += (known.empty() ? "" : ", ") + std::string(writer.ending);
  return Error{ErrorCode::kUnsupported, command.file.string(),
               fmt::format("files ending in \"{}\" cannot be written", ending), "known: " + known};
}

}  // namespace lissom
