#include "lissom/geometry/surface_scale.h"

#include <cmath>
#include <fmt/format.h>

namespace lissom {

namespace {

struct KnownUnit {
  const char* name;
  double metres;
};
constexpr KnownUnit kUnits[] = {{"mm", 0.001}, {"cm", 0.01}, {"m", 1}, {"in", 0.0254}};

bool plausible(double size) { return size >= kSmallestSurface && size <= kLargestSurface; }

/// Largest side of the box around the corners of the triangles, in the unit of the file.
double largest_extent(const RawSurface& raw) {
  Eigen::AlignedBox3d box;
  for (const std::array<int, 3>& triangle : raw.triangles) {
    for (const int v : triangle) {
      if (raw.points[v].allFinite()) box.extend(raw.points[v]);
    }
  }
  return box.isEmpty() ? 0 : box.sizes().maxCoeff();
}

std::string shown_length(double metres) {
  return metres < 1 ? fmt::format("{:.4g} mm", 1000 * metres) : fmt::format("{:.4g} m", metres);
}

/// "230 mm in mm, 2.3 m in cm, ...".
std::string sizes_by_unit(double extent) {
  std::string text;
  for (const KnownUnit& unit : kUnits) {
    text += fmt::format("{}{} in {}", text.empty() ? "" : ", ", shown_length(extent * unit.metres), unit.name);
  }
  return text;
}

/// "--unit mm or --unit in"; empty when no unit makes sense.
std::string plausible_units(double extent) {
  std::string text;
  for (const KnownUnit& unit : kUnits) {
    if (plausible(extent * unit.metres)) text += fmt::format("{}--unit {}", text.empty() ? "" : " or ", unit.name);
  }
  return text;
}

Result<double> factor_of(const RawSurface& raw, const SurfaceScale& scale, double extent) {
  if (scale.unit > 0 && scale.size > 0) {
    return Error{ErrorCode::kConflict, raw.file, "a unit and a size are given", "leave out --unit or --size"};
  }
  if (scale.size > 0) return scale.size / extent;
  const std::string units = plausible_units(extent);
  const std::string hint =
      units.empty() ? "say how large it is: --size \"230 mm\""
                    : "say what the numbers are in, likely " + units + ", or how large it is: --size \"230 mm\"";
  if (scale.unit <= 0) {
    return Error{ErrorCode::kUnit, raw.file,
                 fmt::format("the file does not say its unit; the surface would be {} across", sizes_by_unit(extent)),
                 hint};
  }
  if (plausible(extent * scale.unit)) return scale.unit;
  return Error{
      ErrorCode::kUnit, raw.file,
      fmt::format("in this unit the surface is {} across, which is hardly meant", shown_length(extent * scale.unit)),
      hint};
}

}  // namespace

Result<Surface> surface_in_metres(const RawSurface& raw, const SurfaceScale& scale) {
  const double extent = largest_extent(raw);
  if (!std::isfinite(extent) || extent > 1e150 || !(extent > 1e-150)) {
    return Error{ErrorCode::kRange, raw.file,
                 extent > 0 ? "the coordinates are too large or too small to compute with"
                            : "all corners of the surface are in one place",
                 "the file is damaged; export the surface again"};
  }
  const Result<double> factor = factor_of(raw, scale, extent);
  if (!factor) return factor.error();
  Surface surface;
  surface.vertices.reserve(raw.points.size());
  for (const Vec3& p : raw.points) surface.vertices.push_back(factor.value() * p);
  surface.triangles = raw.triangles;
  surface.darkness = raw.darkness;
  return surface;
}

}  // namespace lissom
