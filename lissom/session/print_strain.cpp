#include "lissom/session/print_strain.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

#include "lissom/design/section_strain.h"
#include "lissom/session/rod_places.h"

namespace lissom {

namespace {

/// Mean of what `of` says about the edges at a place.
template <class Of>
double mean_at(const RodPlace& place, const Of& of) {
  if (place.edge0 < 0) return of(place.edge1);
  if (place.edge1 < 0) return of(place.edge0);
  return (of(place.edge0) + of(place.edge1)) / 2;
}

double strain_of(const System& system, const State& state, const RodPlace& place, const Material& material) {
  const PairStrain strain = strain_at(system, state, place);
  const std::vector<StructureEdge>& edges = system.structure.edges;
  const double length = place.rest.length;
  const SectionState<double> section{
      mean_at(place, [&](int e) { return state.edges[e].length / system.rest.edges[e].length - 1; }),
      (strain.kappa_1 - place.rest.kappa_1) / length,
      (strain.kappa_2 - place.rest.kappa_2) / length,
      (strain.twist - place.rest.twist) / length,
      mean_at(place, [&](int e) { return edges[e].section.r_b; }),
      mean_at(place, [&](int e) { return edges[e].section.r_n; })};
  const int edge = place.edge0 >= 0 ? place.edge0 : place.edge1;
  return section_strain(edges[edge].section.shape, section, material.poisson_ratio);
}

/// The worst of one rod in a pose.
struct RodStrain {
  double strain = 0, limit = 0;
  int node = -1;
  double share() const { return strain / limit; }
};

std::map<int, RodStrain> worst_by_rod(const Model& model, const Situation& situation) {
  std::map<int, RodStrain> worst;
  const System& system = *situation.system;
  for (const RodPlace& place : rod_places(system)) {
    const Material* material = model.material(system.structure.rods[place.rod].material);
    if (material == nullptr) continue;
    const double strain = strain_of(system, situation.state, place, *material);
    RodStrain& rod = worst[place.rod];
    if (rod.node >= 0 && strain <= rod.strain) continue;
    rod = {strain, material->strain_limit, place.node};
  }
  return worst;
}

std::string percent(double strain) { return fmt::format("{:.3g} %", 100 * strain); }

}  // namespace

StrainChecks check_strains(const Model& model, const SolveOptions& options, const Context& context) {
  StrainChecks checks;
  Study study(model, options, context);
  std::map<int, PrintFinding> by_rod;
  std::vector<PrintFinding> unsolved;
  for (int p = 0; p < static_cast<int>(model.poses.size()) && !context.cancelled(); ++p) {
    const std::string& pose = model.poses[p].name;
    const Result<const Situation*> situation = study.situation(p);
    if (!situation) {
      unsolved.push_back(
          {PrintFinding::Weight::kWarning, "strain not known", "pose " + pose, 0,
           "it does not come to rest, so nobody knows whether rods break: " + situation.error().message});
      continue;
    }
    const Structure& structure = situation.value()->system->structure;
    PoseStrain most{pose, {}, 0, INFINITY};
    double largest = -1;
    for (const auto& [rod, worst] : worst_by_rod(model, *situation.value())) {
      const std::string place = print_place(structure.rods[rod].name, structure.nodes[worst.node]);
      // Where no limit is known shares are all zero: then the strain itself decides.
      if (worst.share() > largest || (worst.share() == largest && worst.strain > most.strain)) {
        largest = worst.share();
        most = {pose, place, worst.strain, worst.limit};
      }
      if (!(worst.share() > 1)) continue;
      PrintFinding& finding = by_rod[rod];
      if (worst.strain <= finding.value) continue;
      finding = {
          PrintFinding::Weight::kWarning, "strained too much", place, worst.strain,
          fmt::format("pose {} strains it by {}, {} bears {}: make it thinner there, bend it less, or take another "
                      "material",
                      pose, percent(worst.strain), structure.rods[rod].material, percent(worst.limit))};
    }
    checks.poses.push_back(most);
  }
  for (const auto& [rod, finding] : by_rod) checks.findings.push_back(finding);
  std::stable_sort(checks.findings.begin(), checks.findings.end(),
                   [](const PrintFinding& a, const PrintFinding& b) { return a.value > b.value; });
  checks.findings.insert(checks.findings.end(), unsolved.begin(), unsolved.end());
  return checks;
}

}  // namespace lissom
