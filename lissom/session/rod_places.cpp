#include "lissom/session/rod_places.h"

#include <cmath>

#include "lissom/geometry/frame.h"

namespace lissom {

std::vector<RodPlace> rod_places(const System& system) {
  const Structure& structure = system.structure;
  std::vector<double> start(structure.edges.size(), 0);  // m along its rod
  for (const StructureRod& rod : structure.rods) {
    double along = 0;
    for (const int e : rod.edges) {
      start[e] = along;
      along += system.rest.edges[e].length;
    }
  }
  std::vector<RodPlace> places;
  places.reserve(structure.pairs.size() + system.connections.size());
  for (int p = 0; p < static_cast<int>(structure.pairs.size()); ++p) {
    const StructurePair& pair = structure.pairs[p];
    const int rod = structure.edges[pair.edge0].rod;
    places.push_back({rod, p, -1, structure.edges[pair.edge0].node1, pair.edge0, pair.edge1,
                      start[pair.edge0] + system.rest.edges[pair.edge0].length, system.rest.pairs[p]});
  }
  for (int k = 0; k < static_cast<int>(system.connections.size()); ++k) {
    const Connection& c = system.connections[k];
    const StructureEdge& edge = structure.edges[c.edge];
    const bool leaves = c.direction > 0;
    places.push_back({edge.rod, -1, k, leaves ? edge.node0 : edge.node1, leaves ? -1 : c.edge, leaves ? c.edge : -1,
                      start[c.edge] + (leaves ? 0 : system.rest.edges[c.edge].length), system.rest.connections[k]});
  }
  return places;
}

PairStrain strain_at(const System& system, const State& state, const RodPlace& place) {
  if (place.pair >= 0) {
    PairStrain strain = pair_strain(state.edges[place.edge0].material(), state.edges[place.edge1].material());
    strain.twist = state.pair_twist[place.pair];
    return strain;
  }
  const Connection& c = system.connections[place.connection];
  const Frame held = rotated(state.joint_rotation[c.joint], c.rest), edge = state.edges[c.edge].material();
  PairStrain strain = c.direction > 0 ? pair_strain(held, edge) : pair_strain(edge, held);
  strain.twist = state.connection_twist[place.connection];
  return strain;
}

double bending_energy(const PairStrain& strain, const PairRest& rest) {
  const double d1 = strain.kappa_1 - rest.kappa_1, d2 = strain.kappa_2 - rest.kappa_2;
  return (rest.bend_1 * d1 * d1 + rest.bend_2 * d2 * d2) / (2 * rest.length);
}

double twist_energy(const PairStrain& strain, const PairRest& rest) {
  const double d = strain.twist - rest.twist;
  return rest.twist_stiffness * d * d / (2 * rest.length);
}

double stretch_energy(const System& system, const State& state, int e) {
  const EdgeRest& rest = system.rest.edges[e];
  const double strain = state.edges[e].length / rest.length - 1;
  return rest.stretch * rest.length * strain * strain / 2;
}

double rest_length(const System& system, const StructureRod& rod) {
  double length = 0;
  for (const int e : rod.edges) length += system.rest.edges[e].length;
  return length;
}

}  // namespace lissom
