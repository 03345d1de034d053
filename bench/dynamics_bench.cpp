/// Cost of a step of motion in time, on one thread: rows of name, metric, value, unit separated by tabs.

#include <algorithm>
#include <cstdio>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "bench/networks.h"
#include "bench/timing.h"
#include "lissom/motion/integrator.h"

namespace lissom {
namespace {

constexpr double kMove = 0.5;  // s of motion
// Of the whole motion. The quickest run of each step counts: other programs can only slow it down.
constexpr int kRepetitions = 7;

/// Lets go of a drawn shape under the loads of its first pose, without damping. False when a step does not converge.
bool measure(const std::string& name, const Model& model, double dt) {
  const Result<System> system = make_system(model);
  if (!system) return std::fprintf(stderr, "%s: %s\n", name.c_str(), system.error().text().c_str()), false;
  const Result<StaticProblem> problem =
      make_static_problem(model, system.value(), model.poses[0], "/poses/0", NullMotions::kKeep);
  if (!problem) return std::fprintf(stderr, "%s: %s\n", name.c_str(), problem.error().text().c_str()), false;
  const LoadHistory history;
  Integrator integrator(problem.value(), history, {}, {});
  const State start = drawn_state(system.value());
  const VecX at_rest = VecX::Zero(system.value().layout.size());
  const int steps = static_cast<int>(kMove / dt + 0.5);
  std::vector<double> quickest(steps, std::numeric_limits<double>::infinity());  // ms, of each step
  double moved = 0;
  int iterations = 0;
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    integrator.begin(start, at_rest);
    iterations = 0;
    for (int i = 0; i < steps; ++i) {
      const double begin = now_ms();
      const StepAttempt attempt = integrator.attempt(dt);
      if (!attempt.converged) return std::fprintf(stderr, "%s: step %d does not converge\n", name.c_str(), i), false;
      integrator.accept();
      quickest[i] = std::min(quickest[i], now_ms() - begin);
      iterations += attempt.iterations;
    }
    moved = (integrator.state().q - start.q).head(3 * system.value().layout.nodes()).cwiseAbs().maxCoeff();
  }
  const double step = std::accumulate(quickest.begin(), quickest.end(), 0.0) / steps;
  row(name, "unknowns", problem.value().supports.unknowns(), "");
  row(name, "step", step, "ms");
  row(name, "slowest step", *std::max_element(quickest.begin(), quickest.end()), "ms");
  row(name, "iterations per step", static_cast<double>(iterations) / steps, "");
  row(name, "wall time / time played", step / (1e3 * dt), "");
  row(name, "largest displacement at the end", 1e3 * moved, "mm");
  return true;
}

}  // namespace
}  // namespace lissom

int main() {
  using namespace lissom;
  bool good = measure("spider, steps of 2.5 ms", networks::spider(), 2.5e-3);
  good = measure("hexagon sheet, steps of 2.5 ms", networks::hanging_honeycomb(4, 4, 3), 2.5e-3) && good;
  return good ? 0 : 1;
}
