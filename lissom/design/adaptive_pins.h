#pragma once
/// Soft pins that stand for boundary positions: as stiff as it takes for pinned nodes to miss their places as much as the goals
/// for positions are missed [mathematics 5.4].

#include "lissom/design/brief_goals.h"
#include "lissom/design/structure_problem.h"

namespace lissom {

/// Factors by which the soft pins of each pose of `problem` should become stiffer: the root mean square by which its pinned
/// nodes miss their pins over that by which its other nodes miss their goals for positions, between 1/2 and 2. 1 where a pose
/// lacks either, or the factor would be within 5 % of it. Taken alone this rule runs away: softer pins make everything miss more,
/// and then seem stiff. StructureProblem::stiffen_pins does not follow it there.
Result<VecX> pin_changes(const StructureProblem& problem, const BriefGoals& goals);

}  // namespace lissom
