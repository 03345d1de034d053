#pragma once
/// Balances rolls and joint rotations with all positions held: a small system next to the whole one, solved inside a
/// trial step so that energies of trials are not spoiled by frames that lag behind [convergence 4, F].

#include <optional>

#include "lissom/core/linear_solver.h"
#include "lissom/equilibrium/newton_workspace.h"

namespace lissom {

class FrameRelaxer {
 public:
  explicit FrameRelaxer(NewtonWorkspace& workspace);

  /// At most this many Newton steps; stops early where the small system is not positive definite.
  void relax(State& state, int steps);

 private:
  NewtonWorkspace& workspace_;
  std::vector<int> kept_;
  int unknowns_ = 0;
  std::optional<LinearSolver> factor_;
  AssemblyBuffers buffers_;
  VecX gradient_, b_, increment_;
  std::vector<double> hessian_;
  State moved_;
};

}  // namespace lissom
