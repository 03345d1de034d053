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
  /// d r / d unknowns (residuals x unknowns, global axes) and d r / d numbers (residuals x those of Sensitivity::numbers), each
  /// at fixed others.
  const SparseRows& by_q() const { return by_q_; }
  const SparseRows& by_numbers() const { return by_numbers_; }
  const Sensitivity& sensitivity() const { return sensitivity_; }

  /// J v and J' w, one back solve each.
  VecX times(const VecX& v) const;
  VecX transposed_times(const VecX& w) const;
  /// J, (residuals x m), by as many back solves as it has rows or columns, whichever are fewer.
  MatX dense() const;

  /// Second derivatives of the Lagrangian 1/2 |r|^2 + multiplier' (gradient of the energy) along increments dq of all
  /// unknowns (global axes), those that are held included, and v of the parameters. The multiplier (unknowns, local axes, 0
  /// where held) is fixed; the state need not be in equilibrium.
  struct Lagrangian {
    VecX by_q;  ///< (unknowns), local axes
    VecX by_p;  ///< (m), held unknowns following the parameters
  };
  Lagrangian lagrangian_times(const VecX& multiplier, const VecX& dq, const VecX& v,
                              ThreadPool* threads = nullptr) const;

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
