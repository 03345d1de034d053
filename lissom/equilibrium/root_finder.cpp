#include "lissom/equilibrium/root_finder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lissom/equilibrium/step_path.h"

namespace lissom {

namespace {

/// Norm of the forces with each class of unknowns made comparable: g' D^-1 g.
double merit(const VecX& gradient, const VecX& metric) {
  return std::sqrt(gradient.cwiseAbs2().cwiseQuotient(metric).sum());
}

}  // namespace

Descent find_root(NewtonWorkspace& workspace, State& state, double tolerance, const SolveOptions& options,
                  int max_iterations, std::vector<IterationRecord>& records) {
  const System& system = workspace.system();
  const double rounding = workspace.problem().scales.rounding;
  StepPathPolicy path(workspace, options.path);
  Descent result;
  State trial;
  VecX free, step, local, gradient;
  if (!std::isfinite(workspace.energy(state))) return result;
  double last_residual = INFINITY;
  for (;; ++result.iterations) {
    workspace.assemble(state);
    result.residual = workspace.residual();
    if (!std::isfinite(result.residual)) return result;
    const bool at_rounding = result.residual <= 10 * rounding && result.residual >= 0.5 * last_residual;
    if (result.residual <= tolerance || at_rounding) {
      result.verdict = Verdict::kStable;
      return result;
    }
    last_residual = result.residual;
    if (result.iterations >= max_iterations) {
      result.verdict = Verdict::kIterationLimit;
      return result;
    }
    if (workspace.context().cancelled()) {
      result.verdict = Verdict::kCancelled;
      return result;
    }
    // The unshifted matrix, indefinite or not; where there is no factor of it, the nearest shift that has one.
    double shift = 0;
    FactorReport report = workspace.factorize(shift);
    for (int attempt = 0; attempt < 40 && !report.complete; ++attempt) {
      shift = std::max(4 * shift, 1e-9);
      report = workspace.factorize(shift);
    }
    if (!report.complete) {
      result.verdict = Verdict::kStalled;
      return result;
    }
    free = -workspace.free_gradient();
    workspace.factor().solve(free, free);
    workspace.to_increment(free, step);
    if (!step.allFinite()) {
      result.verdict = Verdict::kStalled;
      return result;
    }
    double a = 1;
    const double turn = largest_turn(system, state, step);
    const int frames = 3 * system.layout.nodes();
    const double roll = step.size() > frames ? step.tail(step.size() - frames).cwiseAbs().maxCoeff() : 0;
    a = std::min({a, turn > 0 ? options.max_turn / turn : 1.0, roll > 0 ? options.max_roll / roll : 1.0});
    path.begin(state, step, a);
    const double before = merit(workspace.free_gradient(), workspace.metric());
    bool accepted = false;
    for (; a > 1e-6; a *= 0.5) {
      if (!path.at(a, trial)) continue;
      workspace.gradient(trial, local);
      workspace.problem().supports.restrict(local, gradient);
      if (merit(gradient, workspace.metric()) <= (1 - 1e-4 * a) * before) {
        accepted = true;
        break;
      }
    }
    if (!accepted) {
      result.verdict = result.residual <= 100 * rounding ? Verdict::kStable : Verdict::kStalled;
      return result;
    }
    std::swap(state, trial);
    records.push_back({static_cast<int>(records.size()), state.load_factor, workspace.energy(state), result.residual,
                       shift, a, a * turn, workspace.factorizations()});
    workspace.context().report({"solve", -1, static_cast<int>(records.size()), result.residual, "balancing forces"});
  }
}

}  // namespace lissom
