#include "lissom/mechanics/corotational_joints.h"

#include <utility>

#include "lissom/mechanics/joint_corotational.h"

namespace lissom {

namespace {

template <int K>
void append_joints_of(const Model& model, const System& system, std::vector<std::unique_ptr<EnergyTerm>>& terms) {
  JointCorotational<K> energy;
  for (int j = 0; j < system.joint_count(); ++j) {
    const int first = system.first_connection[j];
    if (system.layout.rotation(j) >= 0 || system.first_connection[j + 1] - first != K) continue;
    typename JointCorotational<K>::Stencil s;
    s.joint = j;
    s.weights = model.joint_weights;
    const int node = system.structure.joints[j].node;
    for (int c = 0; c < 3; ++c) s.dofs[c] = 3 * node + c;
    for (int i = 0; i < K; ++i) {
      const Connection& connection = system.connections[first + i];
      const StructureEdge& edge = system.structure.edges[connection.edge];
      const int far = connection.direction > 0 ? edge.node1 : edge.node0;
      for (int c = 0; c < 3; ++c) s.dofs[3 + 3 * i + c] = 3 * far + c;
      s.dofs[3 + 3 * K + i] = system.layout.roll(connection.edge);
      s.connection[i] = first + i;
      s.edge[i] = connection.edge;
      s.direction[i] = connection.direction;
      s.rest_frame[i] = connection.rest;
      const auto rest = connection_rest_values(system.rest.connections[first + i]);
      std::copy(rest.begin(), rest.end(), s.rest.begin() + i * kConnectionRestCount);
    }
    energy.stencils.push_back(s);
  }
  if (!energy.stencils.empty()) terms.push_back(make_term(std::move(energy)));
}

}  // namespace

void append_corotational_joints(const Model& model, const System& system,
                                std::vector<std::unique_ptr<EnergyTerm>>& terms) {
  append_joints_of<2>(model, system, terms);
  append_joints_of<3>(model, system, terms);
  append_joints_of<4>(model, system, terms);
  append_joints_of<5>(model, system, terms);
  append_joints_of<6>(model, system, terms);
  append_joints_of<7>(model, system, terms);
  append_joints_of<8>(model, system, terms);
}

}  // namespace lissom
