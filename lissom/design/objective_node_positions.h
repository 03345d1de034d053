#pragma once
/// Where nodes are.

#include <memory>
#include <vector>

#include "lissom/design/objective.h"

namespace lissom {

/// Components x, y, z of each node in turn, m. Nodes are of the structure.
std::shared_ptr<const Objective> make_node_positions(std::vector<int> nodes);

}  // namespace lissom
