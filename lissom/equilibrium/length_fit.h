#pragma once
/// Moves the nodes of rods, as little as possible, so that every edge has the axial strain that a step wants it to have:
/// Gauss-Newton on sum 1/(2 l) |e - e'|^2 + kappa l / 2 (eps - eps*)^2 [convergence 4, R]. Membranes follow.

#include <optional>
#include <span>
#include <vector>

#include "lissom/core/linear_solver.h"
#include "lissom/equilibrium/membrane_follow.h"
#include "lissom/equilibrium/static_problem.h"

namespace lissom {

class LengthFit {
 public:
  /// `can_move`: per unknown, see RigidDrift.
  LengthFit(const StaticProblem& problem, const std::vector<bool>& can_move, ThreadPool* threads = nullptr);

  /// Corrects `increment`, the straight trial a d or one with a second-order part, of the step d from `state` (global
  /// axes). `arrival`: axial strain of each edge at the end of the step; empty: what d brings about to first order. False
  /// when the trial cannot be mended.
  [[nodiscard]] bool mend(const State& state, double a, const VecX& d, std::span<const double> arrival,
                          VecX& increment);

 private:
  const StaticProblem& problem_;
  std::vector<int> kept_;
  std::vector<Mat3> axes_;    // per node, of its local axes
  std::vector<bool> turned_;  // nodes whose axes are not x, y, z
  std::vector<int> slots_;    // of the blocks of each edge, in the order in which they are filled
  std::optional<LinearSolver> solver_;
  MembraneFollow follow_;
  std::vector<double> values_, metric_, target_;
  std::vector<Vec3> trial_, edge_;
  VecX force_, b_, mended_, work_;
};

}  // namespace lissom
