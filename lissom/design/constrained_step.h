#pragma once
/// A finite step along parameters that hard constraints allow to first order, taken so that they still hold after it: drift is
/// brought back by the least changes of the parameters [mathematics 7].

#include "lissom/core/context.h"
#include "lissom/design/hard_constraints.h"
#include "lissom/design/shape_response.h"

namespace lissom {

struct ConstrainedStep {
  VecX p;  ///< SI, within the bounds
  Design design;
  State state;           ///< the equilibrium, pinned down
  double violation = 0;  ///< m, the largest entry of C that is left
  bool cut = false;      ///< bounds or lost stability have shortened the step
};

/// From the start of `response` by `change` of p / scale, halved (six times at most) where no stable shape follows.
/// `tolerance`: m, of C. Errors say why not even a short step could be taken.
Result<ConstrainedStep> constrained_step(const ShapeResponse& response, const HardConstraints& constraints,
                                         const VecX& change, double tolerance, const Context& context);

}  // namespace lissom
