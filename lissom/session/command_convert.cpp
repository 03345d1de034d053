#include "lissom/session/command_convert.h"

#include <fmt/format.h>

#include "lissom/core/file_io.h"
#include "lissom/geometry/obj_lines.h"
#include "lissom/model/plan_dxf.h"
#include "lissom/model/plan_svg.h"
#include "lissom/session/output.h"
#include "lissom/session/shape_files.h"

namespace lissom {

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
  const Result<Drawing> drawing = draw(drawable, Shape::kDeformed);
  if (!drawing) return drawing.error();
  const ShapeToWrite shape{drawable.document.model, drawable.document.name, drawing.value(),
                           command.file.string(),   command.field,          command.obj};
  const Result<std::string> bytes = shape_file(command.file.extension().string(), shape);
  if (!bytes) return bytes.error();
  Output output(command.file.parent_path());
  return output.write(command.file.filename(), bytes.value());
}

}  // namespace lissom
