#include "lissom/mechanics/corotational_joints.h"

#include <utility>

#include "lissom/mechanics/joint_corotational.h"

namespace lissom {

namespace {

template <int K>
void append_joints_of(const EnergySource& source, EnergyTerms& terms) {
  const System& system = source.system;
  JointCorotational<K> energy;
  RestLinks links;
  for (int j = 0; j < system.joint_count(); ++j) {
    const int first = system.first_connection[j];
    if (system.layout.rotation(j) >= 0 || system.first_connection[j + 1] - first != K) continue;
    typename JointCorotational<K>::Stencil s;
    s.joint = j;
    s.weights = source.model.joint_weights;
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
      const int at = (static_cast<int>(energy.stencils.size()) * K + i) * kConnectionRestCount;
      for (int c = 0; c < kConnectionRestCount; ++c) links.push_back({at + c, source.numbers.connection(first + i, c)});
    }
    energy.stencils.push_back(s);
  }
  add_term(terms, std::move(energy), std::move(links));
}

}  // namespace

void append_corotational_joints(const EnergySource& source, EnergyTerms& terms) {
  append_joints_of<2>(source, terms);
  append_joints_of<3>(source, terms);
  append_joints_of<4>(source, terms);
  append_joints_of<5>(source, terms);
  append_joints_of<6>(source, terms);
  append_joints_of<7>(source, terms);
  append_joints_of<8>(source, terms);
}

}  // namespace lissom
