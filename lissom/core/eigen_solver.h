#pragma once
/// A few eigenpairs of a large sparse symmetric pencil (K, M) next to a shift, through a factor of K + shift * M.

#include <span>

#include "lissom/core/linear_solver.h"
#include "lissom/core/types.h"

namespace lissom {

struct EigenPairs {
  VecX values;    ///< ascending
  MatX vectors;   ///< one column per value, M-normalised (u' M u = 1)
  bool converged = false;
};

/// The `count` lowest eigenpairs of K u = mu M u that lie above -shift.
/// `factor` holds K + shift * diag(metric) with a positive-definite report; `metric` >= 0 is the diagonal of M, one entry
/// per unknown (zeros allowed: massless unknowns). Deterministic start vector. Clusters and multiple eigenvalues are
/// resolved: the count below any value agrees with inertia.
EigenPairs lowest_eigenpairs(const LinearSolver& factor, double shift, std::span<const double> metric, int count,
                             double tolerance = 1e-10);

}  // namespace lissom
