#include "lissom/mechanics/load_numbers.h"

namespace lissom {

VecX load_number_values(const Pose& pose, const Structure& structure) {
  const LoadNumbers layout(pose, structure);
  VecX values = VecX::Zero(layout.size());
  const auto count = [](const auto& list) { return static_cast<int>(list.size()); };
  if (pose.gravity) values.segment<3>(layout.gravity()) = pose.gravity->acceleration;
  for (int i = 0; i < count(pose.line_loads); ++i) {
    values.segment<3>(layout.line_load(i)) = pose.line_loads[i].force_per_length;
  }
  for (int i = 0; i < count(pose.edge_loads); ++i) {
    values.segment<3>(layout.edge_load(i)) = pose.edge_loads[i].force_per_length;
  }
  for (int i = 0; i < count(pose.forces); ++i) values.segment<3>(layout.force(i)) = pose.forces[i].force;
  for (int i = 0; i < count(pose.moments); ++i) values.segment<3>(layout.moment(i)) = pose.moments[i].moment;
  for (int i = 0; i < count(pose.soft_pins); ++i) {
    values[layout.pin_stiffness(i)] = pose.soft_pins[i].stiffness;
    values.segment<3>(layout.pin_target(i)) = pose.soft_pins[i].target.value_or(Vec3::Zero());
  }
  for (int n = 0; layout.has_drawn_targets() && n < count(structure.nodes); ++n) {
    values.segment<3>(layout.drawn_target(n)) = structure.nodes[n];
  }
  return values;
}

}  // namespace lissom
