#include <algorithm>
#include <fmt/format.h>

#include "lissom/model/discretize_parts.h"

namespace lissom {

namespace {

/// What is to be built at a node.
struct NodePlan {
  bool meets = false;  ///< rods meet here
  JointKind kind = JointKind::kBall;
  bool frame = false;  ///< a pose needs a frame here
};

Status apply_choices(const Draft& draft, std::vector<NodePlan>& plans) {
  const Model& model = draft.model;
  for (size_t i = 0; i < model.joints.size(); ++i) {
    const std::string where = fmt::format("/joints/{}", i);
    const Result<std::vector<int>> nodes = select(model, draft.structure, model.joints[i].at, where);
    if (!nodes) return nodes.error();
    bool any = false;
    for (int node : nodes.value()) {
      NodePlan& plan = plans[static_cast<size_t>(node)];
      if (!plan.meets) continue;
      plan.kind = model.joints[i].kind;
      any = true;
    }
    if (any) continue;
    return Error{ErrorCode::kGeometry, where, "no rods meet at the selected place",
                 "select a point that two rods share, or raise the merge distance if they should meet there"};
  }
  return {};
}

bool needs_frame(const Support& support) {
  switch (support.kind) {
    case SupportKind::kClamp:
    case SupportKind::kSymmetry:
      return true;
    case SupportKind::kFree:
      return !support.rotations.empty() || support.turn_angle != 0;
    case SupportKind::kPin:
    case SupportKind::kClampEdge:
      return false;
  }
  return false;
}

Status mark_frames(const Draft& draft, std::vector<NodePlan>& plans) {
  const auto mark = [&](const Selector& at, const std::string& where) -> Status {
    const Result<std::vector<int>> nodes = select(draft.model, draft.structure, at, where);
    if (!nodes) return nodes.error();
    for (int node : nodes.value()) plans[static_cast<size_t>(node)].frame = true;
    return {};
  };
  for (size_t p = 0; p < draft.model.poses.size(); ++p) {
    const Pose& pose = draft.model.poses[p];
    for (size_t i = 0; i < pose.supports.size(); ++i) {
      if (!needs_frame(pose.supports[i])) continue;
      if (Status s = mark(pose.supports[i].at, fmt::format("/poses/{}/supports/{}", p, i)); !s) return s;
    }
    for (size_t i = 0; i < pose.moments.size(); ++i) {
      if (Status s = mark(pose.moments[i].at, fmt::format("/poses/{}/moments/{}", p, i)); !s) return s;
    }
  }
  return {};
}

/// One joint per node that has one, ascending, kinds decided; `joint_at` gives its number by node.
std::vector<int> make_joints(Draft& draft, const std::vector<NodePlan>& plans) {
  Structure& s = draft.structure;
  std::vector<int> joint_at(plans.size(), -1);
  int turned_explicit = 0, held_balls = 0;
  for (size_t node = 0; node < plans.size(); ++node) {
    const NodePlan& plan = plans[node];
    const bool joint = plan.meets && plan.kind != JointKind::kBall;
    if (!joint && !plan.frame) continue;
    turned_explicit += joint && plan.frame && plan.kind == JointKind::kCorotational;
    held_balls += plan.meets && plan.frame && plan.kind == JointKind::kBall;
    joint_at[node] = static_cast<int>(s.joints.size());
    s.joints.push_back({static_cast<int>(node), plan.frame ? JointKind::kExplicit : plan.kind, !joint, {}});
  }
  if (turned_explicit > 0) {
    s.notes.push_back(fmt::format(
        "{} corotational joints are explicit ones here, because a pose holds, turns or loads their rotation",
        turned_explicit));
  }
  if (held_balls > 0) {
    s.notes.push_back(
        fmt::format("{} ball points are rigid joints here, because a pose holds, turns or loads a rotation there: "
                    "exact while it is "
                    "clamped, too stiff in a pose that leaves it free",
                    held_balls));
  }
  return joint_at;
}

}  // namespace

Status set_joints_and_pairs(Draft& draft) {
  Structure& s = draft.structure;
  std::vector<NodePlan> plans(s.nodes.size());
  for (size_t node = 0; node < plans.size(); ++node) {
    plans[node].meets = draft.passages[node] > 1;
    if (plans[node].meets) plans[node].kind = draft.model.joint_kind;
  }
  if (Status status = apply_choices(draft, plans); !status) return status;
  if (Status status = mark_frames(draft, plans); !status) return status;
  const std::vector<int> joint_at = make_joints(draft, plans);
  const auto connect = [&](int node, int rod, int edge, bool at_end) {
    const int joint = joint_at[static_cast<size_t>(node)];
    if (joint < 0) return false;
    const int number = s.rods[static_cast<size_t>(rod)].edges[static_cast<size_t>(edge)];
    s.joints[static_cast<size_t>(joint)].connections.push_back(
        {number, at_end ? -1 : 1, connection_rest(draft, rod, edge, at_end)});
    return true;
  };
  for (int r = 0; r < static_cast<int>(s.rods.size()); ++r) {
    const StructureRod& rod = s.rods[static_cast<size_t>(r)];
    const int n = static_cast<int>(rod.edges.size());
    for (int i = 0; i < n; ++i) {
      const StructureEdge& edge = s.edges[static_cast<size_t>(rod.edges[static_cast<size_t>(i)])];
      connect(edge.node0, r, i, false);
      if (connect(edge.node1, r, i, true) || (i == n - 1 && !rod.closed)) continue;
      const int next = (i + 1) % n;
      const PairStrain rest = rest_strain(draft, r, i, next);
      s.pairs.push_back({rod.edges[static_cast<size_t>(i)], rod.edges[static_cast<size_t>(next)], rest.kappa_1,
                         rest.kappa_2, rest.twist});
    }
  }
  return {};
}

}  // namespace lissom
