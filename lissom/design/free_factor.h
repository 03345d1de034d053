#pragma once
/// Cholesky factor of the part of a symmetric matrix that belongs to the parameters no bound holds.

#include <Eigen/Cholesky>
#include <vector>

#include "lissom/core/types.h"

namespace lissom {

/// Serves several sets of free parameters: as long as few of those factored are held since, they are eliminated from the old
/// factor (x_held = 0 by multipliers), which costs n^2 for each instead of n^3 / 3 for a new one.
class FreeFactor {
 public:
  /// Makes ready for the part + damping I of `b` (m x m, the lower triangle is read) of these parameters, ascending. While
  /// that is not safely positive definite the damping is raised, from 1e-10 of `largest`, the largest diagonal entry of b.
  /// `b` is to stay the same over the life of the factor.
  void prepare(const MatX& b, const std::vector<int>& free, double largest);
  /// Solves in all m parameters: those that are not free get 0 and are not read.
  VecX solve(const VecX& right) const;

  double damping() const { return damping_; }
  int factorizations() const { return factorizations_; }

 private:
  bool eliminate(const std::vector<int>& free);

  std::vector<int> factored_;  // parameters of the factor
  std::vector<int> held_;      // places among them that are held by now
  MatX part_, held_images_;    // L^-1 times the unit vectors of those held
  Eigen::LLT<MatX> llt_, held_llt_;
  double damping_ = 0;
  int factorizations_ = 0;
  bool any_ = false;
};

}  // namespace lissom
