#include "lissom/mechanics/supports_builder.h"

#include <cmath>
#include <utility>

namespace lissom {

namespace {

/// Projector onto orthogonal directions.
Mat3 span_of(const std::vector<Vec3>& directions) {
  Mat3 projector = Mat3::Zero();
  for (const Vec3& d : directions) projector += d * d.transpose() / d.squaredNorm();
  return projector;
}

}  // namespace

SupportsBuilder::SupportsBuilder(const Model& model, const System& system, const Pose& pose, std::string where)
    : model_(model), system_(system), pose_(pose), where_(std::move(where)) {
  supports_.held_.assign(system.layout.size(), false);
  supports_.supports_ = static_cast<int>(pose.supports.size());
}

Result<Supports> SupportsBuilder::build(NullMotions null_motions) {
  if (pose_.frozen) {
    supports_.held_.assign(system_.layout.size(), true);
  }
  for (size_t i = 0; i < pose_.supports.size() && !pose_.frozen; ++i) {
    const std::string where = where_ + "/supports/" + std::to_string(i);
    const Result<std::vector<int>> nodes = select(model_, system_.structure, pose_.supports[i].at, where + "/at");
    if (!nodes) return nodes.error();
    const std::size_t before = supports_.positions_.size();
    const Status status = apply(pose_.supports[i], nodes.value(), where);
    if (!status) return status.error();
    for (std::size_t k = before; k < supports_.positions_.size(); ++k) {
      supports_.positions_[k].support = static_cast<int>(i);
      supports_.positions_[k].moves = pose_.supports[i].kind != SupportKind::kSymmetry;
    }
  }
  std::vector<bool> removed = supports_.held_;
  if (!pose_.frozen) {
    const Status status = remove_null_motions(model_, system_, pose_, where_, supports_.local_axes_, null_motions,
                                              removed, supports_.removed_, supports_.free_parts_);
    if (!status) return status.error();
  }
  supports_.kept_.assign(removed.size(), -1);
  for (size_t i = 0; i < removed.size(); ++i) {
    if (!removed[i]) supports_.kept_[i] = supports_.unknowns_++;
  }
  return std::move(supports_);
}

Status SupportsBuilder::apply(const Support& support, const std::vector<int>& nodes, const std::string& where) {
  Vec3 centre = Vec3::Zero();
  for (const int node : nodes) centre += system_.structure.nodes[node] / static_cast<double>(nodes.size());
  for (const int node : nodes) {
    const Vec3 inwards = centre - system_.structure.nodes[node];
    Vec3 move = support.move + support.shrink * inwards;
    move += support.deform * system_.structure.nodes[node] - system_.structure.nodes[node];
    if (support.move_inwards) {
      if (inwards.norm() > 0) move += *support.move_inwards * inwards.normalized();
    }
    Status status;
    switch (support.kind) {
      case SupportKind::kPin:
        hold_position(node, move);
        break;
      case SupportKind::kClamp: {
        const Result<int> joint = frame_at(node, where);
        if (!joint) return joint.error();
        hold_position(node, move);
        const int r = system_.layout.rotation(joint.value());
        for (int i = 0; i < 3; ++i) supports_.held_[r + i] = true;
        supports_.rotations_.push_back({joint.value(), support.turn_angle * support.turn_axis.normalized()});
        break;
      }
      case SupportKind::kClampEdge:
        status = hold_edge(support, node, move, where);
        break;
      case SupportKind::kFree:
        status = hold_free(support, node, move, where);
        break;
      case SupportKind::kSymmetry:
        status = hold_symmetry(support, node, where);
        break;
    }
    if (!status) return status;
  }
  if (support.kind == SupportKind::kFree && support.roll) hold_rolls_within(nodes);
  if (support.kind == SupportKind::kSymmetry) hold_rolls_within(nodes);
  return {};
}

void SupportsBuilder::hold_position(int node, const Vec3& move) {
  const int at = system_.layout.position(node);
  for (int i = 0; i < 3; ++i) supports_.held_[at + i] = true;
  supports_.positions_.push_back({node, move});
}

Status SupportsBuilder::hold_free(const Support& support, int node, const Vec3& move, const std::string& where) {
  if (!support.directions.empty()) {
    const int at = system_.layout.position(node);
    Status status = hold_directions(at, support.directions, where);
    if (!status) return status;
    supports_.positions_.push_back({node, move});
    supports_.positions_.back().along = span_of(support.directions);
  }
  if (!support.rotations.empty()) {
    const Result<int> joint = frame_at(node, where);
    if (!joint) return joint.error();
    Status status = hold_directions(system_.layout.rotation(joint.value()), support.rotations, where);
    if (!status) return status;
    supports_.rotations_.push_back({joint.value(), support.turn_angle * support.turn_axis.normalized()});
  }
  return {};
}

Status SupportsBuilder::hold_edge(const Support& support, int node, const Vec3& move, const std::string& where) {
  int found = 0;
  for (int e = 0; e < system_.edge_count(); ++e) {
    const StructureEdge& edge = system_.structure.edges[e];
    if (edge.node0 != node && edge.node1 != node) continue;
    ++found;
    const Vec3 pivot = system_.structure.nodes[node];
    const Vec3 turn = support.turn_angle * support.turn_axis.normalized();
    for (const int held : {edge.node0, edge.node1}) {
      hold_position(held, move);
      supports_.positions_.back().arm = system_.structure.nodes[held] - pivot;
      supports_.positions_.back().turn = turn;
    }
    const int roll = system_.layout.roll(e);
    supports_.held_[roll] = true;
    supports_.rolls_.push_back({e, edge.drawn.b, turn});
  }
  if (found != 1) {
    return Error{
        ErrorCode::kConflict, where + "/at",
        "clamp_edge needs a free rod end, but " + std::to_string(found) + " edges meet at node " + std::to_string(node),
        "use hold \"clamp\" here"};
  }
  return {};
}

Status SupportsBuilder::hold_symmetry(const Support& support, int node, const std::string& where) {
  const Vec3 normal = support.normal.normalized();
  Status status = hold_directions(system_.layout.position(node), {normal}, where);
  if (!status) return status;
  supports_.positions_.push_back({node});
  supports_.positions_.back().along = span_of({normal});
  const int joint = system_.joint_of_node[node];
  const int r = joint < 0 ? -1 : system_.layout.rotation(joint);
  if (r < 0) return {};
  // A reflection turns rotation vectors in the plane around: only the one along the normal is left.
  const Vec3 u = normal.unitOrthogonal();
  return hold_directions(r, {u, normal.cross(u)}, where);
}

Status SupportsBuilder::hold_directions(int first_dof, const std::vector<Vec3>& directions, const std::string& where) {
  // Existing axes at this place are kept; directions must be among them.
  LocalAxes* local = nullptr;
  for (LocalAxes& candidate : supports_.local_axes_) {
    if (candidate.first_dof == first_dof) local = &candidate;
  }
  const bool untouched =
      !supports_.held_[first_dof] && !supports_.held_[first_dof + 1] && !supports_.held_[first_dof + 2];
  const auto axis_of = [](const Mat3& axes, const Vec3& direction) {
    for (int i = 0; i < 3; ++i) {
      if (std::abs(axes.col(i).dot(direction)) > 1 - 1e-12) return i;
    }
    return -1;
  };
  bool aligned = true;
  const Mat3 present = local != nullptr ? local->axes : Mat3::Identity();
  for (const Vec3& d : directions) aligned = aligned && axis_of(present, d.normalized()) >= 0;
  if (!aligned) {
    if (!untouched || local != nullptr) {
      return Error{ErrorCode::kConflict, where,
                   "two supports hold the same node along directions that are not at right angles",
                   "hold the node in one support with all its directions"};
    }
    Mat3 axes;
    axes.col(0) = directions[0].normalized();
    axes.col(1) = directions.size() > 1 ? directions[1].normalized() : axes.col(0).unitOrthogonal();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    supports_.local_axes_.push_back({first_dof, axes});
    local = &supports_.local_axes_.back();
  }
  const Mat3 axes = local != nullptr ? local->axes : Mat3::Identity();
  for (const Vec3& d : directions) {
    const int i = axis_of(axes, d.normalized());
    if (i < 0) {
      return Error{ErrorCode::kConflict, where, "the held directions are not at right angles",
                   "give orthogonal unit vectors"};
    }
    supports_.held_[first_dof + i] = true;
  }
  return {};
}

Result<int> SupportsBuilder::frame_at(int node, const std::string& where) const {
  const int joint = system_.joint_of_node[node];
  if (joint >= 0 && system_.layout.rotation(joint) >= 0) return joint;
  return Error{ErrorCode::kConflict, where + "/at",
               "node " + std::to_string(node) + " has no frame of its own to hold or turn",
               "make the joint there explicit, or hold positions only"};
}

void SupportsBuilder::hold_rolls_within(const std::vector<int>& nodes) {
  std::vector<bool> selected(system_.structure.nodes.size(), false);
  for (const int node : nodes) selected[node] = true;
  for (int e = 0; e < system_.edge_count(); ++e) {
    const StructureEdge& edge = system_.structure.edges[e];
    if (!selected[edge.node0] || !selected[edge.node1]) continue;
    supports_.held_[system_.layout.roll(e)] = true;
    supports_.rolls_.push_back({e, edge.drawn.b});
  }
}

}  // namespace lissom
