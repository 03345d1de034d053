/// Cost of the static solver and its parts: rows of name, metric, value, unit separated by tabs.

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/first_pose.h"
#include "bench/networks.h"
#include "bench/timing.h"
#include "lissom/equilibrium/newton_workspace.h"
#include "lissom/equilibrium/solve.h"
#include "lissom/mechanics/energies.h"

namespace lissom {
namespace {

void measure(const std::string& name, const Model& model, int repetitions) {
  const FirstPose ready = first_pose(name, model);
  if (!ready.problem) return;
  const StaticProblem& p = *ready.problem;
  const Context context;
  NewtonWorkspace workspace(p, context);
  State state = start_state(p, model.poses[0]);
  state.load_factor = 1;
  row(name, "unknowns", p.supports.unknowns(), "");
  AssemblyBuffers buffers;
  VecX gradient, free = VecX::Zero(p.supports.unknowns()), increment;
  std::vector<double> hessian;
  State trial;
  row(name, "energy", median_ms(repetitions, [&] { p.potential.value(state, buffers); }), "ms");
  row(name, "gradient", median_ms(repetitions, [&] { p.potential.gradient(state, gradient, buffers); }), "ms");
  const double assembly = median_ms(repetitions, [&] { p.potential.hessian(state, gradient, hessian, buffers); });
  row(name, "hessian", assembly, "ms");
  // A plain Newton iteration: assemble, factorise, solve, one trial on a straight path with its energy. Its parts are timed
  // within it, where each finds the caches as the one before left them; least of all, as others only ever add.
  double factor = 1e300, back_solve = 1e300, iteration = 1e300;
  VecX x;
  for (int k = 0; k < 20 * repetitions; ++k) {
    const double begin = now_ms();
    workspace.assemble(state);
    const double assembled = now_ms();
    workspace.factorize(0);
    const double factored = now_ms();
    free = -workspace.free_gradient();
    workspace.factor().solve(free, x);
    const double solved = now_ms();
    workspace.to_increment(x, increment);
    increment *= 1e-3;
    if (advance(*ready.system, state, increment, trial)) workspace.energy(trial);
    iteration = std::min(iteration, now_ms() - begin);
    factor = std::min(factor, factored - assembled);
    back_solve = std::min(back_solve, solved - factored);
  }
  row(name, "factor", factor, "ms");
  row(name, "solve", back_solve, "ms");
  row(name, "plain iteration", iteration, "ms");
  row(name, "plain iteration / (factor + solve)", iteration / (factor + back_solve), "");

  SolveOptions options;
  options.modes = 0;
  const State start = start_state(p, model.poses[0]);
  Equilibrium equilibrium;
  const double total = median_ms(3, [&] { equilibrium = solve(p, start, 1, options); });
  row(name, "equilibrium", total, "ms");
  row(name, "factorizations", equilibrium.factorizations, "");
  row(name, "settled", equilibrium.verdict == Verdict::kStable ? 1 : 0, "");

  // Worth of each policy: factorizations (negative: not settled) and time without it.
  const auto without = [&](const char* what, auto change) {
    SolveOptions changed = options;
    change(changed);
    Equilibrium e;
    const double begin = now_ms();
    e = solve(p, start, 1, changed);
    const double elapsed = now_ms() - begin;
    const bool settled = e.verdict == Verdict::kStable || e.verdict == Verdict::kCritical;
    row(name, (std::string(what) + ", factorizations").c_str(), settled ? e.factorizations : -e.factorizations, "");
    row(name, (std::string(what) + ", time").c_str(), elapsed, "ms");
  };
  without("straight path", [](SolveOptions& o) { o.path = StepPath::kStraight; });
  without("second-order path", [](SolveOptions& o) { o.path = StepPath::kSecondOrder; });
  without("rotating path", [](SolveOptions& o) { o.path = StepPath::kRotating; });
  without("remembered shift", [](SolveOptions& o) { o.shift = ShiftRule::kRemembered; });
  without("no expansion", [](SolveOptions& o) { o.expansion = Expansion::kOff; });
  without("relaxed frames", [](SolveOptions& o) { o.frames = Relaxation::kOn; });
  without("root finding", [](SolveOptions& o) { o.method = Method::kFindRoot; });
}

}  // namespace
}  // namespace lissom

int main() {
  using namespace lissom;
  measure("cantilever 1000 nodes", networks::hanging_cantilever(1000), 21);
  measure("honeycomb 15k", networks::hanging_honeycomb(11, 13, 8), 11);
  measure("gridshell", networks::scene("gridshell"), 11);
  measure("hexagon sheet", networks::scene("hexagon_sheet"), 11);
  return 0;
}
