#pragma once
/// The sole owner of the global order of unknowns.

#include <vector>

#include "lissom/model/structure.h"

namespace lissom {

/// Kinds of unknowns: they differ in unit and in size of their stiffness.
enum class DofClass { kPosition, kRoll, kRotation };

/// q = (positions of nodes, m, 3 each | roll angles of edges, rad | rotation increments of explicit joints, rad, 3 each).
class DofLayout {
 public:
  DofLayout() = default;
  explicit DofLayout(const Structure& structure);

  int nodes() const { return nodes_; }
  int edges() const { return edges_; }
  int rotations() const { return static_cast<int>(joint_of_rotation_.size()); }
  int size() const { return 3 * nodes_ + edges_ + 3 * rotations(); }

  int position(int node) const { return 3 * node; }
  int roll(int edge) const { return 3 * nodes_ + edge; }
  /// First of the three rotation unknowns of a joint; -1 for a corotational joint, whose rotation is not an unknown.
  int rotation(int joint) const {
    return rotation_of_joint_[joint] < 0 ? -1 : 3 * nodes_ + edges_ + 3 * rotation_of_joint_[joint];
  }
  int joint_of_rotation(int k) const { return joint_of_rotation_[k]; }

  DofClass dof_class(int dof) const {
    return dof < 3 * nodes_ ? DofClass::kPosition : dof < 3 * nodes_ + edges_ ? DofClass::kRoll : DofClass::kRotation;
  }

 private:
  int nodes_ = 0, edges_ = 0;
  std::vector<int> rotation_of_joint_;  // per joint, -1 for corotational ones
  std::vector<int> joint_of_rotation_;
};

}  // namespace lissom
