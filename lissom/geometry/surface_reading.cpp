#include "lissom/geometry/surface_reading.h"

#include <algorithm>
#include <fmt/format.h>

namespace lissom {

SurfaceReading::SurfaceReading(std::string file, std::string format, Places places) : places_(places) {
  raw_.file = std::move(file);
  raw_.format = std::move(format);
}

Error SurfaceReading::refuse(ErrorCode code, long long place, std::string message, std::string hint) const {
  const std::string where =
      places_ == Places::kLines ? fmt::format("{}:{}", raw_.file, place) : fmt::format("{}, face {}", raw_.file, place);
  return {code, where, std::move(message), std::move(hint)};
}

Status SurfaceReading::add_point(const Vec3& p, long long place) {
  if (raw_.points.size() >= static_cast<std::size_t>(kMostSurfaceVertices)) {
    return refuse(ErrorCode::kUnsupported, place,
                  fmt::format("the surface has more than {} vertices", kMostSurfaceVertices),
                  "make it coarser first; rods do not follow details this small");
  }
  raw_.points.push_back(p);
  return {};
}

void SurfaceReading::paint(const Vec3& rgb) {
  if (colours_.size() + 1 != raw_.points.size()) return;  // an earlier point has none
  colours_.push_back(rgb);
  brightest_ = std::max(brightest_, rgb.maxCoeff());
}

Status SurfaceReading::add_polygon(std::span<const long long> corners, long long place) {
  if (corners.size() < 3) {
    leave_out("polygons with fewer than 3 corners",
              fmt::format("{} {}", places_ == Places::kLines ? "line" : "face", place));
    return {};
  }
  if (corners.size() > kMostPolygonCorners) {
    return refuse(ErrorCode::kUnsupported, place, fmt::format("the polygon has {} corners", corners.size()),
                  fmt::format("split polygons with more than {} into triangles", kMostPolygonCorners));
  }
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  ends_.push_back(corners_.size());
  origins_.push_back(place);
  if (corners_.size() - 2 * ends_.size() <= static_cast<std::size_t>(kMostSurfaceTriangles)) return {};
  return refuse(ErrorCode::kUnsupported, place,
                fmt::format("the surface has more than {} triangles", kMostSurfaceTriangles),
                "make it coarser first; rods do not follow details this small");
}

void SurfaceReading::leave_out(const std::string& what, const std::string& element) {
  const auto known = std::find_if(raw_.notes.begin(), raw_.notes.end(), [&](const auto& n) { return n.what == what; });
  SurfaceNote& note = known == raw_.notes.end() ? raw_.notes.emplace_back() : *known;
  note.what = what;
  note.done = "left out";
  note.add(element);
}

Status SurfaceReading::check_corners(std::size_t polygon) const {
  const auto count = static_cast<long long>(raw_.points.size());
  for (std::size_t c = polygon == 0 ? 0 : ends_[polygon - 1]; c < ends_[polygon]; ++c) {
    if (corners_[c] >= 0 && corners_[c] < count) continue;
    const int first = raw_.format == "OBJ" ? 1 : 0;
    return refuse(ErrorCode::kRange, origins_[polygon],
                  fmt::format("there is no vertex {} among the {} vertices of the file", corners_[c] + first, count),
                  count == 0 ? "the file has no vertices; export the surface again"
                             : fmt::format("vertices are numbered from {} to {}; is the file cut off?", first,
                                           count - 1 + first));
  }
  return {};
}

void SurfaceReading::take_colours() {
  if (colours_.empty() || colours_.size() != raw_.points.size()) return;
  const double scale = brightest_ > 1 ? 1.0 / 255 : 1.0;
  raw_.darkness.reserve(colours_.size());
  for (const Vec3& c : colours_) {
    const double luma = scale * (0.2126 * c.x() + 0.7152 * c.y() + 0.0722 * c.z());
    raw_.darkness.push_back(luma >= 0 ? 1 - std::min(luma, 1.0) : 1.0);  // not a number: black
  }
}

Result<RawSurface> SurfaceReading::finish() {
  if (ends_.empty()) {
    return Error{ErrorCode::kSyntax, raw_.file,
                 fmt::format("the file has {} vertices but no faces", raw_.points.size()),
                 "export the surface as triangles or polygons; points and "
                 "lines alone are no surface"};
  }
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    if (Status s = check_corners(i); !s) return s.error();
  }
  SurfaceNote split{.what = "polygons with more than 3 corners", .places = {}, .done = "split into triangles"};
  std::vector<int> corners;
  raw_.triangles.reserve(corners_.size() - 2 * ends_.size());
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    corners.clear();
    for (std::size_t c = i == 0 ? 0 : ends_[i - 1]; c < ends_[i]; ++c) corners.push_back(static_cast<int>(corners_[c]));
    if (corners.size() > 3) ++split.count;
    split_polygon(raw_.points, corners, raw_.triangles);
  }
  if (split.count > 0) raw_.notes.push_back(split);
  take_colours();
  return std::move(raw_);
}

}  // namespace lissom
