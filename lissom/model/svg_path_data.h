#pragma once
/// The little languages inside SVG attributes: path data, lists of numbers, transforms, lengths [SVG 1.1, 2].

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/geometry/planar_path.h"

namespace lissom {

using PlanarTransform = Eigen::Affine2d;

/// One of the parts of a path, from one M to the next.
struct SubPath {
  PlanarPath path;
  bool closed = false;
};

/// Path data in the coordinates that they are written in: M L H V C S Q T A Z and their small letters. Errors have no
/// place.
Result<std::vector<SubPath>> read_path_data(std::string_view text);

/// Numbers separated by commas or white space; stops at the first thing that is none.
std::vector<double> read_numbers(std::string_view text);

/// matrix, translate, scale, rotate, skewX, skewY in a row. Errors have no place.
Result<PlanarTransform> read_transform(std::string_view text);

/// A length in pixels of 1/96 inch: "12", "12px", "3mm", "1cm", "1in", "4pt", "1pc"; empty for others ("50%").
std::optional<double> read_length(std::string_view text);

/// The path with every point moved; arcs stay arcs where the transform keeps circles.
PlanarPath transformed(const PlanarTransform& transform, const PlanarPath& path);

}  // namespace lissom
