#include <utility>

#include "lissom/core/assert.h"
#include "lissom/design/structure_problem.h"

namespace lissom {

namespace {

/// The sign with which c - target has to be <= 0.
double side(const Goal& goal) { return goal.kind == GoalKind::kAtLeast ? -1 : 1; }

}  // namespace

bool StructureProblem::is_inequality(int i) const {
  for (const std::vector<int>& goals : by_pose_) {
    for (const int g : goals) {
      const Goal& goal = goals_[static_cast<std::size_t>(g)];
      if (goal.force != GoalForce::kHard) continue;
      if (i < goal.objective->size()) return goal.kind != GoalKind::kReach;
      i -= goal.objective->size();
    }
  }
  LISSOM_ASSERT(false);
  return false;
}

VecX StructureProblem::constraint_values() const {
  VecX values(constraints_);
  int at = 0;
  for (std::size_t k = 0; k < poses_.size(); ++k) {
    poses_[k]->stand_at_point(design_);  // an attempt may have left its numbers
    for (const int g : by_pose_[k]) {
      const Goal& goal = goals_[static_cast<std::size_t>(g)];
      if (goal.force != GoalForce::kHard) continue;
      VecX c;
      goal.objective->values(shape_of(design_, static_cast<int>(k), poses_[k]->state()), c);
      values.segment(at, c.size()) = side(goal) * (c - goal.target) / goal.scale;
      at += static_cast<int>(c.size());
    }
  }
  return values;
}

void StructureProblem::set_multipliers(const VecX& multipliers, double penalty) {
  LISSOM_ASSERT(multipliers.size() == constraints_ && penalty > 0);
  int at = 0;
  for (const std::vector<int>& goals : by_pose_) {
    for (const int g : goals) {
      const Goal& goal = goals_[static_cast<std::size_t>(g)];
      if (goal.force != GoalForce::kHard) continue;
      Goal& effective = effective_[static_cast<std::size_t>(g)];
      const int n = goal.objective->size();
      effective.weight = penalty;
      effective.weights = VecX::Ones(n);
      effective.target = goal.target - side(goal) * goal.scale / penalty * multipliers.segment(at, n);
      at += n;
    }
  }
  settle_point();
}

}  // namespace lissom
