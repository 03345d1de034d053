#pragma once
/// Newton steps with a factor of a nearby matrix: conjugate gradients on the present Hessian, preconditioned by the factor
/// that the workspace holds. A product and a back-solve cost about a twentieth of a factorisation [convergence 5].

#include "lissom/equilibrium/newton_workspace.h"

namespace lissom {

enum class CgEnd {
  kConverged,
  kMissed,    ///< not within the iterations granted
  kNegative,  ///< a direction without positive curvature was met
};

class ConjugateGradients {
 public:
  /// Solves H x = b for the free unknowns to `tolerance` in the norm of the preconditioner; x may not be b.
  CgEnd solve(NewtonWorkspace& workspace, const VecX& b, double tolerance, int most_iterations, VecX& x);

 private:
  VecX r_, z_, p_, image_;
};

}  // namespace lissom
