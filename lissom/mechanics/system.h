#pragma once
/// A discretised structure with its numbering and rest numbers: what all states and potentials of it share. Immutable.

#include <vector>

#include "lissom/core/result.h"
#include "lissom/mechanics/dof_layout.h"
#include "lissom/mechanics/joint_corotational_kernel.h"
#include "lissom/mechanics/rest_state.h"
#include "lissom/model/structure.h"

namespace lissom {

/// A rod edge held by a joint, in the order of RestState::connections.
struct Connection {
  int joint = -1;
  int edge = -1;
  int direction = 1;                   ///< +1: the edge leaves the joint, -1: it arrives
  Frame rest;                          ///< frame of the connection edge when the joint rotation is the identity
  ConnectionWeights<double> weight{};  ///< in shape matching, N m (corotational joints)
};

struct System {
  Structure structure;
  DofLayout layout;
  RestState rest;
  std::vector<Connection> connections;
  std::vector<int> first_connection;  ///< per joint, with one entry more at the end
  std::vector<int> joint_of_node;     ///< -1 where there is none

  int edge_count() const { return static_cast<int>(structure.edges.size()); }
  int joint_count() const { return static_cast<int>(structure.joints.size()); }
};

/// Discretises the model and derives everything a solver needs from it.
Result<System> make_system(const Model& model, double refine = 1);

/// The same of a structure that the model was discretised to.
Result<System> make_system(const Model& model, Structure structure);

}  // namespace lissom
