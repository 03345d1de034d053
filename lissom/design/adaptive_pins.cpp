#include "lissom/design/adaptive_pins.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "lissom/model/structure.h"

namespace lissom {

namespace {

constexpr double kMostChange = 2;
constexpr double kWorthAChange = 1.05;

/// Where the soft pins of a pose hold nodes, by node.
Result<std::map<int, Vec3>> pin_targets(const Design& design, const Pose& pose) {
  std::map<int, Vec3> targets;
  const Structure& structure = design.system.structure;
  for (const SoftPin& pin : pose.soft_pins) {
    const Result<std::vector<int>> nodes = select(design.model, structure, pin.at, "/poses/soft_pins");
    if (!nodes) return nodes.error();
    for (const int node : nodes.value()) {
      targets[node] = pin.target.value_or(structure.nodes[static_cast<std::size_t>(node)]);
    }
  }
  return targets;
}

/// Sum of squares, and how many.
struct Squares {
  double sum = 0;
  int count = 0;
  void add(const Vec3& miss) { sum += miss.squaredNorm(), ++count; }
  double rms() const { return count > 0 ? std::sqrt(sum / count) : 0; }
};

}  // namespace

Result<VecX> pin_changes(const StructureProblem& problem, const BriefGoals& goals) {
  VecX changes = VecX::Ones(static_cast<Eigen::Index>(problem.poses().size()));
  for (std::size_t k = 0; k < problem.poses().size(); ++k) {
    const PoseFollower& follower = *problem.poses()[k];
    const Pose& pose = problem.design().model.poses[static_cast<std::size_t>(follower.pose())];
    const Result<std::map<int, Vec3>> pins = pin_targets(problem.design(), pose);
    if (!pins) return pins.error();
    const auto place = [&follower](int node) { return follower.state().position(node); };
    Squares pinned, others;
    for (const auto& [node, target] : pins.value()) pinned.add(place(node) - target);
    for (std::size_t g = 0; g < goals.goals.size(); ++g) {
      if (goals.goals[g].pose != follower.pose()) continue;
      const std::vector<int>& nodes = goals.nodes[g];
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (pins.value().contains(nodes[i])) continue;
        others.add(place(nodes[i]) - goals.goals[g].target.segment<3>(3 * static_cast<Eigen::Index>(i)));
      }
    }
    if (pinned.count == 0 || others.count == 0 || others.sum == 0) continue;
    const double change = std::clamp(pinned.rms() / others.rms(), 1 / kMostChange, kMostChange);
    if (std::max(change, 1 / change) > kWorthAChange) changes[static_cast<Eigen::Index>(k)] = change;
  }
  return changes;
}

}  // namespace lissom
