#pragma once
/// Opens a closed surface where stubs of rods were left for tubes.

#include <optional>
#include <vector>

#include "lissom/fabrication/tube_strip.h"

namespace lissom {

struct StubCut {
  RodStation station;  ///< at which the rod is cut
  int step = 1;        ///< +1: what follows along the rod is taken away, -1: what comes before
  double reach = 0;    ///< m, around the centre: vertices of the stub are no farther from its axis
  double depth = 0;    ///< m, nor from the station
  double play = 0;  ///< m, the cut may be moved along the rod by up to this, to where it passes vertices at a distance
};

/// Takes all stubs away. One line around each rod per cut, in their order; nothing when a cut is not one closed line.
std::optional<std::vector<VertexRing>> cut_stubs(const std::vector<StubCut>& cuts, Surface& surface);

}  // namespace lissom
