#include "lissom/mechanics/system.h"

#include <utility>

namespace lissom {

Result<System> make_system(const Model& model, double refine) {
  Result<Structure> structure = discretize(model, refine);
  if (!structure) return structure.error();
  System system;
  system.structure = std::move(structure).value();
  Result<RestState> rest = make_rest_state(model, system.structure);
  if (!rest) return rest.error();
  system.rest = std::move(rest).value();
  system.layout = DofLayout(system.structure);

  int k = 0;
  for (int j = 0; j < system.joint_count(); ++j) {
    system.first_connection.push_back(k);
    for (const JointConnection& c : system.structure.joints[j].connections) {
      const PairRest& rest_pair = system.rest.connections[k++];
      const double edge_length = 2 * rest_pair.length;
      const double bend = rest_pair.bend_1 + rest_pair.bend_2;
      // Energy-consistent weights by default; the printed ones on request (erratum E10).
      const bool thesis = model.joint_weights == JointWeights::kThesis;
      const double weight_t = thesis ? bend : bend / (2 * edge_length);
      const double weight_n = thesis ? rest_pair.twist_stiffness : rest_pair.twist_stiffness / edge_length;
      system.connections.push_back({j, c.edge, c.direction, c.rest, weight_t, weight_n});
    }
  }
  system.first_connection.push_back(k);
  system.joint_of_node.assign(system.structure.nodes.size(), -1);
  for (int j = 0; j < system.joint_count(); ++j) system.joint_of_node[system.structure.joints[j].node] = j;
  return system;
}

}  // namespace lissom
