#include "lissom/studio/shape_constraints.h"

#include <algorithm>
#include <cmath>

#include "lissom/editing/plan_tools.h"
#include "lissom/editing/tool_constraints.h"

namespace lissom {

namespace {

constexpr double kSamePlace = 1e-6;  // of the size of the plan

int node_of(const Model& model, const PlanParts& parts, const std::string& point) {
  for (std::size_t i = 0; i < model.plan->points.size(); ++i) {
    if (model.plan->points[i].name == point) return parts.point_nodes[i];
  }
  return -1;
}

/// Rows (a; partner) of the ties of a mirror symmetry.
MatX ties_of(const PlanMirror& mirror, double size, std::span<const Parameter> parameters) {
  std::vector<VecX> rows;
  const auto count = static_cast<Eigen::Index>(parameters.size());
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Parameter& own = parameters[i];
    if (!own.at) continue;
    const Vec2 image = mirror.image(own.at->head<2>());
    const bool turns = own.kind == ParameterKind::kPosition && own.axis == mirror.axis;
    for (std::size_t j = i; j < parameters.size(); ++j) {
      const Parameter& other = parameters[j];
      if (!other.at || other.kind != own.kind || other.axis != own.axis) continue;
      if ((other.at->head<2>() - image).norm() > kSamePlace * size) continue;
      if (i == j && !turns) break;  // its own image, and free to change
      VecX row = VecX::Zero(count);
      row[static_cast<Eigen::Index>(i)] += own.scale;
      row[static_cast<Eigen::Index>(j)] += (turns ? 1 : -1) * other.scale;
      rows.push_back(row / row.norm());
      break;
    }
  }
  MatX ties(static_cast<Eigen::Index>(rows.size()), count);
  for (std::size_t i = 0; i < rows.size(); ++i) ties.row(static_cast<Eigen::Index>(i)) = rows[i].transpose();
  return ties;
}

}  // namespace

HardConstraints hard_constraints(const Model& model, const PlanParts& parts, std::span<const Parameter> parameters) {
  const ToolConstraints kept = constraints_of(model);
  HardConstraints constraints;
  for (const std::string& point : kept.pinned) {
    if (const int node = node_of(model, parts, point); node >= 0) constraints.pinned.push_back(node);
  }
  for (const auto& [a, b] : kept.attached) {
    const int from = node_of(model, parts, a), to = node_of(model, parts, b);
    if (from >= 0 && to >= 0) constraints.attached.push_back({from, to});
  }
  for (const std::vector<std::string>& set : kept.in_plane) {
    std::vector<int> nodes;
    for (const std::string& point : set) {
      if (const int node = node_of(model, parts, point); node >= 0) nodes.push_back(node);
    }
    if (nodes.size() > 3) constraints.in_plane.push_back(std::move(nodes));
  }
  if (kept.symmetric) constraints.ties = ties_of(*kept.symmetric, plan_size(*model.plan), parameters);
  return constraints;
}

std::vector<PinnedNode> pinned_nodes(const Model& model, const PlanParts& parts,
                                     const std::map<std::string, Vec3>& places) {
  std::vector<PinnedNode> pins;
  for (const std::string& point : constraints_of(model).pinned) {
    const auto place = places.find(point);
    const int node = node_of(model, parts, point);
    if (place != places.end() && node >= 0) pins.push_back({node, place->second});
  }
  return pins;
}

}  // namespace lissom
