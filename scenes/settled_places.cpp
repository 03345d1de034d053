#include "scenes/settled_places.h"

#include "lissom/equilibrium/solve.h"

namespace lissom::scene_models {

Result<std::vector<Vec3>> settled_places(const Model& model, int pose, const Context& context) {
  const Result<System> system = make_system(model);
  if (!system) return system.error();
  const Pose& described = model.poses[static_cast<std::size_t>(pose)];
  const Result<StaticProblem> problem =
      make_static_problem(model, system.value(), described, "/poses/" + std::to_string(pose));
  if (!problem) return problem.error();
  SolveOptions options;
  options.modes = 0;
  const Equilibrium found = solve(problem.value(), start_state(problem.value(), described), 1, options, context);
  if (found.verdict != Verdict::kStable) {
    return Error{ErrorCode::kConflict, described.name, "the wanted shape is not stable: " + found.message,
                 "ask for a gentler one"};
  }
  std::vector<Vec3> places;
  for (int i = 0; i < static_cast<int>(system.value().structure.nodes.size()); ++i) {
    places.push_back(found.state.position(i));
  }
  return places;
}

}  // namespace lissom::scene_models
