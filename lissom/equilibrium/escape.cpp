#include "lissom/equilibrium/escape.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lissom/equilibrium/step_limits.h"
#include "lissom/equilibrium/step_path.h"

namespace lissom {

bool escape(NewtonWorkspace& workspace, StepPath path, State& state, const VecX& direction) {
  const System& system = workspace.system();
  const double turn = largest_turn(system, state, direction), roll = largest_roll(system, direction);
  const double unit = 0.3 / std::max({turn, roll, 1e-300});
  StepPathPolicy along(workspace, path == StepPath::kStraight ? StepPath::kStraight : StepPath::kRotating);
  VecX step = unit * direction;
  along.drift().remove(state, step);
  along.begin(state, step, 1);
  const double energy = workspace.energy(state);
  double best_energy = energy;
  State trial, best;
  for (const double amplitude : {1.0, 0.5, 0.25, 0.1, 0.03, -1.0, -0.5, -0.25, -0.1, -0.03}) {
    if (!along.at(amplitude, trial)) continue;
    const double v = workspace.energy(trial);
    // The side is fixed by the direction's sign unless the other one is clearly lower: mirror images tie.
    if (v < best_energy - 1e-9 * std::abs(energy - best_energy)) {
      best_energy = v;
      best = trial;
    }
  }
  if (!(best_energy < energy)) return false;
  std::swap(state, best);
  return true;
}

}  // namespace lissom
