#include "lissom/mechanics/energies.h"

#include "lissom/mechanics/energy_builders.h"

namespace lissom {

namespace {

using Builder = Status (*)(const EnergySource&, EnergyTerms&);

/// One line per energy.
constexpr Builder kElastic[] = {add_rod_stretch,      add_rod_bend_twist, add_explicit_joints, add_corotational_joints,
                                add_membrane_stretch, add_membrane_bend,  add_solid_stretch};
constexpr Builder kOfPose[] = {add_gravity, add_line_loads, add_edge_loads, add_forces, add_moments, add_soft_pins};

}  // namespace

Result<EnergyTerms> make_terms(const Model& model, const System& system, const Pose* pose, const std::string& where) {
  const EnergySource source{model,
                            system,
                            pose,
                            where,
                            RestNumbers(system.structure),
                            LoadNumbers(pose != nullptr ? *pose : Pose{}, system.structure)};
  EnergyTerms terms;
  for (const Builder build : kElastic) {
    const Status status = build(source, terms);
    if (!status) return status.error();
  }
  if (pose == nullptr) return terms;
  for (const Builder build : kOfPose) {
    const Status status = build(source, terms);
    if (!status) return status.error();
  }
  return terms;
}

}  // namespace lissom
