#pragma once
/// A few eigenpairs of a large sparse symmetric pencil (K, M) next to a shift, through a factor of K + shift * M.
///
/// Block Lanczos iteration on (K + shift M)^-1 M in the inner product of M, with full reorthogonalisation and thick
/// restarts (Grimes, Lewis, Simon 1994; Wu, Simon 2000), closed by a Rayleigh-Ritz step on (K + shift M, M). The block
/// is wider than the number of wanted pairs: an iteration with single vectors, as Spectra has it, sees one vector of a
/// multiple eigenvalue only, and round rods have every bending mode twice.

#include <span>

#include "lissom/core/linear_solver.h"
#include "lissom/core/types.h"

namespace lissom {

struct EigenPairs {
  VecX values;   ///< ascending, in the unit of K over that of M
  MatX vectors;  ///< (unknowns x values), M-orthonormal (u' M u = 1)
  bool converged = false;
  int solves = 0;  ///< right-hand sides solved for
};

/// The `count` lowest eigenpairs of K u = mu M u, all of which lie above -shift.
/// `factor` holds K + shift * diag(metric) with a positive-definite report; `metric` >= 0 is the diagonal of M, one
/// entry per unknown. Zeros are allowed (massless unknowns follow the others); there are as many eigenpairs as positive
/// entries, and fewer than `count` are returned when there are fewer. Deterministic; multiple eigenvalues come with all
/// their vectors. `tolerance` bounds the residual of each pair of (K + shift M)^-1 M relative to its eigenvalue 1 / (mu
/// + shift); the values themselves are wrong by about its square, down to rounding.
EigenPairs lowest_eigenpairs(const LinearSolver& factor, double shift, std::span<const double> metric, int count,
                             double tolerance = 1e-10);

}  // namespace lissom
