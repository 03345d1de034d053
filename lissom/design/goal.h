#pragma once
/// What a design is to reach: objectives with targets, weights and scales, as residuals of a least-squares problem, and wishes
/// about the parameters themselves.

#include <memory>
#include <string>
#include <vector>

#include "lissom/design/objective.h"

namespace lissom {

enum class GoalKind {
  kReach,    ///< c = target
  kAtMost,   ///< c <= target
  kAtLeast,  ///< c >= target
};

enum class GoalForce {
  kSoft,  ///< as near as the rest allows
  kHard,  ///< a constraint
};

/// Residuals r_i = sqrt(weight weights_i) (c_i - target_i) / scale; its positive (kAtMost) or negative part (kAtLeast).
struct Goal {
  std::string name;  ///< "pose \"bent\": node positions"
  int pose = 0;
  std::shared_ptr<const Objective> objective;
  GoalKind kind = GoalKind::kReach;
  GoalForce force = GoalForce::kSoft;
  VecX target;  ///< SI, (objective size)
  VecX
      weights;  ///< (objective size); of every place they sum up to a share of 1, so that |r| scale is a root mean square
  double scale = 1;   ///< SI, Objective::scale
  double weight = 1;  ///< against the other goals
};

/// Weights of components from those of places, `components` of each in a row: the weights of the places sum up to 1. kRange,
/// with `where` + "/7", for a weight that is negative or not finite, and with `where` where all are 0 or there is none.
Result<VecX> weights_of_places(const VecX& places, int components, const std::string& where);

/// kRange or kConflict, with `where` + "/target/7" and the like, for numbers that are not finite, sizes that differ from that
/// of the objective, weights that are negative or all 0, and a scale or a weight that is not positive.
Status check_goal(const Goal& goal, const std::string& where);

/// kUnsupported, with the name of the goal, where exact second derivatives are not known.
Status check_curvature(const Goal& goal);

/// sqrt(weight weights_i) (c_i - target_i) / scale, (objective size), whatever the kind.
VecX goal_deviation(const Goal& goal, const PoseShape& shape);

/// The part of a deviation that counts: all of it, its positive or its negative part.
VecX goal_residual(GoalKind kind, const VecX& deviation);
VecX goal_residual(const Goal& goal, const PoseShape& shape);

/// Derivatives of the residual, (objective size x unknowns, global axes) and (x RestNumbers::size): 0 where nothing counts.
/// The square of the residual has continuous first derivatives.
void goal_jacobian(const Goal& goal, const PoseShape& shape, SparseRows& by_q, SparseRows& by_numbers);

/// Which part of the second derivatives of 1/2 |r|^2.
enum class SecondOrder {
  kGaussNewton,  ///< J'J
  kExact,        ///< J'J + sum r_i r_i''
};

/// Adds the change of the gradient of 1/2 |r|^2 along unknowns dq (global axes) and rest numbers dn. kExact asks for goals
/// that pass check_curvature.
void add_goal_second_order(const Goal& goal, const PoseShape& shape, SecondOrder part, const VecX& dq, const VecX& dn,
                           VecX& by_q, VecX& by_numbers);

/// Residuals r = sqrt(weight) (rows (p - target) - level), or their positive or negative part: smooth parameters, few changes,
/// rods that keep apart. Scales are in the rows.
struct ParameterGoal {
  std::string name;
  SparseMatrix rows;  ///< (residuals x m)
  VecX target;        ///< SI, (m)
  double weight = 1;
  GoalKind kind = GoalKind::kReach;
  VecX level = {};  ///< (residuals); empty: 0
};

/// The residuals at parameters p (m, SI).
VecX wish_residual(const ParameterGoal& wish, const VecX& p);
/// Derivatives of these residuals (residuals x m): no entries where nothing counts.
SparseMatrix wish_jacobian(const ParameterGoal& wish, const VecX& p);

}  // namespace lissom
