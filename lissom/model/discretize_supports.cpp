#include <cmath>
#include <fmt/format.h>
#include <map>

#include "lissom/model/discretize_parts.h"

namespace lissom {

namespace {

/// What one support does to one node at load factor 1.
struct Hold {
  size_t support = 0;
  std::vector<Vec3> directions;  ///< along which the position is held
  Vec3 move = Vec3::Zero();      ///< m
  bool turns = false;            ///< holds the rotation
  Vec3 turn = Vec3::Zero();      ///< rad
};

Hold hold_of(const Support& support, size_t number, const Vec3& inwards) {
  Hold hold{number, {}, support.move, false, support.turn_angle * support.turn_axis.stableNormalized()};
  if (support.move_inwards && inwards.norm() > 0) hold.move += *support.move_inwards * inwards.normalized();
  switch (support.kind) {
    case SupportKind::kSymmetry:
      hold.directions = {support.normal.stableNormalized()};
      hold.move.setZero();
      break;
    case SupportKind::kFree:
      hold.directions = support.directions;
      hold.turns = !support.rotations.empty();
      break;
    case SupportKind::kPin:
    case SupportKind::kClamp:
    case SupportKind::kClampEdge:
      hold.directions = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
      hold.turns = support.kind != SupportKind::kPin;
  }
  return hold;
}

/// Whether `later`, which has the last word on a node, takes back what `earlier` says about it.
bool contradicts(const Hold& earlier, const Hold& later) {
  constexpr double kEqual = 1e-9;
  const Vec3 difference = later.move - earlier.move;
  const double scale = kEqual * (earlier.move.norm() + later.move.norm());
  if (!later.directions.empty()) {
    for (const Vec3& direction : earlier.directions) {
      if (std::abs(direction.dot(difference)) > scale) return true;
    }
  }
  return earlier.turns && later.turns &&
         (later.turn - earlier.turn).norm() > kEqual * (earlier.turn.norm() + later.turn.norm());
}

Status check_pose(const Draft& draft, const Pose& pose, const std::string& where) {
  const Structure& s = draft.structure;
  std::map<int, std::vector<Hold>> holds;
  for (size_t i = 0; i < pose.supports.size(); ++i) {
    const std::string here = fmt::format("{}/supports/{}", where, i);
    const Result<std::vector<int>> nodes = select(draft.model, s, pose.supports[i].at, here + "/at");
    if (!nodes) return nodes.error();
    Vec3 centre = Vec3::Zero();
    for (const int node : nodes.value()) centre += s.nodes[static_cast<size_t>(node)] / double(nodes.value().size());
    for (const int node : nodes.value()) {
      const Vec3& place = s.nodes[static_cast<size_t>(node)];
      Hold hold = hold_of(pose.supports[i], i, centre - place);
      std::vector<Hold>& earlier = holds[node];
      for (const Hold& other : earlier) {
        if (!contradicts(other, hold)) continue;
        return Error{ErrorCode::kConflict, here,
                     fmt::format("this support and support {} hold the node at ({:.4g}, {:.4g}, {:.4g}) mm and move it "
                                 "differently",
                                 other.support, 1e3 * place.x(), 1e3 * place.y(), 1e3 * place.z()),
                     "hold and move it in one support"};
      }
      earlier.push_back(std::move(hold));
    }
  }
  return {};
}

}  // namespace

Status check_supports(const Draft& draft) {
  for (size_t p = 0; p < draft.model.poses.size(); ++p) {
    const Pose& pose = draft.model.poses[p];
    if (pose.frozen || pose.supports.size() < 2) continue;
    if (Status s = check_pose(draft, pose, fmt::format("/poses/{}", p)); !s) return s;
  }
  return {};
}

}  // namespace lissom
