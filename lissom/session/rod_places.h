#pragma once
/// Where rods bend and twist: at inner vertices, and between the frame of a joint or clamp and an edge.

#include <vector>

#include "lissom/mechanics/state.h"
#include "lissom/mechanics/system.h"

namespace lissom {

struct RodPlace {
  int rod = -1;
  int pair = -1;               ///< of Structure::pairs, or -1
  int connection = -1;         ///< of System::connections, or -1
  int node = -1;               ///< where it is
  int edge0 = -1, edge1 = -1;  ///< the edge that arrives and the one that leaves; -1 where the joint is in its stead
  double along = 0;            ///< m, rest length from the start of the rod
  PairRest rest;
};

/// All places: pairs, then connections.
std::vector<RodPlace> rod_places(const System& system);

/// Integrated curvatures and twist of a place in a state.
PairStrain strain_at(const System& system, const State& state, const RodPlace& place);

/// J, curvature part and twist part of the elastic energy of a place.
double bending_energy(const PairStrain& strain, const PairRest& rest);
double twist_energy(const PairStrain& strain, const PairRest& rest);
/// J, of stretching edge `e`.
double stretch_energy(const System& system, const State& state, int e);

/// m, rest length of a rod.
double rest_length(const System& system, const StructureRod& rod);

}  // namespace lissom
