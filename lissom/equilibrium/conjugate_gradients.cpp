#include "lissom/equilibrium/conjugate_gradients.h"

#include <cmath>

namespace lissom {

CgEnd ConjugateGradients::solve(NewtonWorkspace& workspace, const VecX& b, double tolerance, int most_iterations,
                                VecX& x) {
  r_ = b;
  x.setZero(b.size());
  workspace.factor().solve(r_, z_);
  p_ = z_;
  double rz = r_.dot(z_);
  const double wanted = tolerance * tolerance * rz;
  for (int k = 0; k < most_iterations; ++k) {
    workspace.multiply_free(p_, image_);
    const double curvature = p_.dot(image_);
    if (!(curvature > 0)) return CgEnd::kNegative;
    const double a = rz / curvature;
    x += a * p_;
    r_ -= a * image_;
    workspace.factor().solve(r_, z_);
    const double next = r_.dot(z_);
    if (!std::isfinite(next)) return CgEnd::kMissed;
    if (next <= wanted) return CgEnd::kConverged;
    p_ = z_ + (next / rz) * p_;
    rz = next;
  }
  return CgEnd::kMissed;
}

}  // namespace lissom
