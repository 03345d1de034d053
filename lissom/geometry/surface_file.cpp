#include "lissom/geometry/surface_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <iterator>

namespace lissom {

namespace {

struct SurfaceFormat {
  std::string_view ending;
  Result<RawSurface> (*read)(std::string_view bytes, const std::string& file);
};
constexpr SurfaceFormat kFormats[] = {
    {".obj", read_surface_obj}, {".ply", read_surface_ply}, {".stl", read_surface_stl}, {".off", read_surface_off}};

std::string lower_ending(const std::string& file) {
  const std::size_t dot = file.find_last_of('.');
  std::string ending = dot == std::string::npos ? std::string() : file.substr(dot);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

/// Grey of a vertex, 0 (black) to 255.
int grey(double darkness) { return static_cast<int>(std::lround(255 * (1 - std::clamp(darkness, 0.0, 1.0)))); }

/// Little endian, whatever this machine is.
template <class Number>
void append(std::string& bytes, Number value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  constexpr std::uint16_t kOne = 1;
  if (reinterpret_cast<const char&>(kOne) == 0) std::reverse(std::begin(raw), std::end(raw));
  bytes.append(raw, sizeof value);
}

}  // namespace

Result<RawSurface> read_surface(std::string_view bytes, const std::string& file) {
  const std::string ending = lower_ending(file);
  std::string known;
  for (const SurfaceFormat& format : kFormats) {
    if (format.ending == ending) return format.read(bytes, file);
    known += (known.empty() ? "" : ", ") + std::string(format.ending);
  }
  return Error{ErrorCode::kUnsupported, file, fmt::format("surfaces are not read from files ending in \"{}\"", ending),
               "known: " + known};
}

std::string write_surface_ply(const Surface& surface) {
  const bool painted = !surface.darkness.empty();
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment millimetres\nelement "
      "vertex {}\nproperty double x\n"
      "property double y\nproperty double z\n{}element face {}\nproperty list "
      "uchar int vertex_indices\nend_header\n",
      surface.vertices.size(), painted ? "property uchar red\nproperty uchar green\nproperty uchar blue\n" : "",
      surface.triangles.size());
  bytes.reserve(bytes.size() + 27 * surface.vertices.size() + 13 * surface.triangles.size());
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    for (int i = 0; i < 3; ++i) append(bytes, 1000 * surface.vertices[v][i]);
    if (painted) bytes.append(3, static_cast<char>(grey(surface.darkness[v])));
  }
  for (const std::array<int, 3>& triangle : surface.triangles) {
    bytes += '\3';
    for (const int v : triangle) append(bytes, static_cast<std::int32_t>(v));
  }
  return bytes;
}

std::string write_surface_obj(const Surface& surface) {
  fmt::memory_buffer out;
  fmt::format_to(std::back_inserter(out), "# millimetres\n");
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    const Vec3 mm = 1000 * surface.vertices[v];
    fmt::format_to(std::back_inserter(out), "v {:.17g} {:.17g} {:.17g}", mm.x(), mm.y(), mm.z());
    if (!surface.darkness.empty()) {
      const double light = 1 - surface.darkness[v];
      fmt::format_to(std::back_inserter(out), " {0:.6g} {0:.6g} {0:.6g}", light);
    }
    fmt::format_to(std::back_inserter(out), "\n");
  }
  for (const auto& [a, b, c] : surface.triangles) {
    fmt::format_to(std::back_inserter(out), "f {} {} {}\n", a + 1, b + 1, c + 1);
  }
  return fmt::to_string(out);
}

}  // namespace lissom
