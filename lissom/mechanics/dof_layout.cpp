#include "lissom/mechanics/dof_layout.h"

namespace lissom {

DofLayout::DofLayout(const Structure& structure)
    : nodes_(static_cast<int>(structure.nodes.size())), edges_(static_cast<int>(structure.edges.size())) {
  rotation_of_joint_.reserve(structure.joints.size());
  for (int j = 0; j < static_cast<int>(structure.joints.size()); ++j) {
    if (structure.joints[j].kind == JointKind::kExplicit) {
      rotation_of_joint_.push_back(static_cast<int>(joint_of_rotation_.size()));
      joint_of_rotation_.push_back(j);
    } else {
      rotation_of_joint_.push_back(-1);
    }
  }
}

}  // namespace lissom
