#include "lissom/session/project_file.h"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>

#include "lissom/core/file_io.h"
#include "lissom/geometry/surface_file.h"
#include "lissom/geometry/surface_repair.h"
#include "lissom/geometry/surface_scale.h"
#include "lissom/model/document.h"
#include "lissom/model/rod_mesh_document.h"

namespace lissom {

namespace {

/// FNV-1a over everything that the project was read from.
class Hash {
 public:
  void add(std::string_view bytes) {
    for (const char c : bytes) value_ = (value_ ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  }
  std::string text() const { return fmt::format("{:016x}", value_); }

 private:
  std::uint64_t value_ = 14695981039346656037ULL;
};

Error at_place(Error error, const std::string& place) {
  error.where = error.where.empty() ? place : place + ": " + error.where;
  return error;
}

double extent(const std::vector<Vec3>& points) {
  Vec3 low = points.front(), high = low;
  for (const Vec3& x : points) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return (high - low).maxCoeff();
}

/// Fills the parts of a project that files hold.
class Loader {
 public:
  Loader(Project& project, Hash& hash) : project_(project), hash_(hash) {}

  Status surface() {
    const SurfaceBrief& brief = project_.description.surface;
    Result<RawSurface> raw = read(brief.file, "/surface/file");
    if (!raw) return raw.error();
    const SurfaceScale scale{brief.unit.value_or(0), brief.size.value_or(0)};
    Result<Surface> whole = surface_in_metres(raw.value(), scale);
    if (!whole) return at_place(whole.error(), "/surface");
    scale_ = extent(whole.value().vertices) / extent(raw.value().points);
    const std::vector<Vec3> before = whole.value().vertices;
    SurfaceRepairOptions options;
    if (brief.fill_holes) options.holes = SurfaceRepairOptions::Holes::kFill;
    if (brief.keep_largest) options.pieces = SurfaceRepairOptions::Pieces::kKeepLargest;
    Result<RepairedSurface> mended = repair_surface(std::move(whole).value(), options, brief.file);
    if (!mended) return at_place(mended.error(), "/surface");
    for (const SurfaceNote& note : raw.value().notes) project_.notes.push_back(brief.file + ": " + note.text());
    for (const SurfaceNote& note : mended.value().notes) project_.notes.push_back(brief.file + ": " + note.text());
    project_.files.surface = std::move(mended.value().surface);
    same_vertices_ = project_.files.surface.vertices == before;
    return {};
  }

  Status posed(const std::string& file, const std::string& where) {
    if (project_.files.posed.count(file) != 0) return {};
    Result<RawSurface> raw = read(file, where);
    if (!raw) return raw.error();
    const std::size_t wanted = project_.files.surface.vertices.size();
    if (!same_vertices_) {
      return Error{ErrorCode::kConflict, where,
                   "the surface was mended, so its vertices are not those of the posed one any more",
                   "mend the surface first (`lissom surface FILE --out MENDED`), pose the mended one"};
    }
    if (raw.value().points.size() != wanted) {
      return Error{ErrorCode::kConflict, where,
                   fmt::format("{} has {} vertices, the surface {}", file, raw.value().points.size(), wanted),
                   "posed surfaces have the vertices of the surface in the same order"};
    }
    std::vector<Vec3>& vertices = project_.files.posed[file];
    for (std::size_t v = 0; v < wanted; ++v) {
      vertices.push_back(scale_ * raw.value().points[v]);
      if (vertices.back().allFinite()) continue;
      return Error{ErrorCode::kRange, where, fmt::format("vertex {} of {} is not a place", v, file),
                   "write the file again"};
    }
    return {};
  }

  Status drawn(const DrawnTopology& topology) {
    const std::string where = "/topology/lines/file";
    const Result<std::string> text = bytes(topology.file, where);
    if (!text) return text.error();
    Result<ObjLines> lines = read_obj_lines(text.value(), topology.file);
    if (!lines) return at_place(lines.error(), where);
    for (Vec3& x : lines.value().points) x *= topology.unit.value_or(1e-3);
    project_.files.drawn = std::move(lines).value();
    return {};
  }

 private:
  Result<std::string> bytes(const std::string& file, const std::string& where) {
    Result<std::string> read = read_file_below(project_.folder, file);
    if (!read) return at_place(read.error(), where);
    hash_.add(read.value());
    return read;
  }
  Result<RawSurface> read(const std::string& file, const std::string& where) {
    const Result<std::string> text = bytes(file, where);
    if (!text) return text.error();
    Result<RawSurface> raw = read_surface(text.value(), file);
    if (!raw) return at_place(raw.error(), where);
    if (raw.value().points.empty()) {
      return Error{ErrorCode::kGeometry, where, file + " has no vertices", "is it the right file?"};
    }
    return raw;
  }

  Project& project_;
  Hash& hash_;
  double scale_ = 1;           // m per unit of the surface's file
  bool same_vertices_ = true;  // as in the surface's file
};

Status load(Project& project, Hash& hash) {
  Loader loader(project, hash);
  if (Status s = loader.surface(); !s) return s;
  for (std::size_t k = 0; k < project.description.poses.size(); ++k) {
    const std::string& mesh = project.description.poses[k].mesh;
    if (mesh.empty()) continue;
    if (Status s = loader.posed(mesh, fmt::format("/poses/{}/mesh", k)); !s) return s;
  }
  if (const auto* drawn = std::get_if<DrawnTopology>(&project.description.topology)) return loader.drawn(*drawn);
  return {};
}

}  // namespace

Result<Project> read_project_file(const std::filesystem::path& path) {
  const Result<std::string> text = read_file(path, kLargestDocument);
  if (!text) return text.error();
  Result<RodMeshProject> description = read_project(text.value());
  if (!description) return at_place(description.error(), path.string());
  Project project{path.stem().string(), path.parent_path(), std::move(description).value(), {}, {}, {}};
  Hash hash;
  hash.add(write_project(project.description));
  if (Status s = load(project, hash); !s) return at_place(s.error(), path.string());
  project.hash = hash.text();
  return project;
}

}  // namespace lissom
