#pragma once
/// How an equilibrium answers to a change of its design, to first order: with S = dq/dp, products S v and S' w by one back
/// solve each, and S itself where it is small enough [mathematics 5.1]. Parameters act through rest inputs, rest numbers,
/// loads and what is held; soft pins without a target follow the drawing.

#include <vector>

#include "lissom/core/context.h"
#include "lissom/core/linear_solver.h"
#include "lissom/core/result.h"
#include "lissom/design/design_space.h"
#include "lissom/equilibrium/static_problem.h"

namespace lissom {

/// The factor of the Hessian has to be that of the equilibrium, without a shift, and has to outlive the sensitivity.
class Sensitivity {
 public:
  /// `inputs`: d rest inputs / d p, (RestInputs::size x m). kUnsupported where the pose moves what it holds by amounts that
  /// depend on the drawing.
  static Result<Sensitivity> make(const Model& model, const Pose& pose, const StaticProblem& problem,
                                  const State& equilibrium, const LinearSolver& factor, const SparseMatrix& inputs);

  /// Of pose number `pose` of the model, with all that the design depends on.
  static Result<Sensitivity> make(const Model& model, int pose, const StaticProblem& problem, const State& equilibrium,
                                  const LinearSolver& factor, const DesignJacobian& jacobian);

  int parameters() const { return static_cast<int>(by_parameters_.cols()); }

  /// S v: increments of all unknowns in global axes, for a change v of the parameters.
  VecX forward(const VecX& v) const;
  /// S' w for w = d h / d q over all unknowns, global axes.
  VecX adjoint(const VecX& w) const;
  /// S, (unknowns x m), global axes.
  MatX dense() const;

  /// d gradient / d p over all unknowns in local axes at fixed unknowns, (unknowns x m).
  const MatX& gradient_by_parameters() const { return by_parameters_; }

 private:
  /// x with (H + N) x = b over free unknowns, or (H + N)' x = b. N: what turning a joint does to the gradient of all else
  /// there that the symmetric H leaves out, where moments with fixed axes act [docs/energies/loads.md].
  enum class Side { kForward, kTransposed };
  void solve(VecX& x, Side side) const;
  void set_moments(const Pose& pose, const State& equilibrium);

  static Result<Sensitivity> make(const Model& model, const Pose& pose, const StaticProblem& problem,
                                  const State& equilibrium, const LinearSolver& factor, const DesignJacobian& jacobian,
                                  const PoseJacobian& own);

  const StaticProblem* problem_ = nullptr;
  const LinearSolver* factor_ = nullptr;
  MatX by_parameters_;
  MatX held_;  ///< what held unknowns do, (unknowns x m), local axes; no columns where nothing that is held moves
  std::vector<int> turned_;  ///< free unknowns on which N acts
  MatX skew_, reach_;        ///< N on these, and H^-1 of their unit vectors (free unknowns x turned)
  MatX right_;               ///< (free unknowns x m): minus the forces that the change of p brings about
};

}  // namespace lissom
