#pragma once
/// One goal of a document, with its weights and scale.

#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/design/goal.h"
#include "lissom/model/brief.h"

namespace lissom {

/// What all goals of a pose share.
struct PoseGround {
  StaticProblem problem;
  State state;
};

struct BriefGoal {
  Goal goal;
  std::vector<int> nodes;     ///< of goals for positions, in the order of their targets; else empty
  std::vector<Vec3> targets;  ///< m, of these
};

/// `ground` is of pose number `pose`, `where` the place of the entry, which errors name.
Result<BriefGoal> make_brief_goal(const GoalBrief& entry, const Design& design, const PoseGround& ground, int pose,
                                  const std::string& where);

}  // namespace lissom
