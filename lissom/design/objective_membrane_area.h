#pragma once
/// How much fabric there is as it is stretched.

#include <memory>
#include <vector>

#include "lissom/design/objective.h"

namespace lissom {

/// One component, m^2: area now of these membranes (numbers in Structure::membranes), of all when there are none.
std::shared_ptr<const Objective> make_membrane_area(std::vector<int> membranes = {});

}  // namespace lissom
