#pragma once
/// The goals of one pose as functions of the parameters alone, at an equilibrium: residuals r(p), their first derivatives by
/// forward or adjoint products, and the exact Hessian of 1/2 |r|^2 times a vector [mathematics 5.1, 5.2].

#include <vector>

#include "lissom/design/goal.h"
#include "lissom/design/sensitivity.h"

namespace lissom {

/// An equilibrium of a design and where its design comes from. Nothing is owned.
struct DesignPose {
  const Design& design;
  const DesignSpace& space;
  const VecX& p;
  const DesignJacobian& jacobian;
  int pose;
  const StaticProblem& problem;
  const State& state;

  PoseShape shape() const { return {design, design.model.poses[static_cast<std::size_t>(pose)], problem, state}; }
};

class PoseLinearization {
 public:
  /// Goals are those of this pose. All arguments have to outlive the linearization; the factor is that of the Hessian at the
  /// equilibrium. Errors are those of Sensitivity.
  static Result<PoseLinearization> make(const DesignPose& point, const LinearSolver& factor,
                                        std::vector<const Goal*> goals);

  const VecX& residual() const { return residual_; }

  /// J v and J' w, one back solve each.
  VecX times(const VecX& v) const;
  VecX transposed_times(const VecX& w) const;
  /// J, (residuals x m), by as many back solves as it has rows or columns, whichever are fewer.
  MatX dense() const;

  /// Hessian of 1/2 |r|^2 times v: three back solves and third derivatives of the energy.
  VecX hessian_times(const VecX& v, ThreadPool* threads = nullptr) const;

 private:
  PoseLinearization(const DesignPose& point, std::vector<const Goal*> goals, Sensitivity sensitivity)
      : point_(point), goals_(std::move(goals)), sensitivity_(std::move(sensitivity)) {}
  void evaluate_goals();

  DesignPose point_;
  std::vector<const Goal*> goals_;
  Sensitivity sensitivity_;
  VecX residual_;
  SparseRows by_q_, by_numbers_;  // of all residuals; columns: unknowns (global axes), numbers
};

}  // namespace lissom
