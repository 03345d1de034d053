#pragma once
/// Rods that touch, or nearly do, where they have no joint in common.

#include <vector>

#include "lissom/fabrication/rod_pieces.h"

namespace lissom {

struct NearRods {
  int rod0 = -1, rod1 = -1;   ///< of the structure; the same for one that comes back to itself
  double gap = 0;             ///< m, between their surfaces, about; negative where they overlap
  Vec3 place = Vec3::Zero();  ///< m, between them
};

/// One for each pair of rods, with the smallest gap below `gap` (m), by rods. Places from which there is a way along the rods
/// hardly longer than straight across belong to one joint, and so do places along which two rods have not yet parted since
/// a node that they share.
std::vector<NearRods> near_rods(const std::vector<RodPiece>& pieces, double gap);

}  // namespace lissom
