#include "lissom/model/import_network.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <set>
#include <utility>

#include "lissom/geometry/point_grid.h"

namespace lissom {

namespace {

constexpr double kMerge = 1e-6;  // of the size

/// The drawing with coinciding points merged and useless lines gone.
struct CleanLines {
  std::vector<Vec3> points;  ///< m
  std::vector<std::array<int, 2>> segments;
  std::vector<std::vector<int>> at_point;  ///< segments by point, ascending
};

Result<CleanLines> cleaned(const ObjLines& lines, double scale, ImportedNetwork& out) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  std::vector<char> used(lines.points.size(), 0);
  for (const auto& segment : lines.segments) {
    for (const int point : segment) {
      if (point < 0 || point >= static_cast<int>(used.size()) ||
          !lines.points[static_cast<size_t>(point)].allFinite()) {
        return Error{ErrorCode::kRange, "network", fmt::format("a line names point {}, which is not there", point + 1),
                     "number the points from 1 and give each three finite coordinates"};
      }
      const auto p = static_cast<size_t>(point);
      used[p] = 1;
      low = low.cwiseMin(lines.points[p] * scale);
      high = high.cwiseMax(lines.points[p] * scale);
    }
  }
  const double size = (high - low).norm();
  if (!(size > 0) || !std::isfinite(size)) {
    return Error{ErrorCode::kGeometry, "network", "the lines have no extent",
                 "check the file: all points are at one place"};
  }
  out.extent = high - low;
  PointGrid grid(kMerge * size, 1e-3 * size, lines.points.size());
  std::vector<int> merged(lines.points.size(), -1);
  int isolated = 0, doubled = 0;
  for (size_t i = 0; i < lines.points.size(); ++i) {
    isolated += !used[i];
    if (!used[i]) continue;
    const size_t before = grid.points().size();
    merged[i] = grid.insert(lines.points[i] * scale);
    doubled += grid.points().size() == before;
  }
  CleanLines clean;
  clean.points = grid.points();
  clean.at_point.resize(clean.points.size());
  std::set<std::pair<int, int>> seen;
  int empty = 0, repeated = 0;
  for (const auto& [from, to] : lines.segments) {
    const int a = merged[static_cast<size_t>(from)], b = merged[static_cast<size_t>(to)];
    if (a == b) {
      ++empty;
    } else if (!seen.insert(std::minmax(a, b)).second) {
      ++repeated;
    } else {
      clean.at_point[static_cast<size_t>(a)].push_back(static_cast<int>(clean.segments.size()));
      clean.at_point[static_cast<size_t>(b)].push_back(static_cast<int>(clean.segments.size()));
      clean.segments.push_back({a, b});
    }
  }
  const auto note = [&](int count, const char* text) {
    if (count > 0) out.notes.push_back(fmt::format("{} {}", count, text));
  };
  note(lines.ignored, "statements of the file were not read (faces, groups, materials)");
  note(isolated, "points belong to no line and were left out");
  note(doubled, "points lie where another one is and were merged with it");
  note(empty, "lines without length were left out");
  note(repeated, "lines that repeat another one were left out");
  if (clean.segments.empty()) {
    return Error{ErrorCode::kGeometry, "network", "no line has a length", "check the file and its unit"};
  }
  return clean;
}

/// Follows the drawing from segment to segment.
class Chains {
 public:
  Chains(const CleanLines& lines, const NetworkOptions& options)
      : lines_(lines), options_(options), taken_(lines.segments.size(), 0) {}

  std::vector<Polyline> all() {
    std::vector<Polyline> chains;
    for (int s = 0; s < static_cast<int>(lines_.segments.size()); ++s) {
      if (!taken_[static_cast<size_t>(s)]) chains.push_back(chain(s));
    }
    return chains;
  }

 private:
  /// The segment that continues `segment` through its end `point`, or -1.
  int next(int segment, int point) const {
    const std::vector<int>& here = lines_.at_point[static_cast<size_t>(point)];
    if (options_.rods == NetworkRods::kSegments || here.size() != 2) return -1;
    const int other = here[0] == segment ? here[1] : here[0];
    const Vec3 in = place(point) - place(far_end(segment, point)), out = place(far_end(other, point)) - place(point);
    return std::atan2(in.cross(out).norm(), in.dot(out)) <= options_.chain_angle ? other : -1;
  }

  int far_end(int segment, int point) const {
    const auto& [a, b] = lines_.segments[static_cast<size_t>(segment)];
    return a == point ? b : a;
  }

  const Vec3& place(int point) const { return lines_.points[static_cast<size_t>(point)]; }

  Polyline chain(int segment) {
    // Back to where the chain begins, in the direction of the line that comes first in the file; a ring ends where it began.
    const auto [first, second] = lines_.segments[static_cast<size_t>(segment)];
    int start_segment = segment, start = first;
    bool ring = false;
    for (int s = next(segment, first); s >= 0; s = next(s, start)) {
      ring = s == segment;
      if (ring) break;
      start = far_end(s, start);
      start_segment = s;
    }
    if (ring) {
      start_segment = segment;
      start = first;
    }
    Polyline line;
    line.closed = ring;
    line.points.push_back(place(start));
    int at = start;
    for (int s = start_segment; s >= 0 && !taken_[static_cast<size_t>(s)]; s = next(s, at)) {
      taken_[static_cast<size_t>(s)] = 1;
      at = far_end(s, at);
      line.points.push_back(place(at));
    }
    if (ring) line.points.pop_back();
    return line;
  }

  const CleanLines& lines_;
  const NetworkOptions& options_;
  std::vector<char> taken_;
};

}  // namespace

Result<ImportedNetwork> import_network(const ObjLines& lines, const NetworkOptions& options) {
  if (!(options.scale > 0) || !std::isfinite(options.scale)) {
    return Error{ErrorCode::kRange, "network", fmt::format("the unit of the file is {:g} m", options.scale),
                 "name a unit such as mm or m"};
  }
  if (options.edges_per_segment < 1) {
    return Error{ErrorCode::kRange, "network", fmt::format("{} edges per line", options.edges_per_segment),
                 "give at least 1"};
  }
  ImportedNetwork out;
  const Result<CleanLines> clean = cleaned(lines, options.scale, out);
  if (!clean) return clean.error();
  out.model.joint_kind = options.joint_kind;
  for (Polyline& line : Chains(clean.value(), options).all()) {
    Rod rod;
    rod.name = fmt::format("r{}", out.model.rods.size() + 1);
    rod.edges = options.edges_per_segment * static_cast<int>(line.points.size() - (line.closed ? 0 : 1));
    rod.curve = std::move(line);
    rod.material = options.material;
    rod.section = options.section;
    rod.axes = options.axes;
    out.model.rods.push_back(std::move(rod));
  }
  return out;
}

}  // namespace lissom
