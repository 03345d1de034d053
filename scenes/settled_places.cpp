#include "scenes/settled_places.h"

#include "lissom/equilibrium/settled.h"

namespace lissom::scene_models {

Result<std::vector<Vec3>> settled_places(const Model& model, int pose, const Context& context) {
  const Result<System> system = make_system(model);
  if (!system) return system.error();
  const Pose& described = model.poses[static_cast<std::size_t>(pose)];
  const Result<Equilibrium> found =
      settled(model, system.value(), described, "/poses/" + std::to_string(pose), context);
  if (!found) return found.error();
  if (found.value().verdict != Verdict::kStable) {
    return Error{ErrorCode::kConflict, described.name, "the wanted shape is not stable: " + found.value().message,
                 "ask for a gentler one"};
  }
  std::vector<Vec3> places;
  for (int i = 0; i < static_cast<int>(system.value().structure.nodes.size()); ++i) {
    places.push_back(found.value().state.position(i));
  }
  return places;
}

}  // namespace lissom::scene_models
