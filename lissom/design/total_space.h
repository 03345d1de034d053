#pragma once
/// An inverse problem in total space: states of all poses and parameters are unknowns side by side, and equilibrium is a
/// constraint [mathematics 5.5]. Minimise h(u, x) = 1/2 |r|^2 subject to c(u, x) = 0, bounds on x, where
///   u (n)  increments of the free unknowns of every pose, pose by pose, in their local axes, over a scale: 1 % of the size of the
///          structure for positions, 0.01 rad for rolls and joint rotations;
///   x (m)  parameters over their scales, as in a reduced problem;
///   c (n)  gradient of the energy of every pose by u, over (largest load x scale of positions): no units.
/// A point is its own anchor: u is 0 there, and a step moves states as the static solver does, rotations by increments, edges
/// along paths on which they turn instead of shearing. Multipliers lambda (n) have the unit of h. c has the sign of the
/// gradient, the specification's that of the forces: lambda is minus the one there, and every step is the same.

#include <memory>
#include <string>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/design/structure_problem.h"
#include "lissom/equilibrium/newton_workspace.h"
#include "lissom/equilibrium/step_path.h"

namespace lissom {

/// What has been spent.
struct TotalEffort {
  int evaluations = 0;     ///< h and c of states that were tried
  int factorizations = 0;  ///< of stiffness matrices and of larger systems
  int back_solves = 0;     ///< right-hand sides of stiffness matrices and of larger systems, per pose
};

class TotalSpace {
 public:
  /// Stands at the point of `problem`, which has to outlive this and is not changed. Errors: kUnsupported for hard goals and
  /// for moments, whose force on a joint that turns has no potential away from equilibrium.
  static Result<std::unique_ptr<TotalSpace>> make(const StructureProblem& problem, const Context& context);
  TotalSpace(const TotalSpace&) = delete;
  TotalSpace& operator=(const TotalSpace&) = delete;

  int states() const { return first_.back(); }                        ///< n
  int parameters() const { return static_cast<int>(scale_.size()); }  ///< m
  int size() const { return states() + parameters(); }                ///< n + m
  std::string parameter_name(int i) const { return problem_->parameter_name(i); }
  const VecX& lower() const { return problem_->lower(); }  ///< of x
  const VecX& upper() const { return problem_->upper(); }
  /// Error, with the name of the goal, where exact second derivatives of h are not known.
  Status check_curvature() const;

  /// Moves to a point that need not be in equilibrium. kRange-like errors of the design space; kRange where energies or goals
  /// have no finite value there.
  Status stand_at(const DesignPoint& point);
  DesignPoint point() const;
  const VecX& x() const { return x_; }
  double value() const { return 0.5 * residual_.squaredNorm(); }
  const VecX& residual() const { return residual_; }
  const VecX& constraint() const { return constraint_; }
  /// Largest unbalanced force over what a static solve accepts, over all poses: in equilibrium up to 1.
  double imbalance() const { return imbalance_; }
  /// "pose "bent": 3.1e-05 N are left at node 12".
  std::string worst_force() const;

  /// Derivatives at the point; what follows asks for them. Errors are those of Sensitivity. Costs a factor per pose.
  Status linearize();
  bool is_linear() const { return linear_; }
  /// Whether every stiffness matrix has a factor that solves; else the pose that has none is named.
  bool is_regular() const { return singular_.empty(); }
  const std::string& singular() const { return singular_; }
  /// Negative eigenvalues of all stiffness matrices: 0 at stable states.
  int negative() const { return negative_; }

  /// d h / d (u, x), (n + m).
  VecX gradient() const;
  /// J v and J' w, J = [H, M] = d c / d (u, x), (n x n + m).
  VecX constraint_times(const VecX& v) const;
  VecX constraint_transposed_times(const VecX& w) const;
  /// Hessian of h + lambda'c times v: exact, third derivatives of the energy included, at fixed anchors [mathematics 1.8].
  VecX lagrangian_times(const VecX& lambda, const VecX& v) const;
  /// Hessian of h without second derivatives of r, R'R, times v.
  VecX gauss_newton_times(const VecX& v) const;

  /// H (n x n), M (n x m), R = [R_u, R_x] (residuals x n, x m).
  const SparseMatrix& hessian() const { return hessian_; }
  const SparseMatrix& mixed() const { return mixed_; }
  const SparseMatrix& residual_by_state() const { return residual_by_u_; }
  const SparseMatrix& residual_by_x() const { return residual_by_x_; }
  /// H^-1 b by the factors.
  VecX solve(const VecX& b) const;
  /// S = -H^-1 M, (n x m): states that stay in equilibrium to first order.
  MatX sensitivity() const;

  /// Increments of all unknowns of pose number k of the problem's poses, global axes, SI, for v over (u, x).
  VecX increment(int k, const VecX& v) const;
  /// Largest fraction of a step, at most 1, that turns no edge, roll or joint further than a static solve allows.
  double reach(const VecX& step) const;
  /// Tries point + fraction step; x is clipped to its bounds. False: no state or no design there, or not finite.
  [[nodiscard]] bool attempt(const VecX& step, double fraction);
  const VecX& attempted_residual() const { return attempted_residual_; }
  const VecX& attempted_constraint() const { return attempted_constraint_; }
  double attempted_imbalance() const { return attempted_imbalance_; }
  /// h of the attempt less h, without cancellation.
  double attempted_change() const;
  /// The last attempt, which could be had, becomes the point.
  void accept();

  const TotalEffort& effort() const { return effort_; }
  /// Counts work on larger systems that methods set up themselves.
  void count(int factorizations, int back_solves);

 private:
  /// One pose.
  struct Part {
    int pose = 0;
    System system;
    std::unique_ptr<StaticProblem> problem;
    std::unique_ptr<NewtonWorkspace> workspace;
    std::unique_ptr<StepPathPolicy> path;
    std::vector<const Goal*> goals;
    State state, attempted;
    VecX scale;              // SI, per free unknown
    double energy = 1;       // J, of which c is a share
    SparseMatrix to_global;  // (unknowns x unknowns), local axes to global
    SparseMatrix free;       // (unknowns x free), u to increments in global axes
    SparseMatrix held;       // (unknowns x m), x to increments of held unknowns in global axes
    std::optional<PoseLinearization> linear;
  };
  /// What the numbers of the poses are those of.
  enum class Numbers { kPoint, kAttempt };

  TotalSpace(const StructureProblem& problem, const Context& context);
  Status add_part(int pose);
  Status renew(const Design& design);
  void renew_point();
  bool evaluate(const Design& design, const VecX& p, State Part::*state, VecX& residual, VecX& constraint,
                double& imbalance);
  void assemble_blocks();
  void check_factors();
  double tolerance(const Part& part) const;

  const StructureProblem* problem_;
  Context context_;
  VecX scale_;  // of x, SI
  std::vector<std::unique_ptr<Part>> parts_;
  std::vector<int> first_;  // unknown of each pose, n at the end
  Numbers numbers_ = Numbers::kPoint;
  bool holds_ = false;  // places that are held follow x

  Design design_, attempted_design_;
  VecX x_, p_, residual_, constraint_;
  VecX attempted_x_, attempted_p_, attempted_residual_, attempted_constraint_;
  double imbalance_ = 0, attempted_imbalance_ = 0;

  bool linear_ = false;
  DesignJacobian jacobian_;
  SparseMatrix hessian_, mixed_, residual_by_u_, residual_by_x_;
  std::string singular_;
  int negative_ = 0;
  mutable TotalEffort effort_;
};

}  // namespace lissom
