#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>

#include "lissom/fabrication/exporters.h"
#include "lissom/fabrication/rod_solid.h"
#include "lissom/mechanics/membrane_strain.h"
#include "lissom/session/document_file.h"
#include "lissom/session/shape_files.h"
#include "lissom/studio/base64.h"
#include "lissom/studio/desk.h"
#include "lissom/studio/request_handlers.h"

namespace lissom {

namespace {

using Json = nlohmann::json;

constexpr double kPrintTolerance = 5e-5;  // m, of printed surfaces

/// The rods as they lie in the plan, which is how they are printed.
Result<std::string> flat_rods(Desk& desk, const Exporter& exporter) {
  const LiveDesign* design = desk.shape().design();
  Result<std::vector<RodSolid>> solids =
      rod_solids(design->system().structure, {.tolerance = kPrintTolerance}, Context{});
  if (!solids) return solids.error();
  Vec3 low = Vec3::Constant(INFINITY);
  for (const RodSolid& solid : solids.value()) {
    for (const Vec3& vertex : solid.surface.vertices) low = low.cwiseMin(vertex);
  }
  PrintObjects objects{desk.model().title, {}};
  for (RodSolid& solid : solids.value()) {
    for (Vec3& vertex : solid.surface.vertices) vertex -= low;
    objects.objects.push_back({solid.material, std::move(solid.surface)});
  }
  return exporter.bytes(objects);
}

Result<std::string> bytes_of(Desk& desk, const std::string& ending, const std::string& file) {
  const LiveDesign* design = desk.shape().design();
  if (design == nullptr)
    return Error{ErrorCode::kConflict, {}, "there is no shape to write", "let the plan settle first"};
  for (const Exporter& exporter : exporters()) {
    if (exporter.ending == ending) return flat_rods(desk, exporter);
  }
  const State& state = desk.shape().shown();
  const Pose& pose = design->model().poses[static_cast<std::size_t>(design->pose())];
  const double share = stretch_share(pose, state.load_factor);
  const Result<Drawing> drawing = draw_state({design->model(), design->system(), state, nullptr, share}, &pose);
  if (!drawing) return drawing.error();
  return shape_file(ending, {.model = desk.model(),
                             .name = desk.project().name,
                             .drawing = drawing.value(),
                             .where = file,
                             .field = desk.shape().fields().rods,
                             .obj = ObjContent::kSurfaces});
}

/// Name of a file to write: as asked for, or after the project.
std::string file_name(Desk& desk, const std::optional<std::string>& asked, const std::string& ending) {
  if (!asked) return file_name_part(desk.project().name) + ending;
  return asked->ends_with(ending) ? *asked : *asked + ending;
}

}  // namespace

Answer answer_export(Desk& desk, int page, Ask& ask) {
  (void)page;
  std::string format = ask.text("format");
  const std::optional<std::string> asked = ask.optional_text("file");
  if (!ask.status()) return ask.status().error();
  std::transform(format.begin(), format.end(), format.begin(), [](unsigned char c) { return std::tolower(c); });
  const std::string ending = "." + format, file = file_name(desk, asked, ending);
  const Result<std::string> bytes = bytes_of(desk, ending, file);
  if (!bytes) return bytes.error();
  if (Status s = desk.store().write(file, bytes.value()); !s) return s.error();
  return Json{{"file", file}, {"bytes", bytes.value().size()}};
}

Answer answer_picture(Desk& desk, int page, Ask& ask) {
  (void)page;
  const std::string text = ask.text("png_base64");
  const std::optional<std::string> asked = ask.optional_text("file");
  if (!ask.status()) return ask.status().error();
  if (!desk.has_document()) return Error{ErrorCode::kConflict, {}, "nothing is open", "open a design first"};
  const std::optional<std::string> bytes = from_base64(text);
  constexpr std::string_view kPng = "\x89PNG\r\n\x1a\n";
  if (!bytes || !bytes->starts_with(kPng)) {
    return Error{ErrorCode::kSyntax, "/png_base64", "this is no PNG picture", "send what the canvas gives"};
  }
  const std::string file = file_name(desk, asked, ".png");
  if (Status s = desk.store().write(file, *bytes); !s) return s.error();
  return Json{{"file", file}, {"bytes", bytes->size()}};
}

}  // namespace lissom
