#include "lissom/equilibrium/step_limits.h"

#include <algorithm>
#include <cmath>

namespace lissom {

double largest_roll(const System& system, const VecX& dq) {
  const int first = 3 * system.layout.nodes();
  return first < dq.size() ? dq.tail(dq.size() - first).cwiseAbs().maxCoeff() : 0;
}

double largest_strain(const System& system, const State& state, const VecX& dq) {
  double largest = 0;
  for (int e = 0; e < system.edge_count(); ++e) {
    const StructureEdge& edge = system.structure.edges[e];
    const Vec3 de = dq.segment<3>(3 * edge.node1) - dq.segment<3>(3 * edge.node0);
    largest = std::max(largest, std::abs(state.edges[e].t.dot(de)) / system.rest.edges[e].length);
  }
  return largest;
}

double step_reach(const System& system, const State& state, const VecX& dq, const SolveOptions& options) {
  double reach = 1;
  const double turn = largest_turn(system, state, dq), roll = largest_roll(system, dq);
  if (turn * reach > options.max_turn) reach = options.max_turn / turn;
  if (roll * reach > options.max_roll) reach = options.max_roll / roll;
  return reach;
}

}  // namespace lissom
