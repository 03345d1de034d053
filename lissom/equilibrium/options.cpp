#include "lissom/equilibrium/options.h"

namespace lissom {

Status SolveOptions::validate() const {
  if (!(tolerance > 0) || tolerance > 1) {
    return Error{ErrorCode::kRange, "tolerance", "the tolerance has to lie between 0 and 1", "1e-6 is usual"};
  }
  if (max_iterations < 1) {
    return Error{ErrorCode::kRange, "max_iterations", "at least one iteration is needed", "500 is usual"};
  }
  if (!(max_turn > 0) || max_turn > 1.5 || !(max_roll > 0) || max_roll > 1.5) {
    return Error{ErrorCode::kRange, "max_turn", "limits on turns have to lie between 0 and 1.5 rad",
                 "0.7 and 0.5 are usual"};
  }
  if (modes < 0) return Error{ErrorCode::kRange, "modes", "the number of modes cannot be negative", ""};
  return {};
}

}  // namespace lissom
