#pragma once
/// Order of all numbers of the loads of a pose. In the links of stencils they follow those of the structure: load number i
/// is number RestNumbers::size + i, so that gradient_by_rest(potential, state, RestNumbers::size + LoadNumbers::size) has
/// both blocks.

#include "lissom/core/types.h"
#include "lissom/model/pose.h"
#include "lissom/model/structure.h"

namespace lissom {

/// Components of gravity (m/s^2), of line and edge loads (N/m), forces (N), moments (N m), as the pose states them; of soft
/// pins the stiffness (N/m) and the target (m); then the target of each node for pins without one of their own, which is
/// where the node is drawn.
class LoadNumbers {
 public:
  LoadNumbers(const Pose& pose, const Structure& structure)
      : line_loads_(pose.gravity ? 3 : 0),
        edge_loads_(line_loads_ + 3 * static_cast<int>(pose.line_loads.size())),
        forces_(edge_loads_ + 3 * static_cast<int>(pose.edge_loads.size())),
        moments_(forces_ + 3 * static_cast<int>(pose.forces.size())),
        pins_(moments_ + 3 * static_cast<int>(pose.moments.size())),
        drawn_(pins_ + kPin * static_cast<int>(pose.soft_pins.size())),
        size_(drawn_ + (pose.soft_pins.empty() ? 0 : 3 * static_cast<int>(structure.nodes.size()))) {}

  /// First of three components.
  int gravity() const { return 0; }
  int line_load(int i) const { return line_loads_ + 3 * i; }
  int edge_load(int i) const { return edge_loads_ + 3 * i; }
  int force(int i) const { return forces_ + 3 * i; }
  int moment(int i) const { return moments_ + 3 * i; }
  int pin_stiffness(int i) const { return pins_ + kPin * i; }
  int pin_target(int i) const { return pins_ + kPin * i + 1; }
  /// There is none where the pose has no soft pins.
  int drawn_target(int node) const { return drawn_ + 3 * node; }
  bool has_drawn_targets() const { return size_ > drawn_; }
  int size() const { return size_; }

 private:
  static constexpr int kPin = 4;
  int line_loads_ = 0, edge_loads_ = 0, forces_ = 0, moments_ = 0, pins_ = 0, drawn_ = 0, size_ = 0;
};

/// All of them, in this order; 0 for the target of a pin that has none of its own.
VecX load_number_values(const Pose& pose, const Structure& structure);

}  // namespace lissom
