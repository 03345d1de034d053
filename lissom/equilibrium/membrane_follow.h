#pragma once
/// Lets membranes follow their rods: displacements that are given at the nodes of rods are spread over the rest of the
/// membranes as harmonic functions of the drawn shape [convergence 4, R].

#include <optional>
#include <vector>

#include "lissom/core/linear_solver.h"
#include "lissom/equilibrium/static_problem.h"

namespace lissom {

class MembraneFollow {
 public:
  /// `can_move`: per unknown, see RigidDrift.
  MembraneFollow(const StaticProblem& problem, const std::vector<bool>& can_move);

  /// Overwrites the positions of all nodes off the rods in `displacement` (global axes, all unknowns); what cannot
  /// move stays 0.
  void spread(VecX& displacement);

 private:
  struct Side {
    int a, b;
    double weight;
  };

  const StaticProblem& problem_;
  std::vector<bool> can_move_;
  std::vector<int> number_;  // per node: its number among the following ones, or -1
  int following_ = 0;
  std::vector<Side> sides_;
  std::optional<LinearSolver> solver_;
  MatX b_;
};

}  // namespace lissom
