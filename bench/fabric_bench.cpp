/// Cost of releasing rods on pre-stretched fabric by method: rows of name, metric, value, unit. docs/guide/fabric.md has
/// the table.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "bench/fabric_problems.h"
#include "bench/first_pose.h"
#include "bench/timing.h"
#include "lissom/equilibrium/solve.h"

namespace lissom {
namespace {

/// Newton with a shift remembered from step to step, straight steps and nothing else: what the parts below are added to.
SolveOptions plain() {
  SolveOptions options;
  options.rods = Relaxation::kOff;
  options.path = StepPath::kStraight;
  options.shift = ShiftRule::kRemembered;
  options.expansion = Expansion::kOff;
  options.reuse = FactorReuse::kOff;
  return options;
}

SolveOptions with(SolveOptions options, void (*set)(SolveOptions&)) {
  set(options);
  return options;
}

struct Method {
  const char* name;
  SolveOptions options;
};

/// The rows of the comparison: A second-order path, R rotating path, F relaxed frames, X expansion, E shift by eigenvalue,
/// B relaxed rods [convergence 2].
std::vector<Method> methods() {
  using O = SolveOptions;
  return {
      {"plain Newton", plain()},
      {"A", with(plain(), [](O& o) { o.path = StepPath::kSecondOrder; })},
      {"R", with(plain(), [](O& o) { o.path = StepPath::kRotating; })},
      {"A + R", with(plain(), [](O& o) { o.path = StepPath::kSecondOrderRotating; })},
      {"A + R + F", with(plain(),
                         [](O& o) {
                           o.path = StepPath::kSecondOrderRotating;
                           o.frames = Relaxation::kOn;
                         })},
      {"A + R + X + E", with({}, [](O& o) { o.rods = Relaxation::kOff; })},
      {"B + X + E", with({}, [](O& o) { o.path = StepPath::kStraight; })},
      {"A + B + X + E", with({}, [](O& o) { o.path = StepPath::kSecondOrder; })},
      {"R + B + X + E", with({}, [](O& o) { o.path = StepPath::kRotating; })},
      {"A + R + B + X", with({}, [](O& o) { o.shift = ShiftRule::kRemembered; })},
      {"A + R + F + B + X + E", with({}, [](O& o) { o.frames = Relaxation::kOn; })},
      {"A + R + B + X + E (in use)", {}},
  };
}

double height(const System& system, const State& state) {
  double low = INFINITY, high = -INFINITY;
  for (int i = 0; i < system.layout.nodes(); ++i) {
    low = std::min(low, state.position(i).z());
    high = std::max(high, state.position(i).z());
  }
  return high - low;
}

void measure(const std::string& name, const Model& model) {
  const FirstPose ready = first_pose(name, model);
  if (!ready.problem) return;
  const StaticProblem& p = *ready.problem;
  row(name, "nodes", ready.system->layout.nodes(), "");
  row(name, "rod edges", ready.system->edge_count(), "");
  row(name, "joints", ready.system->joint_count(), "");
  const State start = start_state(p, model.poses[0]);
  for (Method method : methods()) {
    method.options.modes = 0;
    method.options.max_iterations = 400;
    Equilibrium found;
    const double time = least_ms(1, [&] { found = solve(p, start, 1, method.options); });
    const std::string label = name + ", " + method.name;
    row(label, "factorizations", found.factorizations, "");
    row(label, "time", time, "ms");
    row(label, "energy", 1e3 * found.energy, "N mm");
    row(label, "height", 1e3 * height(*ready.system, found.state), "mm");
    row(label, "stable", found.verdict == Verdict::kStable, "");
  }
}

}  // namespace
}  // namespace lissom

int main() {
  using namespace lissom;
  networks::SquareFrame frame;
  measure("sq8 i", networks::square_frame_on_fabric(frame));
  frame.cells = 49;
  measure("sq49 i", networks::square_frame_on_fabric(frame));
  frame.pre_stretch = 1.6;
  measure("sq49 ii", networks::square_frame_on_fabric(frame));
  frame.pre_stretch = 1.3;
  frame.r_b = 0.2e-3;
  measure("sq49 iii", networks::square_frame_on_fabric(frame));
  measure("disc", networks::crossed_disc());
  measure("leaf", networks::leaf(0.65e-3, 1.4));
  measure("leafT", networks::leaf(0.4e-3, 1.5));
  return 0;
}
