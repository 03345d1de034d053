#pragma once
/// What a document asks of a design, as goals and wishes with weights and scales.

#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/design/brief_space.h"
#include "lissom/design/goal.h"
#include "lissom/model/brief.h"

namespace lissom {

struct BriefGoals {
  std::vector<Goal> goals;              ///< one for each of the brief, in its order
  std::vector<std::vector<int>> nodes;  ///< of goals for positions, in the order of their targets; else empty
  std::vector<ParameterGoal> wishes;
  std::vector<std::string> notes;  ///< sentences worth telling: goals that pull one node to two places
};

/// Errors name the entry, "/design/goals/3/positions": places of parts that nothing holds, numbers of targets, hard goals
/// that contradict each other or outnumber the parameters, supports that carry nothing.
Result<BriefGoals> make_brief_goals(const Brief& brief, const BriefSpace& space);

}  // namespace lissom
