#pragma once
/// Line networks in Wavefront OBJ text: points (`v`) and polylines (`l`).

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/core/types.h"

namespace lissom {

struct ObjLines {
  std::vector<Vec3> points;                  ///< in the unit of the file (n x 3)
  std::vector<std::array<int, 2>> segments;  ///< 0-based point numbers; an `l` with k points gives k - 1 (m x 2)
  int ignored = 0;                           ///< faces, normals, groups and other statements that are not read
};

/// Reads `v` and `l`; negative indices count back from the last point so far, `l` may name points that follow later,
/// `v/vt` pairs, comments, CRLF and lines continued by a backslash are understood. Errors name `file` and the line.
Result<ObjLines> read_obj_lines(std::string_view text, const std::string& file);

/// The same network as OBJ text, coordinates with 17 digits so that reading returns the same numbers.
std::string write_obj_lines(const ObjLines& lines);

}  // namespace lissom
