#include "lissom/design/total_projection.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "lissom/core/assert.h"
#include "lissom/design/box_qp.h"
#include "lissom/design/total_run.h"

namespace lissom {

namespace {

constexpr double kLeastFraction = 1.0 / 256;
constexpr double kLeastShare = 1.0 / 16;  // of the target-weighted step, before it is given up

/// v of the step that minimises 1/2 |d|^2 + weight |r + R d|^2.
VecX shortest(const TotalSpace& space, const Eliminated& at, double weight) {
  const int m = space.parameters();
  MatX b = MatX::Identity(m, m) + at.sensitivity.transpose() * at.sensitivity;
  VecX g = at.sensitivity.transpose() * at.back;
  if (weight > 0) {
    b += 2 * weight * at.jacobian.transpose() * at.jacobian;
    g += 2 * weight * at.jacobian.transpose() * (space.residual() + at.residual_back);
  }
  const VecX lower = (space.lower() - space.x()).cwiseMin(0), upper = (space.upper() - space.x()).cwiseMax(0);
  return solve_box_qp(b, g, lower, upper).x;
}

double weight_of(const ProjectionOptions& options) {
  return options.rule == ProjectionRule::kTargetWeighted ? options.target_weight : 0;
}

/// Halves a step until |H^-1 c| falls with it; false: it does not.
bool search(TotalSpace& space, const VecX& d, double off, double least) {
  for (double a = space.reach(d); a >= least; a *= 0.5) {
    if (!space.attempt(d, a)) continue;
    // In the end rounding has its say in how far c falls.
    if (space.attempted_imbalance() <= 1) return true;
    if (space.solve(space.attempted_constraint()).norm() <= (1 - 0.25 * a) * off) return true;
  }
  return false;
}

}  // namespace

VecX projection_step(const TotalSpace& space, const ProjectionOptions& options) {
  const Eliminated at(space);
  return at.step(shortest(space, at, weight_of(options)));
}

ProjectionEnd project(TotalSpace& space, const ProjectionOptions& options, const Context& context) {
  LISSOM_ASSERT(options.target_weight >= 0 && options.max_iterations > 0);
  ProjectionEnd end;
  double share = weight_of(options) > 0 ? 1 : 0;  // of the target-weighted step
  for (;; ++end.iterations) {
    if (const Status s = space.linearize(); !s) return end.reason = s.error().text(), end;
    if (!space.is_regular()) return end.reason = space.singular(), end;
    if (space.imbalance() <= 1) {
      end.reached = space.negative() == 0;
      if (!end.reached) end.reason = fmt::format("the state releases energy in {} motions", space.negative());
      return end;
    }
    if (end.iterations >= options.max_iterations) return end.reason = "iterations ran out; " + space.worst_force(), end;
    if (context.cancelled()) return end.reason = "stopped", end;
    const Eliminated at(space);
    const double off = at.back.norm();
    const VecX normal = at.step(shortest(space, at, 0));
    if (!normal.allFinite()) return end.reason = "a step is not finite; " + space.worst_force(), end;
    if (end.iterations == 0) end.first_step = normal.norm();
    bool moved = false;
    if (share > 0) {
      const VecX weighted = at.step(shortest(space, at, options.target_weight));
      for (; !moved && share >= kLeastShare; share *= moved ? 1 : 0.25) {
        moved = search(space, normal + share * (weighted - normal), off, 0.5);
      }
      if (!moved) share = 0;
    }
    if (!moved && !search(space, normal, off, kLeastFraction)) {
      end.reason = "no step brings the forces down; " + space.worst_force();
      return end;
    }
    space.accept();
  }
}

}  // namespace lissom
