#pragma once
/// Energy minimisation by Newton's method with exact Hessians [mathematics 4; convergence 4].

#include <optional>
#include <span>

#include "lissom/equilibrium/block_relaxation.h"
#include "lissom/equilibrium/conjugate_gradients.h"
#include "lissom/equilibrium/equilibrium.h"
#include "lissom/equilibrium/newton_workspace.h"
#include "lissom/equilibrium/options.h"
#include "lissom/equilibrium/shift.h"
#include "lissom/equilibrium/step_path.h"

namespace lissom {

/// How an iteration over states ended; the state and its records are in the caller's hands.
struct Descent {
  Verdict verdict = Verdict::kBadStart;  ///< kStable stands for "converged": stability has not been looked at yet
  int iterations = 0;
  double residual = 0;  ///< N
};

/// Where the first step of a minimisation comes from.
enum class FirstStep {
  kNewton,
  kFactorAtHand,  ///< from the factor that the workspace holds: first-order prediction after a change of rest numbers
};

/// Lowers energies again and again with the same buffers, patterns and symbolic factors.
class Minimizer {
 public:
  Minimizer(NewtonWorkspace& workspace, const SolveOptions& options);

  /// Lowers the energy of `state` at its load factor until the residual is below `tolerance` (N). `arrival`: axial strains
  /// of the edges where a prediction is expected to end, those of the equilibrium before the change: the prediction itself
  /// knows them to first order in the new rest lengths only, which for stiff rods is not enough. Where the first step is
  /// none, edges are brought to them before it.
  Descent run(State& state, double tolerance, int max_iterations, std::vector<IterationRecord>& records,
              FirstStep first = FirstStep::kNewton, std::span<const double> arrival = {});

  /// To be called when the terms of the potential were replaced.
  void renew_terms();

  /// Forgets what runs before have taught, so that the next one depends on its arguments and on the factor at hand alone.
  void forget() { shift_ = ShiftPolicy(options_.shift); }

  /// m, root mean square over nodes of the last first-order prediction, whole; 0 when the last run made none.
  double predicted_move() const { return predicted_move_; }

 private:
  bool newton_step();
  /// Of the matrix that gave the present step.
  double shift() const { return own_factor_ ? shift_.shift() : 0; }
  double try_at(double a);
  bool line_search(double slope, double curvature, double reach);
  void expand(double slope, double turn, double roll);
  /// Gives the edges of the state these axial strains, with as little motion as can be.
  void fit_lengths(std::span<const double> strains);
  /// Moves the accepted trial away from the saddle point that it approaches.
  void leave_saddle();

  NewtonWorkspace& workspace_;
  SolveOptions options_;
  StepPathPolicy path_;
  ShiftPolicy shift_;
  ConjugateGradients cg_;
  std::optional<BlockRelaxer> frames_, rods_;
  State* state_ = nullptr;
  State trial_, best_;
  VecX free_, step_, image_;
  double energy_ = 0, trial_energy_ = 0, taken_ = 0, tolerance_ = 0;
  double residual_ = 0;  // N, where the step at hand begins
  double predicted_move_ = 0;
  int chords_ = 0;        // steps of this run that took an old factor as it is
  int crawling_ = 0;      // small steps in a row while some direction has negative curvature
  bool escapes_ = false;  // saddle points on the way are left; where there are membranes
  bool first_trial_ = false;
  bool reuse_ = false;      // factors may serve for later states
  bool stale_ = false;      // the one in the workspace is to be tried
  bool predict_ = false;    // the next step is to be a prediction
  bool predicted_ = false;  // the present one is
  bool own_factor_ = true;  // the present step has its own
};

/// The same once.
Descent minimize(NewtonWorkspace& workspace, State& state, double tolerance, const SolveOptions& options,
                 int max_iterations, std::vector<IterationRecord>& records);

/// Brings prescribed unknowns and loads of `state` to `load_factor`: steps of linear prediction, small enough in turns and
/// strains that the structure can follow, each but the last one relaxed roughly. Loads alone are set at once. kStable
/// stands for "arrived"; the residual is not looked at.
Descent move_to_load(NewtonWorkspace& workspace, State& state, double load_factor, double tolerance,
                     const SolveOptions& options, int max_iterations, std::vector<IterationRecord>& records);

}  // namespace lissom
