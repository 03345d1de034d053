#pragma once
/// Where a set of nodes is and how it is turned, as one piece.

#include <memory>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/design/objective.h"

namespace lissom {

/// Components x, y, z, m: mean of the places of the nodes, of which there is at least one.
std::shared_ptr<const Objective> make_set_position(std::vector<int> nodes);

/// Components x, y, z, rad, of the rotation vector, at most pi long, of the rigid motion that takes `places` (3 x nodes, m;
/// usually the drawn ones) nearest to where the nodes are, by least squares [Kabsch 1976; mathematics 2.3]. `places` are
/// fixed: they do not follow a design. At half a turn the vector jumps to its opposite; give places turned half way there for
/// targets near it. kGeometry where the places are fewer than three or lie on a line.
Result<std::shared_ptr<const Objective>> make_set_orientation(std::vector<int> nodes, const Eigen::Matrix3Xd& places);

}  // namespace lissom
