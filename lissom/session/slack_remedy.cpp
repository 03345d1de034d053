#include "lissom/session/slack_remedy.h"

#include <cmath>

#include "lissom/mechanics/membrane_stretch.h"

namespace lissom {

double flat_tension(const TriangleRest& fabric, const Vec2& s) {
  const auto c = SheetModuli<double>::of(fabric.stiffness_1, fabric.stiffness_2, fabric.poisson_ratio);
  const double e1 = (s[0] * s[0] - 1) / 2, e2 = (s[1] * s[1] - 1) / 2;
  // Cauchy: second Piola-Kirchhoff times the stretch along over the stretch across.
  return ((c.c11 * e1 + c.c12 * e2) * s[0] / s[1] + (c.c12 * e1 + c.c22 * e2) * s[1] / s[0]) / 2;
}

std::optional<SlackRemedy> slack_remedy(const TriangleRest& fabric, const Vec2& pre_stretch, double smallest_stretch,
                                        double wanted) {
  if (!(smallest_stretch > 0) || smallest_stretch >= wanted) return std::nullopt;
  const double now = flat_tension(fabric, pre_stretch);
  if (!(now > 0)) return std::nullopt;
  SlackRemedy remedy;
  remedy.pre_stretch = pre_stretch * (wanted / smallest_stretch);
  remedy.radius_factor = std::pow(flat_tension(fabric, remedy.pre_stretch) / now, 0.25);
  return remedy;
}

}  // namespace lissom
