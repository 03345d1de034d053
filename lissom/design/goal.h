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

/// Residuals r = sqrt(weight) rows (p - target) / scale: smooth parameters, or few changes. `scale` is in the rows.
struct ParameterGoal {
  std::string name;
  SparseMatrix rows;  ///< (residuals x m)
  VecX target;        ///< SI, (m)
  double weight = 1;
};

}  // namespace lissom
