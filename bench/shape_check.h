#pragma once
/// What a verdict promises, computed anew from the potential: for benches and tests that do not take the solver's word.

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "lissom/core/linear_solver.h"
#include "lissom/equilibrium/equilibrium.h"
#include "lissom/equilibrium/static_problem.h"

namespace lissom {

struct ShapeCheck {
  bool finite = false;
  double residual = 0;    ///< N, largest force, or moment over the mean edge length
  bool definite = false;  ///< the Hessian is positive definite, but for rounding: straight rods may spin freely
};

inline ShapeCheck check_shape(const StaticProblem& problem, const State& state) {
  ShapeCheck check;
  check.finite = state.q.allFinite();
  if (!check.finite) return check;
  const System& system = *problem.system;
  AssemblyBuffers buffers;
  VecX gradient;
  std::vector<double> hessian;
  problem.potential.hessian(state, gradient, hessian, buffers);
  const std::span<const int> kept = problem.supports.kept();
  for (int i = 0; i < static_cast<int>(kept.size()); ++i) {
    if (kept[i] < 0) continue;
    const bool position = system.layout.dof_class(i) == DofClass::kPosition;
    const double force = std::abs(gradient[i]) / (position ? 1 : system.rest.mean_edge_length);
    if (!(force <= check.residual)) check.residual = force;
  }
  double largest = 0;
  for (int i = 0; i < 3 * system.layout.nodes(); ++i) {
    if (kept[i] < 0) continue;
    const double diagonal = std::abs(hessian[problem.potential.pattern().diagonal_slot(i)]);
    largest = std::max(largest, diagonal / problem.mode_metric[kept[i]]);
  }
  const double rounding = 4e-14 * largest + 1e-6 * problem.scales.stiffness;
  LinearSolver solver(problem.potential.pattern(), kept);
  check.definite =
      solver.factorize(hessian, rounding, {problem.mode_metric.data(), static_cast<size_t>(problem.mode_metric.size())})
          .positive_definite;
  return check;
}

/// False when an ending claims what is not so.
inline bool verdict_is_true(const StaticProblem& problem, const Equilibrium& e) {
  if (e.verdict == Verdict::kBadStart) return true;
  const ShapeCheck check = check_shape(problem, e.state);
  if (!check.finite || !std::isfinite(e.energy)) return false;
  const bool settled = e.verdict == Verdict::kStable || e.verdict == Verdict::kCritical;
  // Forces that are rounding of the axial ones may stay.
  if (settled && !(check.residual <= std::max(e.tolerance, 100 * problem.scales.rounding))) return false;
  return e.verdict != Verdict::kStable || check.definite;
}

}  // namespace lissom
