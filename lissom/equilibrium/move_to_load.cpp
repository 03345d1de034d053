#include <algorithm>
#include <cmath>
#include <utility>

#include "lissom/equilibrium/minimizer.h"
#include "lissom/equilibrium/shift.h"
#include "lissom/equilibrium/step_limits.h"
#include "lissom/equilibrium/step_path.h"

namespace lissom {

namespace {

constexpr double kMostStrain = 5e-3;  // change of axial strain in one step
constexpr int kMostSteps = 2000;
constexpr int kRoughIterations = 15;
constexpr double kRoughTolerance = 1e4;  // times the final one

}  // namespace

int move_to_load(NewtonWorkspace& workspace, State& state, double load_factor, double tolerance,
                 const SolveOptions& options, std::vector<IterationRecord>& records) {
  const StaticProblem& problem = workspace.problem();
  const System& system = workspace.system();
  const bool straight = options.path == StepPath::kStraight || options.path == StepPath::kSecondOrder;
  ShiftPolicy shift(options.shift);
  StepPathPolicy path(workspace, straight ? StepPath::kStraight : StepPath::kRotating);
  State moved;
  VecX local, free, image, d;
  int iterations = 0;
  for (int step = 0; step < kMostSteps; ++step) {
    const VecX prescribed = problem.supports.prescribed_increment(system, state, load_factor);
    const double farthest = prescribed.size() > 0 ? prescribed.cwiseAbs().maxCoeff() : 0;
    if (farthest < 1e-13 * std::max(1.0, problem.scales.length)) {
      state.load_factor = load_factor;
      return iterations;
    }
    if (workspace.context().cancelled()) return iterations;
    // The free unknowns follow as the tangent predicts: H_ff d_f = -H_fp d_p.
    workspace.assemble(state);
    if (!shift.factorize(workspace)) return -1;
    local = prescribed;
    problem.potential.to_local(local);
    multiply(problem.potential.pattern(), workspace.hessian(), local, image);
    problem.supports.restrict(image, free);
    free = -free;
    workspace.factor().solve(free, free);
    workspace.to_increment(free, d);
    d += prescribed;
    if (!d.allFinite()) return -1;
    double a = step_reach(system, state, d, options);
    const double strain = largest_strain(system, state, d);
    if (a * strain > kMostStrain) a = kMostStrain / strain;
    path.begin(state, d, a);
    bool done = false;
    for (int halving = 0; halving < 30; ++halving) {
      done = path.at(a, moved) && std::isfinite(workspace.energy(moved));
      if (done) break;
      a *= 0.5;
    }
    if (!done) return -1;
    moved.load_factor = a == 1 ? load_factor : state.load_factor + a * (load_factor - state.load_factor);
    std::swap(state, moved);
    shift.learn(workspace);
    ++iterations;
    if (a == 1) continue;
    const Descent rough = minimize(workspace, state, kRoughTolerance * tolerance, options, kRoughIterations, records);
    iterations += rough.iterations;
    if (rough.verdict == Verdict::kBadStart) return -1;
  }
  return -1;
}

}  // namespace lissom
