#pragma once
/// A shape carried from one mesh of a plan to another, so that a remeshed design goes on from where it was.

#include <vector>

#include "lissom/mechanics/state.h"
#include "lissom/model/expand_plan.h"

namespace lissom {

/// A plan, what it was expanded to, and the system that came of it.
struct PlanStage {
  const Plan& plan;
  const ExpandedPlan& expanded;  ///< at the places that the system was discretised from
  const System& system;
};

struct CarriedShape {
  State state;
  /// Axial strain of every edge, as the old rods have it: chords between new nodes miss it by far more than it is. 0 where
  /// there was no rod.
  std::vector<double> strains;
};

/// `state` of `from` on the mesh of `to`, at the same load factor. Rods of the same name through points of the same names
/// keep their curve: nodes between the same two points lie on the cubic through the old nodes, frames turn along. Everything
/// else lies on the old fabric, where the plan has it. Joints keep their rotation by the name of their point.
CarriedShape carried_over(const PlanStage& from, const State& state, const PlanStage& to);

}  // namespace lissom
