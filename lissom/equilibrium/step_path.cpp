#include "lissom/equilibrium/step_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lissom/equilibrium/step_limits.h"
#include "lissom/geometry/frame.h"

namespace lissom {

StepPathPolicy::StepPathPolicy(NewtonWorkspace& workspace, StepPath path)
    : workspace_(workspace), path_(path), drift_(workspace.problem()) {
  if (path == StepPath::kRotating || path == StepPath::kSecondOrderRotating) {
    if (workspace.system().structure.triangles.empty()) {
      fit_.emplace(workspace.problem());
      if (!fit_->factorize(0)) fit_.reset();
    } else {
      length_fit_.emplace(workspace.problem(), drift_.can_move(), workspace.context().threads);
    }
  }
}

void StepPathPolicy::begin(const State& state, const VecX& d, double reach, bool own_factor,
                           std::span<const double> arrival) {
  state_ = &state;
  arrival_ = arrival;
  d_ = d;
  has_p_ = false;
  if (own_factor && (path_ == StepPath::kSecondOrder || path_ == StepPath::kSecondOrderRotating)) second_order(reach);
}

void StepPathPolicy::second_order(double reach) {
  // p = -1/2 H^-1 (g(q + h d) + g(q - h d) - 2 g(q)) / h^2, all of one function anchored at q.
  const double h = 0.05 * std::min(reach, 1.0);
  const System& system = workspace_.system();
  const Potential& potential = workspace_.problem().potential;
  const auto anchored = [&](double step, VecX& gradient) {
    increment_ = step * d_;
    if (!advance(system, *state_, increment_, probe_, workspace_.context().threads)) return false;
    workspace_.gradient(probe_, gradient);
    potential.to_global(gradient);
    to_anchored_gradient(system, *state_, probe_, increment_, gradient);
    potential.to_local(gradient);
    return true;
  };
  if (!anchored(h, forward_) || !anchored(-h, backward_)) return;
  forward_ += backward_;
  forward_ -= 2 * workspace_.local_gradient();
  forward_ *= -0.5 / (h * h);
  workspace_.problem().supports.restrict(forward_, free_);
  workspace_.factor().solve(free_, free_);
  workspace_.to_increment(free_, p_);
  drift_.remove(*state_, p_);
  if (!p_.allFinite()) return;
  // A correction, never more than the step itself.
  const double turn_d = step_turn(system, *state_, d_), turn_p = reach * step_turn(system, *state_, p_);
  if (turn_p > 0.75 * turn_d) p_ *= 0.75 * turn_d / turn_p;
  has_p_ = true;
}

bool StepPathPolicy::at(double a, State& trial) {
  increment_ = a * d_;
  if (has_p_) increment_ += a * a * p_;
  // Positions closest to edges that turn at their length: min sum (1 / l) |x1 - x0 - wanted|^2.
  if (fit_ && !rotate(a, increment_)) return false;
  if (length_fit_ && !length_fit_->mend(*state_, a, d_, arrival_, increment_)) return false;
  return advance(workspace_.system(), *state_, increment_, trial, workspace_.context().threads);
}

bool StepPathPolicy::rotate(double a, VecX& increment) {
  const System& system = workspace_.system();
  pull_.setZero(increment.size());
  for (int e = 0; e < system.edge_count(); ++e) {
    const StructureEdge& edge = system.structure.edges[e];
    const EdgeState& now = state_->edges[e];
    const auto edge_of = [&](const VecX& q) -> Vec3 {
      return q.segment<3>(3 * edge.node1) - q.segment<3>(3 * edge.node0);
    };
    const Vec3 linear = edge_of(increment);
    const Vec3 turn = now.t.cross(linear) / now.length;
    // A prediction knows lengths to first order in new rest lengths only, which is not enough for stiff rods.
    const double change =
        arrival_.empty() ? now.t.dot(edge_of(d_)) : (1 + arrival_[e]) * system.rest.edges[e].length - now.length;
    const double length = now.length + a * change;
    if (!(length > 0.1 * now.length)) return false;
    const Vec3 wanted = length * (rotation_from_vector(turn) * now.t);
    // Residual of the fit at the straight trial.
    const Vec3 pull = fit_->weights()[e] * (wanted - (now.length * now.t + linear));
    pull_.segment<3>(3 * edge.node1) += pull;
    pull_.segment<3>(3 * edge.node0) -= pull;
  }
  fit_->solve(pull_, fitted_);
  increment += fitted_;
  return true;
}

void to_anchored_gradient(const System& system, const State& anchor, const State& moved, const VecX& dq,
                          VecX& gradient) {
  const DofLayout& layout = system.layout;
  for (int e = 0; e < system.edge_count(); ++e) {
    const Vec3 &t0 = anchor.edges[e].t, &t = moved.edges[e].t;
    const double torque = gradient[layout.roll(e)];
    const Vec3 change = -torque * t0.cross(t) / ((1 + t0.dot(t)) * moved.edges[e].length);
    const StructureEdge& edge = system.structure.edges[e];
    gradient.segment<3>(3 * edge.node1) += change;
    gradient.segment<3>(3 * edge.node0) -= change;
  }
  for (int k = 0; k < layout.rotations(); ++k) {
    const int r = layout.rotation(layout.joint_of_rotation(k));
    gradient.segment<3>(r) = (left_jacobian(dq.segment<3>(r)).transpose() * gradient.segment<3>(r)).eval();
  }
}

}  // namespace lissom
