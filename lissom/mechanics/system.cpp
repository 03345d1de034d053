#include "lissom/mechanics/system.h"

#include <utility>

namespace lissom {

Result<System> make_system(const Model& model, double refine) {
  Result<Structure> structure = discretize(model, refine);
  if (!structure) return structure.error();
  return make_system(model, std::move(structure).value());
}

Result<System> make_system(const Model& model, Structure structure) {
  System system;
  system.structure = std::move(structure);
  Result<RestState> rest = make_rest_state(model, system.structure);
  if (!rest) return rest.error();
  system.rest = std::move(rest).value();
  system.layout = DofLayout(system.structure);

  int k = 0;
  for (int j = 0; j < system.joint_count(); ++j) {
    system.first_connection.push_back(k);
    for (const JointConnection& c : system.structure.joints[j].connections) {
      const std::array<double, kPairRestCount> rest_numbers = rest_values(system.rest.connections[k++]);
      system.connections.push_back(
          {j, c.edge, c.direction, c.rest, connection_weights<double>(rest_numbers.data(), model.joint_weights)});
    }
  }
  system.first_connection.push_back(k);
  system.joint_of_node.assign(system.structure.nodes.size(), -1);
  for (int j = 0; j < system.joint_count(); ++j) system.joint_of_node[system.structure.joints[j].node] = j;
  return system;
}

}  // namespace lissom
