#include "lissom/design/brief_goal.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <utility>

#include "lissom/design/objective_angle.h"
#include "lissom/design/objective_enclosed_volume.h"
#include "lissom/design/objective_mass.h"
#include "lissom/design/objective_membrane_area.h"
#include "lissom/design/objective_node_positions.h"
#include "lissom/design/objective_reaction_force.h"
#include "lissom/design/objective_rigid_motion.h"
#include "lissom/design/objective_rod_strain.h"
#include "lissom/design/objective_smallest_stretch.h"
#include "lissom/design/objective_stability_margin.h"
#include "lissom/design/objective_strain_energy.h"

namespace lissom {

namespace {

constexpr double kFelt = 0.01;  // of a target, where an objective has no scale of its own at the start

class GoalMaker {
 public:
  GoalMaker(const Design& design, const PoseGround& ground, int pose, std::string where)
      : design_(design), ground_(ground), pose_(pose), where_(std::move(where)) {}

  BriefGoal made;

  Status operator()(const PositionsGoal& wish) {
    where_ += "/positions";
    Result<std::vector<int>> selected = select_held(wish.at);
    if (!selected) return selected.error();
    const std::size_t count = selected.value().size(), given = wish.targets.size();
    const std::size_t all = design_.system.structure.nodes.size();
    if (given != count && given != all) {
      return Error{ErrorCode::kConflict, where_, fmt::format("there are {} targets for {} nodes", given, count),
                   fmt::format("give one for each, or one for each of all {} nodes of the structure", all)};
    }
    std::vector<double> places;
    for (std::size_t i = 0; i < count; ++i) {
      const int node = selected.value()[i];
      const std::size_t k = given == count ? i : static_cast<std::size_t>(node);
      const double weight = wish.weights.empty() ? 1 : wish.weights[k];
      if (weight == 0) continue;  // hard goals would hold it all the same
      made.nodes.push_back(node);
      made.targets.push_back(wish.targets[k]);
      places.push_back(weight);
    }
    const Eigen::Index n = static_cast<Eigen::Index>(places.size());
    Result<VecX> weights = weights_of_places(Eigen::Map<const VecX>(places.data(), n), 3, where_ + "/weights");
    if (!weights) return weights.error();
    made.goal.objective = make_node_positions(made.nodes);
    made.goal.weights = std::move(weights).value();
    made.goal.target.resize(3 * n);
    for (Eigen::Index i = 0; i < n; ++i) made.goal.target.segment<3>(3 * i) = made.targets[static_cast<std::size_t>(i)];
    return {};
  }
  Status operator()(const PlaceGoal& wish) {
    where_ += "/place";
    Result<std::vector<int>> selected = select_held(wish.at);
    if (!selected) return selected.error();
    made.goal.objective = make_set_position(std::move(selected).value());
    made.goal.target = wish.target;
    made.goal.weights = VecX::Ones(3);
    return {};
  }
  Status operator()(const AngleGoal& wish) {
    where_ += "/angle";
    std::array<int, 4> ends{};
    for (std::size_t i = 0; i < 4; ++i) {
      const std::string place = fmt::format("{}/{}/{}", where_, i < 2 ? "from" : "to", i % 2);
      const Selector& at = i < 2 ? wish.from[i] : wish.to[i - 2];
      const Result<std::vector<int>> one = select(design_.model, design_.system.structure, at, place);
      if (!one) return one.error();
      if (one.value().size() != 1) {
        return Error{ErrorCode::kConflict, place, fmt::format("these are {} nodes", one.value().size()), "name one"};
      }
      ends[i] = one.value().front();
    }
    if (ends[0] == ends[1] || ends[2] == ends[3]) {
      return Error{ErrorCode::kConflict, where_, "a direction goes from a node to itself", "name two nodes"};
    }
    if (wish.axis) {
      if (Status s = check_held({ends.begin(), ends.end()}); !s) return s;
    }
    made.goal.objective = make_angle(ends, wish.axis);
    return wanted(wish.wanted);
  }
  Status operator()(const ReactionGoal& wish) {
    where_ += "/reaction";
    Result<std::vector<int>> selected = select(design_.model, design_.system.structure, wish.at, where_ + "/at");
    if (!selected) return selected.error();
    const bool held = std::any_of(selected.value().begin(), selected.value().end(), [this](int node) {
      for (int i = 0; i < 3; ++i) {
        if (ground_.problem.supports.held_by_pose(3 * node + i)) return true;
      }
      return false;
    });
    if (!held) {
      return Error{ErrorCode::kConflict, where_ + "/at", "the pose holds none of these nodes, so they carry nothing",
                   "name nodes of a support"};
    }
    made.goal.objective = make_reaction_force(std::move(selected).value(), {wish.axis});
    return wanted(wish.wanted);
  }
  Status operator()(const AreaGoal& wish) {
    where_ += "/area";
    made.goal.objective = make_membrane_area(membranes(wish.membranes));
    return wanted(wish.wanted);
  }
  Status operator()(const VolumeGoal& wish) {
    where_ += "/enclosed_volume";
    Result<std::shared_ptr<const Objective>> objective =
        make_enclosed_volume(design_.system.structure, membranes(wish.membranes));
    if (!objective) return at_goal(objective.error());
    made.goal.objective = std::move(objective).value();
    return wanted(wish.wanted);
  }
  Status operator()(const MassGoal& wish) {
    where_ += "/mass";
    made.goal.objective = make_mass({rods(wish.rods), membranes(wish.membranes)});
    return wanted(wish.wanted);
  }
  Status operator()(const EnergyGoal& wish) {
    where_ += "/strain_energy";
    made.goal.objective = make_strain_energy();
    return wanted(wish.wanted);
  }
  Status operator()(const StretchGoal& wish) {
    where_ += "/smallest_stretch";
    made.goal.objective = make_smallest_stretch(design_.system.structure, membranes(wish.membranes));
    return wanted(wish.wanted);
  }
  Status operator()(const StrainGoal& wish) {
    where_ += "/rod_strain";
    made.goal.objective = make_rod_strain(design_.system, rods(wish.rods));
    return wanted(wish.wanted);
  }
  Status operator()(const StabilityGoal& wish) {
    where_ += "/stability_margin";
    made.goal.objective = make_stability_margin();
    return wanted(wish.wanted);
  }

  /// After the kind: name, scale, and what all have in common.
  Status finish(const GoalBrief& entry) {
    const Pose& pose = design_.model.poses[static_cast<std::size_t>(pose_)];
    made.goal.name = fmt::format("pose \"{}\": {}", pose.name, made.goal.objective->name());
    made.goal.pose = pose_;
    made.goal.force = entry.strength == GoalStrength::kHard ? GoalForce::kHard : GoalForce::kSoft;
    made.goal.weight = entry.weight;
    made.goal.scale = made.goal.objective->scale({design_, pose, ground_.problem, ground_.state});
    if (!(made.goal.scale > 0)) made.goal.scale = kFelt * made.goal.target.cwiseAbs().maxCoeff();
    if (!(made.goal.scale > 0)) {
      return Error{ErrorCode::kConflict, where_,
                   "this is zero in the shape as drawn and is to be zero, so that nothing says "
                   "how much of it matters",
                   "give a value that is not zero"};
    }
    return check_goal(made.goal, where_);
  }

 private:
  Status at_goal(Error error) const {
    error.where = where_;
    return error;
  }

  /// One value for every component.
  Status wanted(const GoalValue& value) {
    constexpr GoalKind kKinds[] = {GoalKind::kReach, GoalKind::kAtMost, GoalKind::kAtLeast};
    const int n = made.goal.objective->size();
    if (n == 0) {
      return Error{ErrorCode::kConflict, where_, "there is nothing that it could be measured on",
                   "name other rods or membranes"};
    }
    made.goal.kind = kKinds[static_cast<int>(value.kind)];
    made.goal.target = VecX::Constant(n, value.value);
    made.goal.weights = VecX::Constant(n, 1.0 / n);
    return {};
  }

  /// Where a part is that nothing holds cannot be said.
  Status check_held(const std::vector<int>& selected) const {
    const std::vector<int>& parts = ground_.problem.supports.free_parts();
    for (const int node : selected) {
      const int part = design_.system.structure.component[static_cast<std::size_t>(node)];
      if (std::find(parts.begin(), parts.end(), part) == parts.end()) continue;
      return Error{
          ErrorCode::kConflict, where_,
          fmt::format("pose \"{}\" does not hold the part that node {} belongs to, so that it may lie anywhere",
                      design_.model.poses[static_cast<std::size_t>(pose_)].name, node),
          "hold it with a support or soft pins"};
    }
    return {};
  }
  Result<std::vector<int>> select_held(const Selector& at) const {
    Result<std::vector<int>> selected = select(design_.model, design_.system.structure, at, where_ + "/at");
    if (!selected) return selected;
    if (const Status s = check_held(selected.value()); !s) return s.error();
    return selected;
  }

  std::vector<int> membranes(const std::vector<std::string>& names) const {
    std::vector<int> numbers;
    const auto& all = design_.system.structure.membranes;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (std::find(names.begin(), names.end(), all[i].name) != names.end()) numbers.push_back(static_cast<int>(i));
    }
    return numbers;
  }
  /// Rods that joints cut are several: NAME-0, NAME-1.
  std::vector<int> rods(const std::vector<std::string>& names) const {
    std::vector<int> numbers;
    const auto& all = design_.system.structure.rods;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (std::find(names.begin(), names.end(), all[i].name) != names.end()) numbers.push_back(static_cast<int>(i));
    }
    return numbers;
  }

  const Design& design_;
  const PoseGround& ground_;
  int pose_;
  std::string where_;
};

}  // namespace

Result<BriefGoal> make_brief_goal(const GoalBrief& entry, const Design& design, const PoseGround& ground, int pose,
                                  const std::string& where) {
  GoalMaker maker(design, ground, pose, where);
  if (const Status s = std::visit(maker, entry.what); !s) return s.error();
  if (const Status s = maker.finish(entry); !s) return s.error();
  return std::move(maker.made);
}

}  // namespace lissom
