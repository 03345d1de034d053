#include "lissom/view/pose_markers.h"

#include <fmt/format.h>

namespace lissom {

Result<std::vector<Marker>> pose_markers(const Model& model, const Structure& structure, const Pose& pose,
                                         std::span<const Vec3> positions) {
  LISSOM_ASSERT(positions.size() == structure.nodes.size());
  std::vector<Marker> markers;
  const auto place = [&](const Selector& at, Marker::Kind kind, const Vec3& vector, bool shared) -> Status {
    const Result<std::vector<int>> nodes = select(model, structure, at, fmt::format("pose \"{}\"", pose.name));
    if (!nodes) return nodes.error();
    const Vec3 each = shared ? Vec3(vector / static_cast<double>(nodes.value().size())) : vector;
    for (int node : nodes.value()) markers.push_back({kind, positions[node], each});
    return {};
  };
  for (const Support& support : pose.supports) {
    if (support.kind == SupportKind::kSymmetry) continue;
    const bool clamp = support.kind == SupportKind::kClamp || support.kind == SupportKind::kClampEdge;
    const Marker::Kind kind = clamp ? Marker::Kind::kClamp : Marker::Kind::kPin;
    if (Status status = place(support.at, kind, Vec3::Zero(), false); !status) return status.error();
  }
  for (const SoftPin& pin : pose.soft_pins) {
    if (Status status = place(pin.at, Marker::Kind::kPin, Vec3::Zero(), false); !status) return status.error();
  }
  for (const PointForce& force : pose.forces) {
    Status status = place(force.at, Marker::Kind::kForce, force.force, force.shared);
    if (!status) return status.error();
  }
  return markers;
}

}  // namespace lissom
