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

SideChange largest_side_change(const System& system, const State& state, const VecX& dq) {
  SideChange change;
  if (system.edge_count() > 0) return change;
  double turn2 = 0;
  const auto add = [&](int a, int b) {
    const Vec3 side = state.position(b) - state.position(a), move = dq.segment<3>(3 * b) - dq.segment<3>(3 * a);
    const double squared = side.squaredNorm(), along = side.dot(move) / squared;
    turn2 = std::max(turn2, move.squaredNorm() / squared - along * along);
    change.strain = std::max(change.strain, std::abs(along));
  };
  for (size_t h = 0; h < system.rest.hinges.size(); ++h) {
    if (system.rest.hinges[h].stiffness == 0) continue;
    const std::array<int, 4>& node = system.structure.hinges[h].node;
    add(node[0], node[1]);
    for (const int wing : {node[2], node[3]}) {
      add(node[0], wing);
      add(node[1], wing);
    }
  }
  for (const StructureTetrahedron& tetrahedron : system.structure.tetrahedra) {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < i; ++j) add(tetrahedron.node[i], tetrahedron.node[j]);
    }
  }
  change.turn = std::sqrt(std::max(0.0, turn2));
  return change;
}

double step_turn(const System& system, const State& state, const VecX& dq) {
  return std::max(largest_turn(system, state, dq), largest_side_change(system, state, dq).turn);
}

double step_reach(const System& system, const State& state, const VecX& dq, const SolveOptions& options) {
  double reach = 1;
  const double turn = step_turn(system, state, dq), roll = largest_roll(system, dq);
  if (turn * reach > options.max_turn) reach = options.max_turn / turn;
  if (roll * reach > options.max_roll) reach = options.max_roll / roll;
  return reach;
}

}  // namespace lissom
