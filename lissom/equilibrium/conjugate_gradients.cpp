#include "lissom/equilibrium/conjugate_gradients.h"

#include <cmath>

namespace lissom {

CgEnd conjugate_gradients(NewtonWorkspace& workspace, const VecX& b, double tolerance, int most_iterations, VecX& x,
                          int& iterations) {
  VecX r = b, z, p, image;
  x.setZero(b.size());
  workspace.factor().solve(r, z);
  p = z;
  double rz = r.dot(z);
  const double wanted = tolerance * tolerance * rz;
  for (iterations = 0; iterations < most_iterations; ++iterations) {
    workspace.multiply_free(p, image);
    const double curvature = p.dot(image);
    if (!(curvature > 0)) return CgEnd::kNegative;
    const double a = rz / curvature;
    x += a * p;
    r -= a * image;
    workspace.factor().solve(r, z);
    const double next = r.dot(z);
    if (!std::isfinite(next)) return CgEnd::kMissed;
    if (next <= wanted) {
      ++iterations;
      return CgEnd::kConverged;
    }
    p = z + (next / rz) * p;
    rz = next;
  }
  return CgEnd::kMissed;
}

}  // namespace lissom
