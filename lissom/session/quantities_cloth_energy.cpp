// Elastic energies of membranes and solids.

#include <algorithm>

#include "lissom/mechanics/membrane_bend.h"
#include "lissom/mechanics/membrane_stretch.h"
#include "lissom/mechanics/solid_stretch.h"
#include "lissom/session/cloth.h"
#include "lissom/session/quantity_families.h"

namespace lissom {

namespace {

/// Energies of the stencils of a term, J; empty when the pose has no such term.
std::vector<double> term_energies(const Situation& s, std::string_view name) {
  for (const auto& term : s.problem->potential.terms()) {
    if (term->name() != name) continue;
    std::vector<double> energy(static_cast<size_t>(term->groups()) * kLanes);
    term->energies(s.state, 0, term->groups(), energy.data());
    return energy;
  }
  return {};
}

/// Per triangle: stretch, and half of the bending at each of its sides, J.
struct ClothEnergies {
  std::vector<double> stretch, bending;
};

ClothEnergies energies_by_triangle(const Situation& s) {
  const Structure& structure = s.system->structure;
  ClothEnergies energies{term_energies(s, MembraneStretch::kName), std::vector<double>(structure.triangles.size(), 0)};
  energies.stretch.resize(structure.triangles.size(), 0);
  const std::vector<double> hinges = term_energies(s, MembraneBend::kName);
  size_t stencil = 0;  // hinges without stiffness have none
  for (size_t h = 0; h < structure.hinges.size() && stencil < hinges.size(); ++h) {
    if (s.system->rest.hinges[h].stiffness == 0) continue;
    for (const int t : structure.hinges[h].triangle) energies.bending[t] += 0.5 * hinges[stencil];
    ++stencil;
  }
  return energies;
}

}  // namespace

double cloth_energy(const Situation& s, const std::vector<bool>& selected) {
  const Structure& structure = s.system->structure;
  const auto inside = [&](const auto& nodes) {
    return std::all_of(nodes.begin(), nodes.end(), [&](int node) { return selected[node]; });
  };
  double sum = 0;
  const std::vector<double> stretch = term_energies(s, MembraneStretch::kName);
  for (size_t t = 0; t < structure.triangles.size() && t < stretch.size(); ++t) {
    if (inside(structure.triangles[t].node)) sum += stretch[t];
  }
  const std::vector<double> bend = term_energies(s, MembraneBend::kName);
  size_t stencil = 0;
  for (size_t h = 0; h < structure.hinges.size() && stencil < bend.size(); ++h) {
    if (s.system->rest.hinges[h].stiffness == 0) continue;
    if (inside(structure.hinges[h].node)) sum += bend[stencil];
    ++stencil;
  }
  return sum;
}

double solid_energy(const Situation& s, const std::vector<bool>& selected) {
  double sum = 0;
  const std::vector<double> energies = term_energies(s, SolidStretch::kName);
  for (size_t t = 0; t < s.system->structure.tetrahedra.size() && t < energies.size(); ++t) {
    const std::array<int, 4>& nodes = s.system->structure.tetrahedra[t].node;
    if (std::all_of(nodes.begin(), nodes.end(), [&](int node) { return selected[node]; })) sum += energies[t];
  }
  return sum;
}

Result<double> membrane_energy(const Measurement& m) {
  const Result<const Situation*> found = m.study.situation(m.pose(), m.refine);
  if (!found) return found.error();
  const Result<std::vector<int>> nodes = selected_nodes(m, m.at, *found.value()->system);
  if (!nodes) return nodes.error();
  std::vector<bool> selected(found.value()->system->structure.nodes.size(), false);
  for (const int node : nodes.value()) selected[node] = true;
  return cloth_energy(*found.value(), selected);
}

namespace {

Result<double> energy_density(const Measurement& m, bool stretch, bool bending) {
  const Result<Cloth> cloth = cloth_at(m);
  if (!cloth) return cloth.error();
  const Situation& s = *cloth.value().in;
  const ClothEnergies energies = energies_by_triangle(s);
  double sum = 0, area = 0;
  for (const int t : cloth.value().triangles) {
    if (stretch) sum += energies.stretch[t];
    if (bending) sum += energies.bending[t];
    area += sides_of(s, t).stretch.rest_area;
  }
  return sum / area;
}

}  // namespace

Result<double> membrane_energy_density(const Measurement& m) { return energy_density(m, true, true); }
Result<double> membrane_bending_density(const Measurement& m) { return energy_density(m, false, true); }

}  // namespace lissom
