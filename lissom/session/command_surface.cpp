#include "lissom/session/command_surface.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "lissom/core/file_io.h"
#include "lissom/geometry/surface_file.h"
#include "lissom/session/output.h"

namespace lissom {

namespace {

using Json = nlohmann::ordered_json;

struct SurfaceWriter {
  std::string_view ending;
  std::string (*bytes)(const Surface& surface);
};
constexpr SurfaceWriter kWriters[] = {{".ply", write_surface_ply}, {".obj", write_surface_obj}};

/// What writes the output; null without an output.
Result<const SurfaceWriter*> writer_of(const SurfaceCommand& command) {
  if (command.output.empty()) return nullptr;
  std::error_code none;
  if (std::filesystem::equivalent(command.file, command.output, none)) {
    return Error{ErrorCode::kConflict, command.output.string(), "the output is the input", "name another file"};
  }
  for (const SurfaceWriter& writer : kWriters) {
    if (command.output.extension() == writer.ending) return &writer;
  }
  return Error{ErrorCode::kUnsupported, command.output.string(),
               fmt::format("surfaces are not written to files ending in \"{}\"", command.output.extension().string()),
               "known: .ply, .obj"};
}

Json list_of(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Json json_of(const SurfaceNote& note) {
  Json json;
  json["what"] = note.what;
  json["count"] = note.count;
  json["done"] = note.done;
  json["mended"] = note.outcome == SurfaceNote::Outcome::kMended;
  json["places"] = Json::array();
  for (const SurfaceNote::Place& place : note.places) {
    Json entry;
    entry["element"] = place.element;
    if (place.at) entry["at"] = list_of(*place.at);
    json["places"].push_back(std::move(entry));
  }
  return json;
}

std::string summary_of(const SurfaceReport& report, const std::filesystem::path& file) {
  const BroughtSurface& brought = report.brought;
  const SurfaceFacts& facts = brought.facts;
  Json json;
  json["file"] = file.string();
  json["format"] = brought.format;
  json["read"] = {{"vertices", brought.points}, {"triangles", brought.faces}};
  json["vertices"] = brought.surface.vertices.size();
  json["triangles"] = brought.surface.triangles.size();
  json["low"] = list_of(facts.low);
  json["high"] = list_of(facts.high);
  json["closed"] = facts.loops == 0;
  json["boundary_loops"] = facts.loops;
  json["longest_boundary"] = facts.longest_loop;
  json["genus"] = facts.genus;
  json["pieces"] = facts.pieces;
  json["area"] = facts.area;
  if (facts.loops == 0) json["volume"] = facts.volume;
  json["darkness"] = !brought.surface.darkness.empty();
  json["notes"] = Json::array();
  for (const SurfaceNote& note : brought.notes) json["notes"].push_back(json_of(note));
  json["files"] = Json::array();
  for (const std::filesystem::path& written : report.files) json["files"].push_back(written.string());
  // Names of files may be no UTF-8.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

Result<BroughtSurface> bring_surface(const std::filesystem::path& file, const SurfaceScale& scale,
                                     const SurfaceRepairOptions& options) {
  Result<RawSurface> raw = Error{};
  {
    const Result<std::string> bytes = read_file(file);
    if (!bytes) return bytes.error();
    raw = read_surface(bytes.value(), file.string());
  }
  if (!raw) return raw.error();
  Result<Surface> scaled = surface_in_metres(raw.value(), scale);
  if (!scaled) return scaled.error();
  Result<RepairedSurface> repaired = repair_surface(std::move(scaled).value(), options, file.string());
  if (!repaired) return repaired.error();
  BroughtSurface brought;
  brought.format = raw.value().format;
  brought.points = static_cast<int>(raw.value().points.size());
  brought.faces = static_cast<int>(raw.value().triangles.size());
  brought.notes = std::move(raw.value().notes);
  brought.surface = std::move(repaired.value().surface);
  brought.facts = surface_facts(brought.surface);
  for (SurfaceNote& note : repaired.value().notes) brought.notes.push_back(std::move(note));
  return brought;
}

Result<SurfaceReport> surface_command(const SurfaceCommand& command) {
  const Result<const SurfaceWriter*> writer = writer_of(command);
  if (!writer) return writer.error();
  Result<BroughtSurface> brought = bring_surface(command.file, command.scale, command.repair);
  if (!brought) return brought.error();
  SurfaceReport report{std::move(brought).value(), {}, {}};
  if (writer.value() != nullptr) {
    Output output(command.output.parent_path());
    const Status s = output.write(command.output.filename(), writer.value()->bytes(report.brought.surface));
    if (!s) return s.error();
    report.files = output.take_written();
  }
  report.summary = summary_of(report, command.file);
  return report;
}

}  // namespace lissom
