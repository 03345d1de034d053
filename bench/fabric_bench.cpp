/// Cost of releasing rods on pre-stretched fabric, by method and by part: rows of name, metric, value, unit.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "bench/fabric_problems.h"
#include "bench/first_pose.h"
#include "bench/timing.h"
#include "lissom/equilibrium/newton_workspace.h"
#include "lissom/equilibrium/solve.h"

namespace lissom {
namespace {

struct Method {
  const char* name;
  void (*set)(SolveOptions&);
};

/// The rows of the comparison: what each part of the method brings.
constexpr Method kMethods[] = {
    {"recommended", [](SolveOptions&) {}},
    {"frames relaxed too", [](SolveOptions& o) { o.frames = Relaxation::kOn; }},
    {"rods not relaxed", [](SolveOptions& o) { o.rods = Relaxation::kOff; }},
    {"lengths not kept", [](SolveOptions& o) { o.path = StepPath::kSecondOrder; }},
    {"no second-order path", [](SolveOptions& o) { o.path = StepPath::kRotating; }},
    {"remembered shift", [](SolveOptions& o) { o.shift = ShiftRule::kRemembered; }},
    {"plain Newton",
     [](SolveOptions& o) {
       o.rods = Relaxation::kOff;
       o.path = StepPath::kStraight;
       o.shift = ShiftRule::kRemembered;
       o.expansion = Expansion::kOff;
     }},
};

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
  row(name, "unknowns", p.supports.unknowns(), "");
  const State start = start_state(p, model.poses[0]);
  for (const Method& method : kMethods) {
    SolveOptions options;
    method.set(options);
    Equilibrium found;
    const double time = least_ms(1, [&] { found = solve(p, start, 1, options); });
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
  measure("frame 8", networks::square_frame_on_fabric(frame));
  frame.cells = 49;
  measure("frame 49", networks::square_frame_on_fabric(frame));
  frame.pre_stretch = 1.6;
  measure("frame 49 taut", networks::square_frame_on_fabric(frame));
  frame.pre_stretch = 1.3;
  frame.r_b = 0.2e-3;
  measure("frame 49 slack", networks::square_frame_on_fabric(frame));
  return 0;
}
