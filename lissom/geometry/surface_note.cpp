#include "lissom/geometry/surface_note.h"

#include <fmt/format.h>

namespace lissom {

namespace {

/// In mm, with no more digits than say where to look; no negative zero.
double shown_mm(double metres) {
  const double mm = 1000 * metres;
  return std::abs(mm) < 1e-9 ? 0 : mm;
}

}  // namespace

std::string in_millimetres(const Vec3& at) {
  return fmt::format("({:.5g}, {:.5g}, {:.5g}) mm", shown_mm(at.x()), shown_mm(at.y()), shown_mm(at.z()));
}

std::string size_in_millimetres(const Vec3& size) {
  return fmt::format("{:.4g} x {:.4g} x {:.4g} mm", shown_mm(size.x()), shown_mm(size.y()), shown_mm(size.z()));
}

std::string SurfaceNote::text() const {
  std::string line = fmt::format("{} {}: {}", count, what, done);
  for (std::size_t i = 0; i < places.size(); ++i) {
    line += i == 0 ? " (" : ", ";
    line += places[i].element;
    if (places[i].at) line += " at " + in_millimetres(*places[i].at);
  }
  if (places.empty()) return line;
  return line + (count > static_cast<int>(places.size()) ? ", ...)" : ")");
}

}  // namespace lissom
