#pragma once
/// The generalised-alpha method for second-order equations of motion [Chung, Hulbert 1993].
///
/// M a(n+1-alpha_m) + C v(n+1-alpha_f) + grad V(q(n+1-alpha_f)) = 0 with Newmark's update of q and v. Second order for every
/// spectral radius at infinite frequency rho in [0, 1]; unconditionally stable in the linear case. rho = 1 dissipates
/// nothing there and is the implicit midpoint rule; rho = 0 annihilates what the step does not resolve within one step.
/// Forces are those of the configuration in between (q is interpolated, not the forces), so momenta are conserved.

namespace lissom {

struct GeneralizedAlpha {
  double alpha_m, alpha_f, beta, gamma;

  explicit GeneralizedAlpha(double rho)
      : alpha_m((2 * rho - 1) / (rho + 1)),
        alpha_f(rho / (rho + 1)),
        beta((1 - alpha_m + alpha_f) * (1 - alpha_m + alpha_f) / 4),
        gamma(0.5 - alpha_m + alpha_f) {}

  /// Local error of q in one step: error_constant * dt^3 * da/dt + O(dt^4). 1/12 for rho = 1, 1/3 for rho = 0.
  double error_constant() const { return beta + (alpha_m - alpha_f) / 2 - 1.0 / 6; }
};

}  // namespace lissom
