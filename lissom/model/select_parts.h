#pragma once
/// The outer loop of a line network, a step of `select`.

#include <vector>

#include "lissom/model/structure.h"

namespace lissom {

/// How many rod ends and through-going rods meet at each node.
std::vector<int> count_passages(const Structure& structure);

/// Nodes on the outer loop, ascending. The network is projected to its best-fit plane; branches that end freely are cut
/// away; each connected part is walked around its outer face. Of the loop, the nodes where rods meet or end are taken, all
/// of its nodes if there are none (a single ring). A part without loops gives its free ends.
std::vector<int> boundary_nodes(const Structure& structure);

}  // namespace lissom
