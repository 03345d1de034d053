#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "lissom/equilibrium/minimizer.h"
#include "lissom/equilibrium/shift.h"
#include "lissom/equilibrium/step_limits.h"
#include "lissom/equilibrium/step_path.h"

namespace lissom {

namespace {

constexpr double kMostStrain = 5e-3;     // change of axial strain in one step
constexpr double kMostSideChange = 0.3;  // rad and strain, of shells and solids in one step
constexpr double kStrained = 0.1;        // axial strain of a start that is relaxed before it is moved
constexpr int kRoughIterations = 15;
constexpr double kRoughTolerance = 1e4;  // times the final one

double largest_strain(const System& system, const State& state) {
  double largest = 0;
  for (int e = 0; e < system.edge_count(); ++e) {
    largest = std::max(largest, std::abs(state.edges[e].length / system.rest.edges[e].length - 1));
  }
  return largest;
}

}  // namespace

Descent move_to_load(NewtonWorkspace& workspace, State& state, double load_factor, double tolerance,
                     const SolveOptions& options, int max_iterations, std::vector<IterationRecord>& records) {
  const StaticProblem& problem = workspace.problem();
  const System& system = workspace.system();
  Descent result;
  const auto end = [&](Verdict verdict) {
    result.verdict = verdict;
    return result;
  };
  // Roughly; false when there is no going on from where it ends.
  const auto relax = [&](int most) {
    const int left = std::min(most, max_iterations - result.iterations);
    const Descent rough = minimize(workspace, state, kRoughTolerance * tolerance, options, left, records);
    result.iterations += rough.iterations;
    result.verdict = rough.verdict;
    return rough.verdict != Verdict::kBadStart && rough.verdict != Verdict::kRunaway;
  };
  ShiftPolicy shift(options.shift);
  std::optional<StepPathPolicy> path;
  State moved;
  VecX local, free, image, d;
  for (;;) {
    const VecX prescribed = problem.supports.prescribed_increment(system, state, load_factor);
    const double farthest = prescribed.size() > 0 ? prescribed.cwiseAbs().maxCoeff() : 0;
    if (farthest < 1e-13 * std::max(1.0, problem.scales.length)) {
      state.load_factor = load_factor;
      return end(Verdict::kStable);
    }
    if (!path) {
      const bool straight = options.path == StepPath::kStraight || options.path == StepPath::kSecondOrder;
      path.emplace(workspace, straight ? StepPath::kStraight : StepPath::kRotating);
      if (largest_strain(system, state) > kStrained && !relax(max_iterations)) return result;
    }
    if (workspace.context().cancelled()) return end(Verdict::kCancelled);
    if (result.iterations >= max_iterations) return end(Verdict::kIterationLimit);
    // The free unknowns follow as the tangent predicts: H_ff d_f = -H_fp d_p.
    workspace.assemble(state);
    if (!shift.factorize(workspace)) return end(Verdict::kStalled);
    local = prescribed;
    problem.potential.to_local(local);
    multiply(problem.potential.pattern(), workspace.hessian(), local, image);
    problem.supports.restrict(image, free);
    free = -free;
    workspace.factor().solve(free, free);
    workspace.to_increment(free, d);
    d += prescribed;
    if (!d.allFinite()) return end(Verdict::kStalled);
    double a = step_reach(system, state, d, options);
    const double strain = largest_strain(system, state, d);
    if (a * strain > kMostStrain) a = kMostStrain / strain;
    const SideChange side = largest_side_change(system, state, d);
    if (a * side.turn > kMostSideChange) a = kMostSideChange / side.turn;
    if (a * side.strain > kMostSideChange) a = kMostSideChange / side.strain;
    path->begin(state, d, a);
    bool done = false;
    for (int halving = 0; halving < 30; ++halving) {
      done = path->at(a, moved) && std::isfinite(workspace.energy(moved));
      if (done) break;
      a *= 0.5;
    }
    if (!done) return end(Verdict::kStalled);
    moved.load_factor = a == 1 ? load_factor : state.load_factor + a * (load_factor - state.load_factor);
    std::swap(state, moved);
    shift.learn(workspace);
    ++result.iterations;
    if (a < 1 && !relax(kRoughIterations)) return result;
  }
}

}  // namespace lissom
