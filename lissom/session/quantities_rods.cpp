// Strains, moments and sizes of rods, and elastic energies.

#include <algorithm>
#include <cmath>
#include <limits>

#include "lissom/session/quantity_families.h"
#include "lissom/session/rod_places.h"

namespace lissom {

namespace {

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

Result<int> rod_of(const Measurement& m, const System& system) {
  const int rod = system.structure.rod_index(m.expectation.rod);
  if (rod >= 0) return rod;
  return Error{ErrorCode::kUnknown, m.where + "/rod", "there is no rod \"" + m.expectation.rod + "\"",
               "name one of the rods"};
}

/// A bending place of the situation, with its strain.
struct Bent {
  PairStrain strain;
  PairRest rest;
};

Result<Bent> bent_at(const Measurement& m) {
  const Result<const Situation*> found = m.study.situation(m.pose(), m.refine);
  if (!found) return found.error();
  const System& system = *found.value()->system;
  const Result<int> rod = rod_of(m, system);
  if (!rod) return rod.error();
  const double length = rest_length(system, system.structure.rods[rod.value()]);
  const double wanted = m.expectation.fraction * length;
  const bool closed = system.structure.rods[rod.value()].closed;
  std::vector<RodPlace> places = rod_places(system);
  std::erase_if(places, [&](const RodPlace& p) { return p.rod != rod.value(); });
  std::stable_sort(places.begin(), places.end(),
                   [](const RodPlace& a, const RodPlace& b) { return a.along < b.along; });
  const RodPlace* nearest = nullptr;
  double best = std::numeric_limits<double>::infinity();
  for (const RodPlace& p : places) {
    double distance = std::abs(p.along - wanted);
    if (closed) distance = std::min(distance, length - distance);
    if (distance < best - 1e-9 * length) {
      best = distance;
      nearest = &p;
    }
  }
  if (nearest != nullptr) return Bent{strain_at(system, found.value()->state, *nearest), nearest->rest};
  return Error{ErrorCode::kGeometry, m.where + "/rod", "the rod bends nowhere: it has a single free edge",
               "give it more edges"};
}

/// Strain of the edge that contains the place, and its number.
struct Stretched {
  double strain = 0;
  int edge = -1;
  const System* system = nullptr;
};

Result<Stretched> stretched_at(const Measurement& m) {
  const Result<const Situation*> found = m.study.situation(m.pose(), m.refine);
  if (!found) return found.error();
  const System& system = *found.value()->system;
  const Result<int> index = rod_of(m, system);
  if (!index) return index.error();
  const StructureRod& rod = system.structure.rods[index.value()];
  const double length = rest_length(system, rod), wanted = m.expectation.fraction * length;
  double end = 0;
  for (const int e : rod.edges) {
    end += system.rest.edges[e].length;
    if (end < wanted - 1e-9 * length) continue;
    return Stretched{found.value()->state.edges[e].length / system.rest.edges[e].length - 1, e, &system};
  }
  return Error{ErrorCode::kRange, m.where + "/fraction", "the place lies beyond the end of the rod", ""};
}

/// Sum over the edges of the rod that is named, or of all rods.
template <class Of>
Result<double> sum_over_edges(const Measurement& m, const System& system, const Of& of) {
  double sum = 0;
  if (m.expectation.rod.empty()) {
    for (int e = 0; e < system.edge_count(); ++e) sum += of(e);
    return sum;
  }
  const Result<int> rod = rod_of(m, system);
  if (!rod) return rod.error();
  for (const int e : system.structure.rods[rod.value()].edges) sum += of(e);
  return sum;
}

enum EnergyPart : unsigned { kStretch = 1, kBending = 2, kTwist = 4, kMembranes = 8, kSolids = 16 };

Result<double> energy(const Measurement& m, unsigned parts) {
  const Result<const Situation*> found = m.study.situation(m.pose(), m.refine);
  if (!found) return found.error();
  const System& system = *found.value()->system;
  const State& state = found.value()->state;
  const Result<std::vector<int>> nodes = selected_nodes(m, m.at, system);
  if (!nodes) return nodes.error();
  std::vector<bool> selected(system.structure.nodes.size(), false);
  for (const int node : nodes.value()) selected[node] = true;
  const auto inside = [&](int e) {
    return e < 0 || (selected[system.structure.edges[e].node0] && selected[system.structure.edges[e].node1]);
  };
  double sum = parts & kMembranes ? cloth_energy(*found.value(), selected) : 0;
  if (parts & kSolids) sum += solid_energy(*found.value(), selected);
  if (parts & kStretch) {
    for (int e = 0; e < system.edge_count(); ++e) {
      if (inside(e)) sum += stretch_energy(system, state, e);
    }
  }
  if (parts & (kBending | kTwist)) {
    for (const RodPlace& place : rod_places(system)) {
      if (!inside(place.edge0) || !inside(place.edge1)) continue;
      const PairStrain strain = strain_at(system, state, place);
      if (parts & kBending) sum += bending_energy(strain, place.rest);
      if (parts & kTwist) sum += twist_energy(strain, place.rest);
    }
  }
  return sum;
}

}  // namespace

Result<double> rod_curvature(const Measurement& m) {
  const Result<Bent> b = bent_at(m);
  if (!b) return b.error();
  return std::hypot(b.value().strain.kappa_1, b.value().strain.kappa_2) / b.value().rest.length;
}

Result<double> rod_twist_rate(const Measurement& m) {
  const Result<Bent> b = bent_at(m);
  if (!b) return b.error();
  return b.value().strain.twist / b.value().rest.length;
}

Result<double> rod_bending_moment(const Measurement& m) {
  const Result<Bent> b = bent_at(m);
  if (!b) return b.error();
  const auto& [strain, rest] = b.value();
  return std::hypot(rest.bend_1 * (strain.kappa_1 - rest.kappa_1), rest.bend_2 * (strain.kappa_2 - rest.kappa_2)) /
         rest.length;
}

Result<double> rod_torque(const Measurement& m) {
  const Result<Bent> b = bent_at(m);
  if (!b) return b.error();
  const auto& [strain, rest] = b.value();
  return rest.twist_stiffness * (strain.twist - rest.twist) / rest.length;
}

Result<double> rod_axial_strain(const Measurement& m) {
  const Result<Stretched> s = stretched_at(m);
  if (!s) return s.error();
  return s.value().strain;
}

Result<double> rod_axial_force(const Measurement& m) {
  const Result<Stretched> s = stretched_at(m);
  if (!s) return s.error();
  return s.value().strain * s.value().system->rest.edges[s.value().edge].stretch;
}

Result<double> rod_largest_slope(const Measurement& m) {
  const Result<const Situation*> found = m.study.situation(m.pose(), m.refine);
  if (!found) return found.error();
  const System& system = *found.value()->system;
  const Result<int> rod = rod_of(m, system);
  if (!rod) return rod.error();
  double largest = 0;
  for (const int e : system.structure.rods[rod.value()].edges) {
    const StructureEdge& edge = system.structure.edges[e];
    const Vec3 drawn = system.structure.nodes[edge.node1] - system.structure.nodes[edge.node0];
    largest = std::max(largest, angle_between(found.value()->state.edges[e].t, m.expectation.axis.value_or(drawn)));
  }
  return largest;
}

Result<double> rod_length(const Measurement& m) {
  const Result<const Situation*> found = m.study.situation(m.pose(), m.refine);
  if (!found) return found.error();
  return sum_over_edges(m, *found.value()->system, [&](int e) { return found.value()->state.edges[e].length; });
}

Result<double> rod_rest_length(const Measurement& m) {
  const Result<const System*> system = m.study.system(m.refine);
  if (!system) return system.error();
  return sum_over_edges(m, *system.value(), [&](int e) { return system.value()->rest.edges[e].length; });
}

Result<double> rod_mass(const Measurement& m) {
  const Result<const System*> system = m.study.system(m.refine);
  if (!system) return system.error();
  return sum_over_edges(m, *system.value(), [&](int e) { return system.value()->rest.edges[e].mass; });
}

Result<double> energy_total(const Measurement& m) {
  return energy(m, kStretch | kBending | kTwist | kMembranes | kSolids);
}
Result<double> energy_stretch(const Measurement& m) { return energy(m, kStretch); }
Result<double> energy_bending(const Measurement& m) { return energy(m, kBending); }
Result<double> energy_twist(const Measurement& m) { return energy(m, kTwist); }

}  // namespace lissom
