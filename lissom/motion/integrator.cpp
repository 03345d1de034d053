#include "lissom/motion/integrator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lissom {

namespace {

constexpr int kMaxIterations = 20;
constexpr double kTolerance = 1e-6;   ///< of the residual, relative to the largest force in the step
constexpr double kContraction = 0.1;  ///< slower convergence than this asks for a new factor
constexpr double kLargestTurn = 0.8;  ///< rad, of an edge or a roll in one step

}  // namespace

Integrator::Integrator(const StaticProblem& problem, const LoadHistory& history, const IntegratorOptions& options,
                       const Context& context)
    : problem_(problem),
      history_(history),
      options_(options),
      alpha_(options.rho_infinity),
      context_(context),
      factor_(problem.potential.pattern(), problem.supports.kept()),
      moving_(problem.supports.moves() && !history.constant()),
      mass_(lumped_mass(*problem.system, options.roll_inertia)) {
  problem_.supports.restrict(mass_, free_mass_);
  split_loads();
  massless_.assign(mass_.size(), -1);
  const std::span<const int> kept = problem_.supports.kept();
  int count = 0;
  for (Eigen::Index i = 0; i < mass_.size(); ++i) {
    if (kept[i] >= 0 && mass_[i] <= 0) massless_[i] = count++;
  }
  if (count > 0) massless_factor_.emplace(problem_.potential.pattern(), massless_);
}

/// Dead loads are linear in the unknowns: their forces at load factors 0 and 1 say everything.
void Integrator::split_loads() {
  const auto loads_at = [&](double load_factor, VecX& load) {
    State state = drawn_state(*problem_.system);
    state.load_factor = load_factor;
    load = VecX::Zero(mass_.size());
    for (const auto& term : problem_.potential.terms()) {
      if (term->has_hessian()) continue;
      const int n = term->dofs();
      buffers_.gradient.resize(static_cast<size_t>(term->groups()) * kLanes * n);
      term->derivatives(state, 0, term->groups(), buffers_.gradient.data(), nullptr);
      for (int s = 0; s < term->stencils(); ++s) {
        for (int i = 0; i < n; ++i) {
          const size_t place = static_cast<size_t>(s) * n + i;
          load[term->indices()[s * n + i]] -= buffers_.gradient[place];
        }
      }
    }
    problem_.potential.to_local(load);
  };
  loads_at(0, constant_load_);
  loads_at(1, proportional_load_);
  proportional_load_ -= constant_load_;
}

void Integrator::begin(const State& state, const VecX& velocity) {
  const Eigen::Index n = mass_.size();
  time_ = last_step_ = middle_time_ = 0;
  state_ = state;
  state_.load_factor = history_.at(0);
  velocity_ = velocity;
  problem_.potential.to_local(velocity_);
  acceleration_ = rate_ = VecX::Zero(n);
  prescribed_middle_ = prescribed_whole_ = VecX::Zero(n);
  ledger_ = {};
  stiffness_known_ = false;
  problem_.potential.gradient(state_, gradient_, buffers_, context_.threads);
  const std::span<const int> kept = problem_.supports.kept();
  for (Eigen::Index i = 0; i < n; ++i) {
    if (kept[i] < 0 || mass_[i] <= 0) {
      velocity_[i] = 0;
    } else {
      acceleration_[i] = -gradient_[i] / mass_[i] - options_.mass_damping * velocity_[i];
    }
  }
  middle_acceleration_ = acceleration_;
}

void Integrator::predict(double dt) {
  const double whole = dt, middle = (1 - alpha_.alpha_f) * dt;
  if (moving_) {
    problem_.supports.prescribed_increment(*problem_.system, state_, history_.at(time_ + middle), prescribed_middle_);
    problem_.supports.prescribed_increment(*problem_.system, state_, history_.at(time_ + whole), prescribed_whole_);
    problem_.potential.to_local(prescribed_middle_);
    problem_.potential.to_local(prescribed_whole_);
  }
  increment_.resize(mass_.size());
  const std::span<const int> kept = problem_.supports.kept();
  const double lead = last_step_ > 0 ? dt / 2 : 0;  // the first acceleration may be that of a sudden release
  for (Eigen::Index i = 0; i < mass_.size(); ++i) {
    increment_[i] = kept[i] < 0    ? prescribed_middle_[i]
                    : mass_[i] > 0 ? middle * (velocity_[i] + lead * middle_acceleration_[i])
                                   : middle * rate_[i];
  }
}

StepAttempt Integrator::attempt(double dt) {
  StepAttempt result;
  step_ = dt;
  if (options_.stiffness_damping > 0 && !stiffness_known_) {
    problem_.potential.hessian(state_, gradient_, stiffness_, buffers_, context_.threads);
    multiply(problem_.potential.pattern(), stiffness_, velocity_, image_);
    stiffness_known_ = true;
    stiffness_used_ = velocity_.dot(image_) >= 0;
  }
  predict(dt);
  if (!evaluate(dt, With::kHessian) || !factorize(dt)) return result;
  double residual = size_of(free_);
  for (;;) {
    ++result.iterations;
    correct();
    if (!evaluate(dt, With::kGradient)) return result;
    const double before = std::exchange(residual, size_of(free_));
    const double rounding = 10 * problem_.scales.rounding;
    if (residual <= std::max(kTolerance * force_scale_, rounding)) break;
    if (result.iterations >= kMaxIterations) return result;
    if (residual > kContraction * before && (!evaluate(dt, With::kHessian) || !factorize(dt))) return result;
  }
  result.residual = residual;

  // Unknowns without mass: on a straight line through their last two equilibria.
  const double part = 1 - alpha_.alpha_f;
  const double since = part * dt + time_ - middle_time_;
  next_rate_ = rate_;
  const std::span<const int> kept = problem_.supports.kept();
  for (Eigen::Index i = 0; i < mass_.size(); ++i) {
    if (kept[i] < 0 || mass_[i] > 0) continue;
    next_rate_[i] = (increment_[i] + rate_[i] * (time_ - middle_time_)) / since;
    whole_[i] = increment_[i] + next_rate_[i] * alpha_.alpha_f * dt;
  }
  global_ = whole_;
  problem_.potential.to_global(global_);
  const double roll = global_.tail(global_.size() - 3 * problem_.system->layout.nodes()).cwiseAbs().maxCoeff();
  if (largest_turn(*problem_.system, state_, global_) > kLargestTurn || roll > kLargestTurn) return result;
  if (!advance(*problem_.system, state_, global_, next_, context_.threads)) return result;
  next_.load_factor = history_.at(time_ + dt);
  estimate_error(dt, result);
  balance();
  result.converged = true;
  return result;
}

/// error_constant dt^3 da/dt from two successive accelerations, where (K + shift M)^-1 shift M takes out the vibrations that
/// the step does not resolve [after Shampine's estimate for stiff equations].
void Integrator::estimate_error(double dt, StepAttempt& result) {
  const double since = (1 - alpha_.alpha_f) * dt + time_ - middle_time_;
  const double scale = alpha_.error_constant() * dt * dt * dt / since * shift_;
  error_.resize(mass_.size());
  for (Eigen::Index i = 0; i < mass_.size(); ++i) {
    error_[i] = scale * mass_[i] * (attempt_acceleration_[i] - middle_acceleration_[i]);
  }
  problem_.supports.restrict(error_, free_);
  factor_.solve(free_, free_);
  problem_.supports.expand(free_, error_);
  const DofLayout& layout = problem_.system->layout;
  for (int i = 0; i < layout.nodes(); ++i) {
    result.error = std::max(result.error, error_.segment<3>(3 * i).norm() / problem_.scales.length);
  }
  if (options_.roll_inertia == RollInertia::kNone) return;
  result.error = std::max(result.error, error_.segment(3 * layout.nodes(), layout.edges()).cwiseAbs().maxCoeff());
}

/// Work and dissipation of the attempt. The difference between the kinetic energy gained and the work of the forces is
/// exact; that of the potential energy is the linear one, (1/2 - alpha_f) dq' K dq: what is left is the error of the method.
void Integrator::balance() {
  gains_ = {};
  const double load = middle_.load_factor;
  const std::span<const int> kept = problem_.supports.kept();
  double kinetic = 0;
  for (Eigen::Index i = 0; i < mass_.size(); ++i) {
    gains_.load_work += (constant_load_[i] + load * proportional_load_[i]) * whole_[i];
    const double drag = mass_[i] * options_.mass_damping * middle_velocity_[i] + (stiffness_used_ ? drag_[i] : 0);
    if (kept[i] < 0) {
      gains_.support_work += (gradient_[i] + (stiffness_used_ ? drag_[i] : 0)) * whole_[i];
      if (stiffness_used_) gains_.rayleigh_loss += drag_[i] * whole_[i];
      continue;
    }
    gains_.rayleigh_loss += drag * whole_[i];
    kinetic += mass_[i] * (attempt_acceleration_[i] * whole_[i] -
                           (next_velocity_[i] + velocity_[i]) / 2 * (next_velocity_[i] - velocity_[i]));
  }
  if (alpha_.alpha_f == 0.5) return;
  multiply(problem_.potential.pattern(), hessian_, whole_, image_);
  gains_.numerical_loss = kinetic + (0.5 - alpha_.alpha_f) * whole_.dot(image_);
}

void Integrator::accept() {
  middle_time_ = time_ + (1 - alpha_.alpha_f) * step_;
  time_ += step_;
  last_step_ = step_;
  std::swap(state_, next_);
  std::swap(velocity_, next_velocity_);
  std::swap(acceleration_, next_acceleration_);
  std::swap(rate_, next_rate_);
  std::swap(middle_acceleration_, attempt_acceleration_);
  ledger_.load_work += gains_.load_work;
  ledger_.support_work += gains_.support_work;
  ledger_.rayleigh_loss += gains_.rayleigh_loss;
  ledger_.numerical_loss += gains_.numerical_loss;
  stiffness_known_ = false;
}

void Integrator::settle(State& settled) {
  settled = state_;
  if (!massless_factor_) return;
  // Newton on few decoupled unknowns that are close to their equilibrium already. A state in which it fails is a good one
  // still: only its joints are those extrapolated.
  double last = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    problem_.potential.hessian(settled, gradient_, hessian_, buffers_, context_.threads);
    free_.resize(massless_factor_->unknowns());
    for (Eigen::Index i = 0; i < mass_.size(); ++i) {
      if (massless_[i] >= 0) free_[massless_[i]] = -gradient_[i];
    }
    const double size = free_.cwiseAbs().maxCoeff();
    if (size <= kTolerance * problem_.scales.moment || !(size < last)) return;
    last = size;
    const FactorReport report = massless_factor_->factorize(hessian_);
    if (!report.complete || !report.positive_definite) return;
    massless_factor_->solve(free_, free_);
    global_.resize(mass_.size());
    for (Eigen::Index i = 0; i < mass_.size(); ++i) global_[i] = massless_[i] >= 0 ? free_[massless_[i]] : 0;
    problem_.potential.to_global(global_);
    if (global_.cwiseAbs().maxCoeff() > kLargestTurn) return;
    if (!advance(*problem_.system, settled, global_, next_, context_.threads)) return;
    std::swap(settled, next_);
  }
}

VecX Integrator::velocity() const {
  VecX velocity = velocity_;
  problem_.potential.to_global(velocity);
  return velocity;
}

double Integrator::kinetic_energy(int begin, int end) const {
  const std::span<const int> kept = problem_.supports.kept();
  double energy = 0;
  for (int i = begin; i < end; ++i) {
    if (kept[i] >= 0) energy += mass_[i] * velocity_[i] * velocity_[i] / 2;
  }
  return energy;
}

double Integrator::translation_energy() const { return kinetic_energy(0, 3 * problem_.system->layout.nodes()); }

double Integrator::roll_energy() const {
  const DofLayout& layout = problem_.system->layout;
  return kinetic_energy(3 * layout.nodes(), 3 * layout.nodes() + layout.edges());
}

}  // namespace lissom
