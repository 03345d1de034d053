#pragma once
/// Smooth shapes: how much rods are bent.

#include <memory>
#include <vector>

#include "lissom/design/objective.h"

namespace lissom {

/// Components x, y, z of the curvature vector, 1/m, at every inner node of these rods (numbers in Structure::rods; none: all),
/// joints included: ((x2 - x1) / l1 - (x1 - x0) / l0) / ((l0 + l1) / 2) with rest lengths l. It is linear in the places.
/// Target 0 asks for straight rods, the values at the drawn state for no more bending than was drawn.
std::shared_ptr<const Objective> make_rod_bending(const Structure& structure, std::vector<int> rods = {});

}  // namespace lissom
