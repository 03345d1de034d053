#pragma once
/// Brings a part of the unknowns into balance while all others are held: a small system next to the whole one, solved
/// inside a trial step so that the energies of trials are not spoiled by what is stiff and local [convergence 4, F and B;
/// section 3]. Only stencils that touch the part are assembled, and of fabrics that fold more easily than any rod no second
/// derivatives of bending.

#include <memory>
#include <optional>
#include <vector>

#include "lissom/core/linear_solver.h"
#include "lissom/equilibrium/newton_workspace.h"

namespace lissom {

/// What to do where the part by itself is not stable.
enum class Crumpled { kLeave, kMend };

class BlockRelaxer {
 public:
  /// `takes_part[i]`: unknown i (local axes) is relaxed if it `can_move` too.
  BlockRelaxer(NewtonWorkspace& workspace, const std::vector<bool>& takes_part, const std::vector<bool>& can_move);

  /// Whether there is anything to relax, and anything that is held.
  bool useful() const { return unknowns_ > 0 && unknowns_ < movable_; }

  /// To be called when the terms of the whole potential were replaced.
  void renew_terms();

  /// At most `steps` Newton steps with H + shift * metric, none of which raises the energy. Stops early where the residual
  /// is below `tolerance` (N), and where the small matrix is not positive definite unless that is to be mended by larger
  /// shifts. False when nothing was changed.
  bool relax(State& state, int steps, double shift, double tolerance, Crumpled crumpled = Crumpled::kLeave);

 private:
  double residual() const;  // of gradient_, N
  /// `added`: to the shift, before and after. False where the matrix stays indefinite.
  bool factorize(double shift, double& added, Crumpled crumpled);
  bool descend(State& state, double slope, double& energy);
  std::vector<std::unique_ptr<EnergyTerm>> touching_terms() const;

  NewtonWorkspace& workspace_;
  std::vector<int> kept_, dof_;       // unknown of the part by unknown of the whole, -1: none; and back
  int unknowns_ = 0, positions_ = 0;  // of the part; the positions come first
  int movable_ = 0;                   // of the whole
  bool folds_easily_;                 // as it was made: patterns depend on it
  std::vector<bool> touched_;
  std::optional<Potential> potential_;
  std::optional<LinearSolver> factor_;
  VecX gradient_, g_, d_, metric_, step_, increment_;
  std::vector<double> hessian_;
  State moved_;
};

/// Rolls and joint rotations: the frames.
std::vector<bool> frame_unknowns(const System& system);
/// Everything that rods have: positions of their nodes, rolls and joint rotations.
std::vector<bool> rod_unknowns(const System& system);

}  // namespace lissom
