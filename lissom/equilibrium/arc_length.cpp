#include "lissom/equilibrium/arc_length.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lissom {

ArcLength::ArcLength(NewtonWorkspace& workspace, double tolerance, double first_load_step)
    : workspace_(workspace), tolerance_(tolerance), first_load_step_(first_load_step) {
  // Displacements count relative to the size of the structure, as a root mean square.
  weight_ = workspace.problem().mode_metric / std::pow(workspace.problem().scales.length, 2);
}

double ArcLength::dot(const VecX& a, double la, const VecX& b, double lb) const {
  return a.cwiseProduct(weight_).dot(b) + la * lb / (first_load_step_ * first_load_step_) * 1e-2;
}

ArcLength::Outcome ArcLength::step(const State& from, State& to) {
  const System& system = workspace_.system();
  workspace_.assemble(from);
  VecX tangent = -load_sensitivity(workspace_, from);
  if (!workspace_.factorize(0).complete) return Outcome::kStuck;
  workspace_.factor().solve(tangent, tangent);
  if (!tangent.allFinite()) return Outcome::kStuck;
  double tangent_load = 1;
  const double norm = std::sqrt(dot(tangent, tangent_load, tangent, tangent_load));
  tangent /= norm;
  tangent_load /= norm;
  // Go on in the direction of the last step; the first goes with the load.
  const bool backwards = last_tangent_.size() > 0 ? dot(tangent, tangent_load, last_tangent_, last_tangent_load_) < 0
                                                  : tangent_load * first_load_step_ < 0;
  if (backwards) {
    tangent = -tangent;
    tangent_load = -tangent_load;
  }
  if (arc_ == 0) arc_ = std::abs(first_load_step_ / tangent_load);
  for (int attempt = 0; attempt < 25; ++attempt) {
    const double load = from.load_factor + arc_ * tangent_load;
    VecX predicted;
    const VecX scaled = arc_ * tangent;
    workspace_.to_increment(scaled, predicted);
    predicted += workspace_.problem().supports.prescribed_increment(system, from, load);
    const double turn = largest_turn(system, from, predicted);
    bool moved = turn < 0.5 && advance(system, from, predicted, to);
    if (moved) {
      to.load_factor = load;
      moved = correct_along(to, tangent, tangent_load);
    }
    if (moved) {
      direction_before_ = direction_ == 0 ? tangent_load : direction_;
      direction_ = tangent_load;
      // The load over the arc is a parabola between the two tangents: its extremum is where the fold lies.
      const double slope0 = last_tangent_.size() > 0 ? last_slope_ : tangent_load, slope1 = tangent_load;
      extremum_ = slope0 * slope1 < 0 ? last_load_ + 0.5 * arc_ * slope0 * slope0 / (slope0 - slope1) : to.load_factor;
      last_slope_ = tangent_load;
      last_load_ = from.load_factor;
      last_tangent_ = tangent;
      last_tangent_load_ = tangent_load;
      if (attempt == 0) arc_ *= 1.25;
      return Outcome::kMoved;
    }
    arc_ *= 0.5;
  }
  return Outcome::kStuck;
}

bool ArcLength::correct_along(State& state, const VecX& tangent, double tangent_load) {
  // Newton on (g, tangent . (q - predicted)) = 0 by bordering: two solves with one factor.
  const System& system = workspace_.system();
  VecX along = VecX::Zero(tangent.size()), step_g, step_l, increment;
  double along_load = 0;
  State next;
  for (int k = 0; k < 15; ++k) {
    workspace_.assemble(state);
    if (workspace_.residual() <= tolerance_) return true;
    if (!workspace_.factorize(0).complete) return false;
    step_g = -workspace_.free_gradient();
    step_l = -load_sensitivity(workspace_, state);
    workspace_.factor().solve(step_g, step_g);
    workspace_.factor().solve(step_l, step_l);
    const double gap = -dot(along, along_load, tangent, tangent_load);
    const double numerator = gap - dot(step_g, 0, tangent, tangent_load);
    const double denominator = dot(step_l, 1, tangent, tangent_load);
    const double change = numerator / denominator;
    const VecX free = step_g + change * step_l;
    workspace_.to_increment(free, increment);
    increment += workspace_.problem().supports.prescribed_increment(system, state, state.load_factor + change);
    if (!increment.allFinite() || largest_turn(system, state, increment) > 1) return false;
    if (!advance(system, state, increment, next)) return false;
    next.load_factor = state.load_factor + change;
    along += free;
    along_load += change;
    std::swap(state, next);
  }
  return false;
}

}  // namespace lissom
