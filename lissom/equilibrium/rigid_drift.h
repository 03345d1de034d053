#pragma once
/// Parts that nothing holds have rigid motions that cost no energy; six unknowns are held so that the Hessian is regular.
/// A step then contains a rigid motion that says nothing but where these six lie, and large rotations spoil its
/// linearisation. It is taken out of the step here: the part turns as little as it can.

#include <vector>

#include "lissom/equilibrium/static_problem.h"

namespace lissom {

class RigidDrift {
 public:
  explicit RigidDrift(const StaticProblem& problem);

  /// Removes the rigid motions of free parts from an increment at `state` (all unknowns, global axes): rotations of the
  /// joints and spins of the edges along with the positions, so that strains to first order stay.
  void remove(const State& state, VecX& dq) const;

  /// Per unknown: whether it is free, or held only because a rigid motion was taken out.
  const std::vector<bool>& can_move() const { return can_move_; }

 private:
  struct Part {
    std::vector<int> nodes, edges, joints;
  };

  const System& system_;
  std::vector<Part> parts_;
  std::vector<double> weight_;  // per node
  std::vector<bool> can_move_;
};

/// What each node counts in means over a structure: all alike where rods, triangles and tetrahedra are alike.
std::vector<double> node_weights(const System& system);

/// Lays the free parts of a state where they are closest to the drawn shape: of all places the one that people expect.
void lay_down(const StaticProblem& problem, State& state);
/// Whether it does so: the structure is in one piece, and nothing holds it.
bool can_be_laid_down(const StaticProblem& problem);

}  // namespace lissom
