#pragma once
/// The matrix of sum (1 / l) |x1 - x0|^2 over the rod edges, for the free positions of a problem: fits positions to wanted
/// edges (step_path.h) and smooths fields of displacements (start_smoothing.h).

#include <optional>
#include <vector>

#include "lissom/core/linear_solver.h"
#include "lissom/equilibrium/static_problem.h"

namespace lissom {

class EdgeLaplacian {
 public:
  explicit EdgeLaplacian(const StaticProblem& problem);

  /// Factorises the matrix plus `pull` (1/m^2) times the length of rod that belongs to each node. Without a pull it is
  /// almost singular where supports leave rigid motions; false when it cannot be used.
  bool factorize(double pull);

  /// Positions (entries of all unknowns, global axes; held ones and other unknowns 0) for right sides of the same form.
  void solve(const VecX& right_side, VecX& positions);

  /// 1/m per edge.
  const std::vector<double>& weights() const { return weights_; }

 private:
  const StaticProblem& problem_;
  int positions_ = 0;
  std::vector<double> weights_, values_, metric_;
  std::vector<int> kept_;
  std::optional<LinearSolver> solver_;
  VecX b_, work_;
};

}  // namespace lissom
