#pragma once
/// The inverse problem of a structure: goals for its equilibria in several poses as a function of its design parameters alone.
/// Poses are solved, and their derivatives taken, side by side on factors of their own.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/design/design_space.h"
#include "lissom/design/goal.h"
#include "lissom/design/pose_follower.h"
#include "lissom/design/pose_linearization.h"
#include "lissom/design/reduced_problem.h"

namespace lissom {

struct StructureProblemOptions {
  SolveOptions solve{.tolerance = 1e-8, .modes = 0};
};

/// All that has to be kept of a point to go on from it: bit for bit.
struct DesignPoint {
  VecX p;                     ///< SI
  std::vector<State> states;  ///< per pose that has a goal, ascending
  VecX pin_factors;           ///< of the same poses: stiffness of soft pins over what the space gives them
};

/// How far a goal is from what it asks.
struct GoalMeasure {
  std::string name;
  int pose = 0;
  double rms = 0;  ///< in the unit of the objective: of what misses the goal
  std::string_view unit;
};

class StructureProblem final : public ReducedProblem {
 public:
  /// Solves nothing yet: `release` or `restore` makes the point. Errors name goals that cannot be meant and starts that are
  /// out of bounds. `context` is copied; what it points to has to outlive the problem.
  static Result<std::unique_ptr<StructureProblem>> make(std::shared_ptr<const DesignSpace> space,
                                                        std::vector<Goal> goals, std::vector<ParameterGoal> wishes,
                                                        const StructureProblemOptions& options, const Context& context);

  /// Finds the equilibria of the start, or of `p`, from the drawn shape or from `near`. kBadStart-like errors name the pose.
  Status release(const VecX* p = nullptr, const DesignPoint* near = nullptr);
  Status restore(const DesignPoint& point);
  DesignPoint point() const;

  const DesignSpace& space() const { return *space_; }
  const Design& design() const { return design_; }
  const std::vector<Goal>& goals() const { return goals_; }
  const std::vector<ParameterGoal>& wishes() const { return wishes_; }
  const StructureProblemOptions& options() const { return options_; }
  std::vector<GoalMeasure> measures() const;
  /// Poses that have a goal, ascending, and their equilibria at the point.
  const std::vector<std::unique_ptr<PoseFollower>>& poses() const { return poses_; }
  const VecX& p() const { return p_; }  ///< SI
  /// Changes the stiffness of the soft pins of each entry of `poses` by a factor, each pose for itself and only if it follows
  /// and misses its goals no more than before; the point, h and derivatives follow. Whether anything has changed.
  Result<bool> stiffen_pins(const VecX& factors);

  int size() const override { return static_cast<int>(scale_.size()); }
  std::string parameter_name(int i) const override { return space_->parameters()[static_cast<std::size_t>(i)].name; }
  const VecX& lower() const override { return lower_; }
  const VecX& upper() const override { return upper_; }
  const VecX& x() const override { return x_; }
  double value() const override { return value_; }
  const VecX& residual() const override { return residual_; }
  const VecX& gradient() override;
  const MatX& gram() override;
  VecX jacobian_times(const VecX& v) override;
  VecX jacobian_transposed_times(const VecX& w) override;
  const OneSided& one_sided() const override { return one_sided_; }
  VecX hessian_times(const VecX& v) override;
  Attempt attempt(const VecX& x) override;
  const VecX& attempted_residual() const override { return attempted_residual_; }
  void accept() override;
  int constraints() const override { return constraints_; }
  bool is_inequality(int i) const override;
  VecX constraint_values() const override;
  void set_multipliers(const VecX& multipliers, double penalty) override;
  DesignEffort effort() const override;

 private:
  StructureProblem(std::shared_ptr<const DesignSpace> space, std::vector<Goal> goals, std::vector<ParameterGoal> wishes,
                   const StructureProblemOptions& options, const Context& context);

  /// Runs body(pose number in `poses_`) side by side.
  void for_poses(const std::function<void(int)>& body) const;
  /// The design that the space makes, with pins as stiff as they are now.
  Result<Design> design_at(const VecX& p, const VecX& pin_factors) const;
  /// All poses attempt to follow the point to a changed design.
  std::vector<PoseEnd> follow(const Design& changed);
  PoseShape shape_of(const Design& design, int k, const State& state) const;
  /// Residuals of all goals and wishes at equilibria.
  VecX residual_at(const Design& design, const VecX& p, const std::vector<const State*>& states) const;
  void settle_point();
  Status ensure_linear();
  void ensure_dense();

  std::shared_ptr<const DesignSpace> space_;
  std::vector<Goal> goals_;                // as given
  std::vector<Goal> effective_;            // with multipliers in targets and weights
  std::vector<std::vector<int>> by_pose_;  // goals of each entry of poses_
  std::vector<ParameterGoal> wishes_;
  StructureProblemOptions options_;
  Context context_, inner_;  // of each pose
  VecX scale_, lower_, upper_;
  std::vector<std::unique_ptr<PoseFollower>> poses_;
  int constraints_ = 0;

  Design design_, attempted_design_;
  VecX x_, residual_, attempted_x_, attempted_residual_;
  VecX p_, attempted_p_;  // SI
  VecX pin_factors_;      // by entry of poses_
  double value_ = 0;

  // Derivatives at the point, made when asked for.
  DesignJacobian jacobian_;
  std::vector<PoseLinearization> linear_;
  std::vector<MatX> dense_;              // per pose, by x
  std::vector<SparseMatrix> wish_rows_;  // of the residual, by x
  OneSided one_sided_;                   // wishes of that kind, by x
  std::optional<VecX> gradient_;
  std::optional<MatX> gram_;
  DesignEffort effort_;
};

}  // namespace lissom
