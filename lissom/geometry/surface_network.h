#pragma once
/// Joints on a surface and lines between them: what becomes rods.

#include <array>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/geometry/surface_path.h"

namespace lissom {

struct SurfaceJoint {
  enum class Kind {
    kInside,
    kBoundary,  ///< on a boundary of the surface
    kCorner,    ///< where a boundary turns sharply
  };
  SurfacePlace place;
  Kind kind = Kind::kInside;
};

struct SurfaceLine {
  std::array<int, 2> joint{-1, -1};  ///< where it begins and ends
  SurfacePath path;
  bool on_boundary = false;  ///< along a boundary of the surface; others are shortest paths
  std::vector<int> patch;    ///< triangles among which the shortest path was sought, ascending
};

struct SurfaceNetwork {
  std::vector<SurfaceJoint> joints;
  std::vector<SurfaceLine> lines;
  std::vector<std::string> notes;  ///< what was done on the way: cells added, lines merged

  std::vector<int> valences() const;  ///< lines at each joint
};

struct NetworkOptions {
  double shortest = 0.25;  ///< of the mean length of lines: shorter ones are merged into a joint
  int valence = 6;         ///< most lines at a joint after merging
};

/// Shortest paths for the lines inside the surface that have none yet. kGeometry at `where`, with the place in mm, where
/// a patch does not connect the joints.
Status find_paths(const Surface& surface, SurfaceNetwork& network, const std::string& where);

/// Merges short lines, the shortest first, where no two lines come to connect the same joints, no joint gets too many
/// lines and no corner moves. A note says how many.
Status merge_short_lines(const Surface& surface, SurfaceNetwork& network, const NetworkOptions& options,
                         const std::string& where);

/// kGeometry at `where` unless lines connect all joints, each line has a length and joints apart.
Status check_network(const Surface& surface, const SurfaceNetwork& network, const std::string& where);

}  // namespace lissom
