#include "lissom/equilibrium/critical_point.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lissom/equilibrium/root_finder.h"
#include "lissom/equilibrium/stability.h"

namespace lissom {

PathStability path_stability(NewtonWorkspace& workspace, const State& state) {
  workspace.assemble(state);
  // Round rods lose stability in pairs; a few more modes tell how many have crossed.
  const Stability stability = examine_stability(workspace, 4);
  PathStability result;
  result.negative = stability.negative;
  result.band = stability.band;
  if (stability.modes.empty()) return result;
  result.lowest = stability.modes.front().stiffness;
  int nearest = 0;
  for (int k = 1; k < static_cast<int>(stability.modes.size()); ++k) {
    if (std::abs(stability.modes[k].stiffness) < std::abs(stability.modes[nearest].stiffness)) nearest = k;
  }
  result.nearest = stability.modes[nearest].stiffness;
  result.nearest_shape = stability.free_shapes.col(nearest);
  return result;
}

VecX load_sensitivity(NewtonWorkspace& workspace, const State& state) {
  const StaticProblem& problem = workspace.problem();
  const System& system = workspace.system();
  // Loads are linear in the factor: one difference over a unit step is exact. A growing pre-stretch is smooth in it.
  const double reach = problem.stretches_with_load ? 1e-4 : 0.5;
  State other = state;
  VecX local, image, below, above, free;
  other.load_factor = state.load_factor - reach;
  workspace.gradient(other, below);
  other.load_factor = state.load_factor + reach;
  workspace.gradient(other, above);
  local = (above - below) / (2 * reach);
  problem.supports.restrict(local, free);
  if (!problem.supports.moves()) return free;
  const double step = 1e-6;
  VecX prescribed = problem.supports.prescribed_increment(system, state, state.load_factor + step) / step;
  problem.potential.to_local(prescribed);
  multiply(problem.potential.pattern(), workspace.hessian(), prescribed, image);
  problem.supports.restrict(image, local);
  return free + local;
}

bool correct(NewtonWorkspace& workspace, State& state, double tolerance, const SolveOptions& options, int most_steps) {
  std::vector<IterationRecord> records;
  const Descent descent = find_root(workspace, state, tolerance, options, most_steps, records);
  return descent.verdict == Verdict::kStable;
}

bool step_load(NewtonWorkspace& workspace, const State& from, double load_factor, double tolerance,
               const SolveOptions& options, State& to) {
  const StaticProblem& problem = workspace.problem();
  const System& system = workspace.system();
  workspace.assemble(from);
  const double change = load_factor - from.load_factor;
  VecX rhs = -(workspace.free_gradient() + change * load_sensitivity(workspace, from));
  const FactorReport report = workspace.factorize(0);
  VecX d = problem.supports.prescribed_increment(system, from, load_factor);
  if (report.complete) {
    workspace.factor().solve(rhs, rhs);
    VecX predicted;
    workspace.to_increment(rhs, predicted);
    if (predicted.allFinite() && largest_turn(system, from, predicted) < 1.0) d += predicted;
  }
  if (largest_turn(system, from, d) > 1.2) return false;
  if (!advance(system, from, d, to, workspace.context().threads)) return false;
  to.load_factor = load_factor;
  return correct(workspace, to, tolerance, options);
}

std::optional<CriticalPoint> locate_critical(NewtonWorkspace& workspace, const State& before,
                                             const PathStability& at_before, const State& after,
                                             const PathStability& at_after, double width, double tolerance,
                                             const SolveOptions& options) {
  State low = before, high = after, middle;
  PathStability at_low = at_before, at_high = at_after;
  for (int k = 0; k < 60 && std::abs(high.load_factor - low.load_factor) > width; ++k) {
    // Secant on the stiffness of the mode that crosses, kept inside the bracket; every third step bisects.
    double fraction = 0.5;
    const double a = at_low.nearest, b = at_high.nearest;
    if (k % 3 != 2 && a * b < 0) fraction = std::clamp(a / (a - b), 0.02, 0.98);
    const double load = low.load_factor + fraction * (high.load_factor - low.load_factor);
    const State& nearer = fraction < 0.5 ? low : high;
    if (!step_load(workspace, nearer, load, tolerance, options, middle) &&
        !step_load(workspace, low, load, tolerance, options, middle)) {
      break;
    }
    PathStability at_middle = path_stability(workspace, middle);
    if (at_middle.negative == at_before.negative) {
      low = middle;
      at_low = std::move(at_middle);
    } else {
      high = middle;
      at_high = std::move(at_middle);
    }
    // Stiffness lost within rounding: the place cannot be known better.
    if (std::abs(at_low.nearest) <= at_low.band || std::abs(at_high.nearest) <= at_high.band) break;
  }
  const bool from_low = std::abs(at_low.nearest) <= std::abs(at_high.nearest);
  const PathStability& nearest = from_low ? at_low : at_high;
  if (nearest.nearest_shape.size() == 0) return std::nullopt;
  CriticalPoint point;
  point.state = from_low ? low : high;
  point.load_factor = point.state.load_factor;
  if (at_low.nearest * at_high.nearest < 0) {
    // The zero of the secant through the last bracket.
    const double t = at_low.nearest / (at_low.nearest - at_high.nearest);
    point.load_factor = low.load_factor + t * (high.load_factor - low.load_factor);
  }
  point.negative_before = at_before.negative;
  point.negative_after = at_after.negative;
  point.mode.stiffness = nearest.nearest;
  workspace.to_increment(nearest.nearest_shape, point.mode.shape);
  // At a fold the load does work on the mode; at a bifurcation it does not.
  workspace.assemble(point.state);
  const VecX load = load_sensitivity(workspace, point.state);
  const double work = std::abs(nearest.nearest_shape.dot(load));
  point.kind =
      work > 1e-4 * nearest.nearest_shape.norm() * load.norm() ? CriticalKind::kFold : CriticalKind::kBifurcation;
  return point;
}

}  // namespace lissom
