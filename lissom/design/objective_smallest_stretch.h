#pragma once
/// Fabric that has to stay taut: the smaller principal stretch of every triangle [mathematics 3.1].

#include <memory>
#include <vector>

#include "lissom/design/objective.h"

namespace lissom {

/// One component per triangle of these membranes (numbers in Structure::membranes; none: all), in their order: the smaller
/// singular value of the deformation gradient, dimensionless, below 1 where the fabric is slack; for goals that keep it above
/// a value. Where both principal stretches are equal it would have a kink: with C = F'F the square root of the discriminant
/// D of its eigenvalues is replaced by sqrt(D + 1e-8), so that the square of the stretch reads up to 5e-5 too low.
std::shared_ptr<const Objective> make_smallest_stretch(const Structure& structure, std::vector<int> membranes = {});

}  // namespace lissom
