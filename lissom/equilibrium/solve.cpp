#include "lissom/equilibrium/solve.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lissom/equilibrium/minimizer.h"
#include "lissom/equilibrium/report.h"
#include "lissom/equilibrium/rigid_drift.h"
#include "lissom/equilibrium/root_finder.h"
#include "lissom/equilibrium/stability.h"
#include "lissom/equilibrium/start_smoothing.h"
#include "lissom/equilibrium/step_path.h"

namespace lissom {

namespace {

constexpr int kMaxEscapes = 8;

/// Moves `state` along +- the mode by the amplitude of lowest energy among a few. False when none lowers the energy.
bool escape(NewtonWorkspace& workspace, State& state, const Mode& mode, const SolveOptions& options) {
  const double turn = largest_turn(workspace.system(), state, mode.shape);
  const int frames = 3 * workspace.system().layout.nodes();
  const double roll =
      mode.shape.size() > frames ? mode.shape.tail(mode.shape.size() - frames).cwiseAbs().maxCoeff() : 0;
  const double unit = 0.3 / std::max({turn, roll, 1e-300});
  StepPathPolicy path(workspace, options.path == StepPath::kStraight ? StepPath::kStraight : StepPath::kRotating);
  const VecX step = unit * mode.shape;
  path.begin(state, step, 1);
  const double energy = workspace.energy(state);
  double best_energy = energy;
  State trial, best;
  for (const double amplitude : {1.0, 0.5, 0.25, 0.1, 0.03, -1.0, -0.5, -0.25, -0.1, -0.03}) {
    if (!path.at(amplitude, trial)) continue;
    const double v = workspace.energy(trial);
    // The side is fixed by the mode's sign unless the other one is clearly lower: mirror images tie.
    if (v < best_energy - 1e-9 * std::abs(energy - best_energy)) {
      best_energy = v;
      best = trial;
    }
  }
  if (!(best_energy < energy)) return false;
  std::swap(state, best);
  return true;
}

}  // namespace

Status SolveOptions::validate() const {
  if (!(tolerance > 0) || tolerance > 1) {
    return Error{ErrorCode::kRange, "tolerance", "the tolerance has to lie between 0 and 1", "1e-6 is usual"};
  }
  if (max_iterations < 1) {
    return Error{ErrorCode::kRange, "max_iterations", "at least one iteration is needed", "500 is usual"};
  }
  if (!(max_turn > 0) || max_turn > 1.5 || !(max_roll > 0) || max_roll > 1.5) {
    return Error{ErrorCode::kRange, "max_turn", "limits on turns have to lie between 0 and 1.5 rad",
                 "0.7 and 0.5 are usual"};
  }
  if (modes < 0) return Error{ErrorCode::kRange, "modes", "the number of modes cannot be negative", ""};
  return {};
}

Equilibrium solve(const StaticProblem& problem, const State& start, double load_factor, const SolveOptions& options,
                  const Context& context) {
  Equilibrium result;
  result.state = start;
  result.records.reserve(std::clamp(options.max_iterations, 1, 1024));
  NewtonWorkspace workspace(problem, context);
  result.tolerance = std::max(options.tolerance * problem.scales.force, 2 * problem.scales.rounding);
  const auto finish = [&](Verdict verdict) {
    result.verdict = verdict;
    if (!problem.system->structure.triangles.empty()) lay_down(problem, result.state);
    result.factorizations = workspace.factorizations();
    describe(problem, workspace, result);
    return std::move(result);
  };
  if (!start.q.allFinite()) return finish(Verdict::kBadStart);
  if (is_crumpled(workspace.system(), result.state)) {
    result.state = smoothed_start(problem, result.state);
    result.start_smoothed = true;
  }
  const Descent moves = move_to_load(workspace, result.state, load_factor, result.tolerance, options,
                                     options.max_iterations, result.records);
  result.iterations = moves.iterations;
  if (moves.verdict != Verdict::kStable) return finish(moves.verdict);

  for (int escapes = 0;; ++escapes) {
    const int left = options.max_iterations - result.iterations;
    const Descent descent =
        options.method == Method::kMinimize
            ? minimize(workspace, result.state, result.tolerance, options, std::max(left, 0), result.records)
            : find_root(workspace, result.state, result.tolerance, options, std::max(left, 0), result.records);
    result.iterations += descent.iterations;
    result.residual = descent.residual;
    if (descent.verdict != Verdict::kStable) return finish(descent.verdict);

    const Stability stability = examine_stability(workspace, options.modes);
    result.modes = stability.modes;
    result.negative_modes = stability.negative;
    if (stability.negative == 0) return finish(stability.critical ? Verdict::kCritical : Verdict::kStable);
    const bool leave = options.at_saddle == AtSaddle::kEscape && options.method == Method::kMinimize &&
                       escapes < kMaxEscapes && !stability.modes.empty() && !context.cancelled();
    if (!leave || !escape(workspace, result.state, stability.modes.front(), options)) return finish(Verdict::kUnstable);
  }
}

}  // namespace lissom
