#pragma once
/// A static solver that stays with its problem: patterns, symbolic factors and the last factor serve for the next solve, so
/// that a structure whose numbers change a little settles in a few hundredths of a second [convergence 5].

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/equilibrium/equilibrium.h"
#include "lissom/equilibrium/minimizer.h"
#include "lissom/equilibrium/options.h"

namespace lissom {

/// How an equilibrium followed a change: a shape that lands far from its first-order prediction, or that lost its stability
/// on the way, is another branch.
struct Following {
  double predicted = 0;  ///< m, root mean square over nodes, of the prediction
  double moved = 0;      ///< m, of what happened
  bool jumped = false;
};

class LiveSolver {
 public:
  /// The problem has to outlive the solver; its terms may be replaced in between (renew_terms).
  LiveSolver(const StaticProblem& problem, const SolveOptions& options, const Context& context = {});
  LiveSolver(const LiveSolver&) = delete;
  LiveSolver& operator=(const LiveSolver&) = delete;

  /// Brings `start` to `load_factor` and into equilibrium. Never returns a state that is not finite. `strains`: axial
  /// strains of the edges, where they are known better than the places in `start` tell.
  Equilibrium settle(const State& start, double load_factor, std::span<const double> strains = {});

  /// Follows a small change of the problem's numbers, or of the places that it holds, from an equilibrium of the old ones, at
  /// its load factor: first-order prediction with the factor at hand, then steps by conjugate gradients on it, new factors only where these fail.
  /// `max_iterations`, where given, is less than that of the options: what has not come to rest by then has not followed.
  Equilibrium resettle(const State& before, std::optional<int> max_iterations = {});

  /// Stands at an equilibrium of the present numbers, found before: makes its factor and forgets all other history, so that what
  /// `resettle` does next depends on this state alone. False where its Hessian is not positive definite.
  [[nodiscard]] bool take_up(const State& equilibrium);

  /// Who looks at the states on the way; see NewtonWorkspace.
  void set_watch(NewtonWorkspace::Watch watch) { workspace_.set_watch(std::move(watch)); }

  /// The factor of the last state that was found stable or taken up.
  LinearSolver& factor() { return workspace_.factor(); }
  /// Whether there is one, without a shift.
  bool stands() const { return workspace_.has_plain_factor(); }
  int factorizations() const { return workspace_.factorizations(); }

  /// To be called after the terms of the problem's potential were replaced.
  void renew_terms();

  /// What became of the last resettle.
  const Following& following() const { return following_; }

 private:
  double tolerance() const;
  Equilibrium descend(Equilibrium result, FirstStep first, int max_iterations, std::span<const double> strains);
  void remember_strains(const State& state);
  Equilibrium finish(Equilibrium result, Verdict verdict);

  const StaticProblem& problem_;
  SolveOptions options_;
  Context context_;
  NewtonWorkspace workspace_;
  std::optional<Minimizer> minimizer_;
  Following following_;
  std::vector<double> strains_;  // axial, of the edges in the last equilibrium
  int factorizations_before_ = 0;
};

}  // namespace lissom
