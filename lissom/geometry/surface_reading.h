#pragma once
/// What the readers of surface files have in common: points, colours and polygons come in, a checked RawSurface goes
/// out.

#include <span>
#include <string>
#include <vector>

#include "lissom/geometry/surface_file.h"

namespace lissom {

class SurfaceReading {
 public:
  /// What the place of a point or polygon counts: "file:12", or "file, face 12".
  enum class Places { kLines, kElements };

  SurfaceReading(std::string file, std::string format, Places places);

  std::size_t points() const { return raw_.points.size(); }
  Status add_point(const Vec3& p, long long place);
  /// Colour of the point added last: 0 to 1 per channel, or 0 to 255; which of the two shows when all are known.
  void paint(const Vec3& rgb);
  /// Corners counted from 0; that they exist is checked in finish(), since files may name points that follow later.
  Status add_polygon(std::span<const long long> corners, long long place);
  /// Something that is read over.
  void leave_out(const std::string& what, const std::string& element);

  Error refuse(ErrorCode code, long long place, std::string message, std::string hint) const;
  Result<RawSurface> finish();

 private:
  Status check_corners(std::size_t polygon) const;
  void take_colours();

  RawSurface raw_;
  Places places_;
  std::vector<Vec3> colours_;  // by point, while every point has one
  double brightest_ = 0;
  std::vector<long long> corners_;
  std::vector<std::size_t> ends_;   // of the polygons in corners_
  std::vector<long long> origins_;  // places of the polygons
};

/// Splits a polygon with at least 3 corners into triangles that are appended.
void split_polygon(const std::vector<Vec3>& points, std::span<const int> corners,
                   std::vector<std::array<int, 3>>& triangles);

}  // namespace lissom
