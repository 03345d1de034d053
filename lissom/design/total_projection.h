#pragma once
/// Projections onto equilibrium in total space, c(u, x) = 0, by steps that change states and parameters together [mathematics
/// 5.5: normal flow (4.36)-(4.38), target-weighted (4.39); erratum E24]. With d = (back + S v, v), back = -H^-1 c, every step
/// satisfies J d = -c and the bounds of x, and v is chosen:
///   normal flow      the shortest, min 1/2 |d|^2, in the scaled metric of TotalSpace: d = -J'(J J')^-1 c where no bound is met;
///   target-weighted  min 1/2 |d|^2 + tau |r + R d|^2 (r: residuals of h; (4.39) has q - q^t alone), which also moves along
///                    equilibria, towards the goals.

#include <string>

#include "lissom/design/total_space.h"

namespace lissom {

enum class ProjectionRule { kNormalFlow, kTargetWeighted };

struct ProjectionOptions {
  ProjectionRule rule = ProjectionRule::kNormalFlow;
  /// tau of kTargetWeighted, >= 0, per unit of h: how many squared scales of states and parameters a gain of h is worth.
  double target_weight = 1;
  int max_iterations = 30;
};

struct ProjectionEnd {
  bool reached = false;  ///< in equilibrium, as precisely as solves of the problem, and stable by inertia
  std::string reason;    ///< in words, unless reached
  int iterations = 0;
  double first_step = 0;  ///< length of the first step, |d| over scales
};

/// The step at the point of `space`, which is linear and regular, (n + m).
VecX projection_step(const TotalSpace& space, const ProjectionOptions& options);

/// Brings the point of `space` into equilibrium; x ends near where it was, not there. Globalised by |H^-1 c|, which every step
/// lowers; target-weighted steps that do not are drawn towards normal flow, so that both converge quadratically in the end.
ProjectionEnd project(TotalSpace& space, const ProjectionOptions& options, const Context& context);

}  // namespace lissom
