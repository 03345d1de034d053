#pragma once
/// One function per energy that makes its stencils; energies.cpp lists them, nobody else includes this.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "lissom/mechanics/load_numbers.h"
#include "lissom/mechanics/rest_numbers.h"
#include "lissom/mechanics/stencil_term.h"
#include "lissom/model/model.h"

namespace lissom {

using EnergyTerms = std::vector<std::unique_ptr<EnergyTerm>>;

/// What energies are made from.
struct EnergySource {
  const Model& model;
  const System& system;
  const Pose* pose;
  std::string where;
  RestNumbers numbers;
  LoadNumbers loads;

  int load_number(int number) const { return numbers.size() + number; }

  std::string place(const char* list, size_t i) const { return where + "/" + list + "/" + std::to_string(i); }
  std::array<int, 3> node_dofs(int node) const { return {3 * node, 3 * node + 1, 3 * node + 2}; }
  Vec3 drawn(int node) const { return system.structure.nodes[node]; }
  Result<std::vector<int>> nodes(const Selector& at, const std::string& where_at) const {
    return select(model, system.structure, at, where_at + "/at");
  }
};

/// Appends a term unless it is empty.
template <class E>
void add_term(EnergyTerms& terms, E energy, RestLinks links = {}) {
  if (!energy.stencils.empty()) terms.push_back(make_term(std::move(energy), std::move(links)));
}

/// energies_elastic.cpp
Status add_rod_stretch(const EnergySource& source, EnergyTerms& terms);
Status add_rod_bend_twist(const EnergySource& source, EnergyTerms& terms);
Status add_explicit_joints(const EnergySource& source, EnergyTerms& terms);
Status add_corotational_joints(const EnergySource& source, EnergyTerms& terms);
Status add_membrane_stretch(const EnergySource& source, EnergyTerms& terms);
Status add_membrane_bend(const EnergySource& source, EnergyTerms& terms);
Status add_solid_stretch(const EnergySource& source, EnergyTerms& terms);

/// energies_loads.cpp
Status add_gravity(const EnergySource& source, EnergyTerms& terms);
Status add_line_loads(const EnergySource& source, EnergyTerms& terms);
Status add_edge_loads(const EnergySource& source, EnergyTerms& terms);
Status add_forces(const EnergySource& source, EnergyTerms& terms);
Status add_moments(const EnergySource& source, EnergyTerms& terms);
Status add_soft_pins(const EnergySource& source, EnergyTerms& terms);

}  // namespace lissom
