#pragma once
/// One implicit time step after the other: generalised-alpha on the exact energies of a pose.
///
/// Unknowns with mass (positions, rolls) have velocities; joint rotations, and rolls without inertia, are in equilibrium
/// with the rest at the time at which the forces are evaluated, and are extrapolated from there to the end of the step.
/// An edge with roll inertia that spins and turns exerts the gyroscopic couple I w dt/dt on its nodes, so that angular
/// momentum with its spin is conserved; that couple does no work.
///
/// Rayleigh damping: mass_damping M v + stiffness_damping K v, K the Hessian at the beginning of the step. K may have
/// negative directions (a structure that buckles); in a step that begins with v' K v < 0 its part is left out, because it
/// would feed energy.
///
/// Newton's method keeps a factor while the residual falls at least tenfold per iteration.

#include <optional>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/core/linear_solver.h"
#include "lissom/equilibrium/static_problem.h"
#include "lissom/motion/generalized_alpha.h"
#include "lissom/motion/load_history.h"
#include "lissom/motion/mass.h"

namespace lissom {

struct IntegratorOptions {
  double rho_infinity = 1;       ///< 0..1, of generalised-alpha
  double mass_damping = 0;       ///< 1/s
  double stiffness_damping = 0;  ///< s
  RollInertia roll_inertia = RollInertia::kLumped;
};

/// What has gone in and out since the start, J.
struct EnergyLedger {
  double load_work = 0;       ///< done by loads
  double support_work = 0;    ///< done by moving supports
  double rayleigh_loss = 0;   ///< dissipated by Rayleigh damping
  double numerical_loss = 0;  ///< dissipated by the method when rho < 1
};

/// Outcome of an attempted step.
struct StepAttempt {
  bool converged = false;
  int iterations = 0;
  double error = 0;     ///< estimated local error: largest of |x| over the size of the structure, and of rolls in rad
  double residual = 0;  ///< N
};

class Integrator {
 public:
  /// Refers to the problem and the history; both have to outlive it.
  Integrator(const StaticProblem& problem, const LoadHistory& history, const IntegratorOptions& options,
             const Context& context);

  /// Starts at time 0. `velocity`: per unknown, global axes; those of held unknowns are ignored.
  void begin(const State& state, const VecX& velocity);

  /// Tries a step of dt (s) without changing the present state.
  StepAttempt attempt(double dt);
  /// Makes the converged attempt the present state.
  void accept();
  /// Replaces a time that is right up to rounding by the exact one.
  void set_time(double time) { time_ = time; }

  /// The present state with the unknowns that have no mass brought into equilibrium: what is recorded. The steps
  /// themselves need only those of the middle.
  void settle(State& settled);

  double time() const { return time_; }
  const State& state() const { return state_; }
  VecX velocity() const;                      ///< per unknown, global axes; 0 for joint rotations
  const VecX& mass() const { return mass_; }  ///< per unknown
  const EnergyLedger& ledger() const { return ledger_; }
  /// Kinetic energy of the free unknowns, J: of positions, and of rolls.
  double translation_energy() const;
  double roll_energy() const;

 private:
  enum class With { kGradient, kHessian };

  void split_loads();
  void predict(double dt);
  bool evaluate(double dt, With with);
  bool factorize(double dt);
  void correct();
  void add_gyroscopic();
  void estimate_error(double dt, StepAttempt& result);
  void balance();
  double size_of(const VecX& free) const;
  double kinetic_energy(int begin, int end) const;

  const StaticProblem& problem_;
  const LoadHistory& history_;
  IntegratorOptions options_;
  GeneralizedAlpha alpha_;
  Context context_;
  LinearSolver factor_;
  std::optional<LinearSolver> massless_factor_;
  std::vector<int> massless_;  ///< per unknown: its number among the free ones without mass, or -1
  bool moving_ = false;
  AssemblyBuffers buffers_;
  // Vectors have one entry per unknown of the layout, in local axes, unless they are called free.
  VecX mass_, free_mass_, constant_load_, proportional_load_;

  // Present state.
  double time_ = 0, last_step_ = 0, middle_time_ = 0;
  State state_;
  VecX velocity_, acceleration_;
  VecX rate_;                 ///< of unknowns without mass, 1/s
  VecX middle_acceleration_;  ///< the last one, evaluated at middle_time_
  EnergyLedger ledger_;
  std::vector<double> stiffness_;  ///< Hessian at the beginning of the step, for damping
  bool stiffness_known_ = false, stiffness_used_ = false;

  // The attempt.
  double step_ = 0, force_scale_ = 0, shift_ = 0;
  State middle_, next_;
  VecX increment_, whole_;  ///< from the present state to the middle, and to the end
  VecX prescribed_middle_, prescribed_whole_, global_;
  VecX next_velocity_, next_acceleration_, next_rate_, attempt_acceleration_, middle_velocity_;
  VecX gradient_, residual_, drag_, couple_, image_, free_, error_;
  std::vector<double> hessian_, matrix_;
  EnergyLedger gains_;
};

}  // namespace lissom
