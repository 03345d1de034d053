/// The equations of motion of one step and Newton's corrections to its increment. Part of integrator.h.

#include <algorithm>
#include <cmath>

#include "lissom/motion/integrator.h"

namespace lissom {

/// State, velocities and residual that belong to increment_.
bool Integrator::evaluate(double dt, With with) {
  const double part = 1 - alpha_.alpha_f;
  global_ = increment_;
  problem_.potential.to_global(global_);
  if (!advance(*problem_.system, state_, global_, middle_, context_.threads)) return false;
  middle_.load_factor = history_.at(time_ + part * dt);
  if (with == With::kHessian) {
    problem_.potential.hessian(middle_, gradient_, hessian_, buffers_, context_.threads);
  } else {
    problem_.potential.gradient(middle_, gradient_, buffers_, context_.threads);
  }

  const Eigen::Index n = mass_.size();
  const std::span<const int> kept = problem_.supports.kept();
  for (VecX* v :
       {&whole_, &next_velocity_, &next_acceleration_, &attempt_acceleration_, &middle_velocity_, &residual_}) {
    v->resize(n);
  }
  const double from_whole = 1 / (alpha_.beta * dt * dt), from_velocity = 1 / (alpha_.beta * dt);
  const double from_acceleration = 1 / (2 * alpha_.beta) - 1;
  force_scale_ = problem_.scales.force;
  for (Eigen::Index i = 0; i < n; ++i) {
    double a = 0, v = 0, a_middle = 0, v_middle = 0, whole = 0;
    if (kept[i] < 0) {
      whole = prescribed_whole_[i];
      v = v_middle = whole / dt;
    } else if (mass_[i] > 0) {
      whole = increment_[i] / part;
      a = from_whole * whole - from_velocity * velocity_[i] - from_acceleration * acceleration_[i];
      v = velocity_[i] + dt * ((1 - alpha_.gamma) * acceleration_[i] + alpha_.gamma * a);
      a_middle = (1 - alpha_.alpha_m) * a + alpha_.alpha_m * acceleration_[i];
      v_middle = part * v + alpha_.alpha_f * velocity_[i];
    } else {
      whole = increment_[i];  // the end is extrapolated once the middle is known
      v_middle = increment_[i] / (part * dt);
    }
    whole_[i] = whole;
    next_velocity_[i] = v;
    next_acceleration_[i] = a;
    attempt_acceleration_[i] = a_middle;
    middle_velocity_[i] = v_middle;
    const double inertia = mass_[i] * (a_middle + options_.mass_damping * v_middle);
    residual_[i] = gradient_[i] + inertia;
    if (i < 3 * problem_.system->layout.nodes()) force_scale_ = std::max(force_scale_, std::abs(inertia));
  }
  if (stiffness_used_) {
    multiply(problem_.potential.pattern(), stiffness_, middle_velocity_, drag_);
    drag_ *= options_.stiffness_damping;
    residual_ += drag_;
  }
  if (options_.roll_inertia == RollInertia::kLumped) add_gyroscopic();
  problem_.supports.restrict(residual_, free_);
  return free_.allFinite();
}

/// The couple I w dt/dt that turning the spin of an edge takes, as a pair of forces on its nodes.
void Integrator::add_gyroscopic() {
  const System& system = *problem_.system;
  global_ = middle_velocity_;
  problem_.potential.to_global(global_);
  couple_.setZero(mass_.size());
  for (int e = 0; e < system.edge_count(); ++e) {
    const StructureEdge& edge = system.structure.edges[e];
    const EdgeState& now = middle_.edges[e];
    const double spin = system.rest.edges[e].roll_inertia * global_[system.layout.roll(e)];
    const Vec3 de = global_.segment<3>(3 * edge.node1) - global_.segment<3>(3 * edge.node0);
    const Vec3 force = spin / (now.length * now.length) * de.cross(now.t);
    couple_.segment<3>(3 * edge.node1) += force;
    couple_.segment<3>(3 * edge.node0) -= force;
  }
  problem_.potential.to_local(couple_);
  residual_ += couple_;
}

bool Integrator::factorize(double dt) {
  const std::span<const double> metric(free_mass_.data(), static_cast<size_t>(free_mass_.size()));
  const double drag = alpha_.gamma / (alpha_.beta * dt);
  shift_ = (1 - alpha_.alpha_m) / ((1 - alpha_.alpha_f) * alpha_.beta * dt * dt) + drag * options_.mass_damping;
  if (stiffness_used_) {
    matrix_.resize(hessian_.size());
    for (size_t i = 0; i < hessian_.size(); ++i) {
      matrix_[i] = hessian_[i] + drag * options_.stiffness_damping * stiffness_[i];
    }
  }
  // A guess may compress edges so much that they would buckle within the step; heavier unknowns make the correction
  // shorter, and the next ones start from better guesses.
  for (int attempt = 0; attempt < 4; ++attempt, shift_ *= 4) {
    const FactorReport report = factor_.factorize(stiffness_used_ ? matrix_ : hessian_, shift_, metric);
    if (report.complete && report.positive_definite) return true;
  }
  return false;
}

/// Rotation vectors of joints are added, not composed: exp([r + w]) differs from exp([w]) exp([r]) by r x w / 2. The
/// residual is that of the state moved by the whole increment, so this has no part in what is found, only in the way there
/// (measured in docs/energies/motion.md).
void Integrator::correct() {
  factor_.solve(free_, free_);
  const std::span<const int> kept = problem_.supports.kept();
  for (Eigen::Index i = 0; i < increment_.size(); ++i) {
    if (kept[i] >= 0) increment_[i] -= free_[kept[i]];
  }
}

/// Largest force, or moment over the mean edge length, N.
double Integrator::size_of(const VecX& free) const {
  const System& system = *problem_.system;
  const std::span<const int> kept = problem_.supports.kept();
  double force = 0, moment = 0;
  for (int i = 0; i < static_cast<int>(kept.size()); ++i) {
    if (kept[i] < 0) continue;
    double& largest = system.layout.dof_class(i) == DofClass::kPosition ? force : moment;
    largest = std::max(largest, std::abs(free[kept[i]]));
  }
  return std::max(force, moment / system.rest.mean_edge_length);
}

}  // namespace lissom
