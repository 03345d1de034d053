#include "lissom/motion/mass.h"

namespace lissom {

VecX lumped_mass(const System& system, RollInertia roll_inertia) {
  VecX mass = VecX::Zero(system.layout.size());
  for (int i = 0; i < system.layout.nodes(); ++i) mass.segment<3>(3 * i).setConstant(system.rest.node_mass[i]);
  if (roll_inertia == RollInertia::kNone) return mass;
  for (int e = 0; e < system.edge_count(); ++e) mass[system.layout.roll(e)] = system.rest.edges[e].roll_inertia;
  return mass;
}

}  // namespace lissom
