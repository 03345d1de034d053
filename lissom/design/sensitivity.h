#pragma once
/// How an equilibrium answers to a change of its design, to first order: with S = dq/dp, products S v and S' w by one back
/// solve each, and S itself where it is small enough [mathematics 5.1]. Parameters act through rest inputs, rest numbers,
/// loads and what is held; soft pins without a target follow the drawing.

#include "lissom/core/linear_solver.h"
#include "lissom/core/result.h"
#include "lissom/design/design_space.h"
#include "lissom/equilibrium/static_problem.h"

namespace lissom {

/// Problem and factor have to outlive the sensitivity; the factor has to be that of the Hessian of the equilibrium, without a
/// shift.
class Sensitivity {
 public:
  /// Of pose number `pose` of the model; `jacobian` is that of the design space there. kUnsupported where the pose moves what
  /// it holds by amounts that depend on the drawing.
  static Result<Sensitivity> make(const Model& model, int pose, const StaticProblem& problem, const State& equilibrium,
                                  const LinearSolver& factor, const DesignJacobian& jacobian);
  /// The same where parameters act on rest inputs alone: `inputs` is d rest inputs / d p, (RestInputs::size x m).
  static Result<Sensitivity> make(const Model& model, const Pose& pose, const StaticProblem& problem,
                                  const State& equilibrium, const LinearSolver& factor, const SparseMatrix& inputs);

  int parameters() const { return static_cast<int>(numbers_.cols()); }

  /// S v: increments of all unknowns in global axes, for a change v of the parameters.
  VecX forward(const VecX& v) const;
  /// S' w for w = d h / d q over all unknowns, global axes.
  VecX adjoint(const VecX& w) const;
  /// S, (unknowns x m), global axes.
  MatX dense() const;

  /// d rest numbers / d p, followed by d load numbers / d p, (RestNumbers::size + LoadNumbers::size x m).
  const SparseMatrix& numbers() const { return numbers_; }
  /// d gradient / d numbers at fixed unknowns, (unknowns x numbers), rows in local axes.
  const SparseMatrix& gradient_by_numbers() const { return by_numbers_; }
  /// d held unknowns / d p, (unknowns x m), rows in local axes; no columns where nothing that is held moves.
  const SparseMatrix& held() const { return held_; }
  /// d gradient / d p at fixed free unknowns, held ones following p, (unknowns x m), rows in local axes.
  const SparseMatrix& forces() const { return forces_; }
  enum class Side { kForward, kTransposed };
  /// (H + N)^-1 w, or that of the transpose, over the unknowns that are free, 0 for those that are held; local axes in and
  /// out. N: what turning a joint does to the gradient of all else there that the symmetric H leaves out, where moments with
  /// fixed axes act [docs/energies/loads.md]; else 0.
  VecX back_solve(const VecX& w, Side side) const;
  /// H w, local axes in and out.
  VecX hessian_times(const VecX& w) const;

 private:
  void solve(VecX& x, Side side) const;
  void set_moments(const Pose& pose, const State& equilibrium);
  static Result<Sensitivity> make(const Model& model, const Pose& pose, const StaticProblem& problem,
                                  const State& equilibrium, const LinearSolver& factor, const DesignJacobian& jacobian,
                                  const PoseJacobian& own);

  const StaticProblem* problem_ = nullptr;
  const LinearSolver* factor_ = nullptr;
  SparseMatrix numbers_, by_numbers_, held_;
  SparseMatrix forces_;
  std::vector<int> turned_;      // free unknowns on which N acts
  MatX skew_, reach_;            // N on these, and H^-1 of their unit vectors (free unknowns x turned)
  std::vector<double> hessian_;  // values in the order of the potential's pattern
};

}  // namespace lissom
