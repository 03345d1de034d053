/// How the parts of a plain Newton iteration grow with the network: sheets of hexagons from a thousand to 1.5 million
/// unknowns, one thread. Rows of name, metric, value, unit.
///
///     scaling_bench [LARGEST]      LARGEST: leaves out networks of more unknowns; default 1700000

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <sys/resource.h>
#include <vector>

#include "bench/networks.h"
#include "bench/timing.h"
#include "lissom/equilibrium/newton_workspace.h"

namespace lissom {
namespace {

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// A square sheet of `cells` x `cells` hexagons; about 108 unknowns each. False when it cannot be set up.
bool measure(int cells) {
  const std::string name = "sheet of " + std::to_string(cells) + " x " + std::to_string(cells) + " hexagons";
  double begin = now_ms();
  const Model model = networks::hanging_honeycomb(cells, cells, 8);
  const Result<System> system = make_system(model);
  if (!system) return std::printf("%s: %s\n", name.c_str(), system.error().text().c_str()), false;
  const Result<StaticProblem> problem = make_static_problem(model, system.value(), model.poses[0], "/poses/0");
  if (!problem) return std::printf("%s: %s\n", name.c_str(), problem.error().text().c_str()), false;
  const StaticProblem& p = problem.value();
  row(name, "unknowns", p.supports.unknowns(), "");
  row(name, "set-up from the drawing", now_ms() - begin, "ms");
  begin = now_ms();
  const Context context;
  NewtonWorkspace workspace(p, context);
  row(name, "ordering and symbolic factorisation", now_ms() - begin, "ms");

  State state = start_state(p, model.poses[0]), trial;
  state.load_factor = 1;
  VecX free, x, increment;
  const int repetitions = std::clamp(2000000 / p.supports.unknowns(), 2, 25);
  workspace.assemble(state);
  const double assembly = least_ms(repetitions, [&] { workspace.assemble(state); });
  bool definite = workspace.factorize(0).positive_definite;
  const double factor = least_ms(repetitions, [&] { definite = workspace.factorize(0).positive_definite && definite; });
  free = -workspace.free_gradient();
  workspace.factor().solve(free, x);
  const double solve = least_ms(repetitions, [&] { workspace.factor().solve(free, x); });
  workspace.to_increment(x, increment);
  increment *= 1e-3;
  const auto move = [&] {
    if (advance(system.value(), state, increment, trial)) workspace.energy(trial);
  };
  move();
  const double trial_ms = least_ms(repetitions, move);
  row(name, "assembly", assembly, "ms");
  row(name, "assembly per thousand unknowns", 1e3 * assembly / p.supports.unknowns(), "ms");
  row(name, "factorisation", factor, "ms");
  row(name, "nonzeros of the factor per unknown",
      static_cast<double>(workspace.factor().statistics().factor_nonzeros) / p.supports.unknowns(), "");
  row(name, "solve", solve, "ms");
  row(name, "state and energy", trial_ms, "ms");
  row(name, "plain iteration", assembly + factor + solve + trial_ms, "ms");
  row(name, "positive definite", definite ? 1 : 0, "");
  row(name, "peak memory", peak_memory_mb(), "MB");
  return definite;
}

}  // namespace
}  // namespace lissom

int main(int argc, char** argv) {
  double largest = 1.7e6;
  for (int i = 1; i < argc; ++i) {
    if (argv[i][0] != '-') largest = std::atof(argv[i]);
  }
  // Ascending: the peak memory of a process is that of its largest network so far.
  for (const int cells : {3, 7, 12, 22, 38, 68, 123}) {
    if (108.0 * cells * cells <= largest && !lissom::measure(cells)) return 1;
  }
  return 0;
}
