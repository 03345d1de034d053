#include "lissom/design/brief_goals.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <optional>
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
#include "lissom/design/parameter_goals.h"

namespace lissom {

namespace {

constexpr double kSamePlace = 1e-9;  // of the size: targets that agree
constexpr double kFelt = 0.01;       // of a target, where an objective has no scale of its own at the start

/// What all goals of a pose share.
struct PoseGround {
  StaticProblem problem;
  State state;
};

/// Places that goals asked for before.
struct Wanted {
  Vec3 target;
  std::size_t goal;
  GoalStrength strength;
};

class GoalMaker {
 public:
  GoalMaker(const Design& design, const PoseGround& ground, int pose, std::string where)
      : design_(design), ground_(ground), pose_(pose), where_(std::move(where)) {}

  Goal goal;
  std::vector<int> nodes;      ///< of positions
  std::vector<Vec3> targets;  ///< of these

  Status operator()(const PositionsGoal& wish) {
    where_ += "/positions";
    Result<std::vector<int>> selected = select_held(wish.at);
    if (!selected) return selected.error();
    const std::size_t count = selected.value().size(), given = wish.targets.size();
    const std::size_t all = design_.system.structure.nodes.size();
    if (given != count && given != all) {
      return Error{ErrorCode::kConflict, where_,
                   fmt::format("there are {} targets for {} nodes", given, count),
                   fmt::format("give one for each, or one for each of all {} nodes of the structure", all)};
    }
    std::vector<double> places;
    for (std::size_t i = 0; i < count; ++i) {
      const int node = selected.value()[i];
      const std::size_t k = given == count ? i : static_cast<std::size_t>(node);
      const double weight = wish.weights.empty() ? 1 : wish.weights[k];
      if (weight == 0) continue;  // hard goals would hold it all the same
      nodes.push_back(node);
      targets.push_back(wish.targets[k]);
      places.push_back(weight);
    }
    const Eigen::Index n = static_cast<Eigen::Index>(places.size());
    Result<VecX> weights = weights_of_places(Eigen::Map<const VecX>(places.data(), n), 3, where_ + "/weights");
    if (!weights) return weights.error();
    goal.objective = make_node_positions(nodes);
    goal.weights = std::move(weights).value();
    goal.target.resize(3 * n);
    for (Eigen::Index i = 0; i < n; ++i) goal.target.segment<3>(3 * i) = targets[static_cast<std::size_t>(i)];
    return {};
  }
  Status operator()(const PlaceGoal& wish) {
    where_ += "/place";
    Result<std::vector<int>> selected = select_held(wish.at);
    if (!selected) return selected.error();
    goal.objective = make_set_position(std::move(selected).value());
    goal.target = wish.target;
    goal.weights = VecX::Ones(3);
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
      if (const Status s = check_held({ends.begin(), ends.end()}); !s) return s;
    }
    goal.objective = make_angle(ends, wish.axis);
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
    goal.objective = make_reaction_force(std::move(selected).value(), {wish.axis});
    return wanted(wish.wanted);
  }
  Status operator()(const AreaGoal& wish) {
    where_ += "/area";
    goal.objective = make_membrane_area(membranes(wish.membranes));
    return wanted(wish.wanted);
  }
  Status operator()(const VolumeGoal& wish) {
    where_ += "/enclosed_volume";
    Result<std::shared_ptr<const Objective>> made =
        make_enclosed_volume(design_.system.structure, membranes(wish.membranes));
    if (!made) return at_goal(made.error());
    goal.objective = std::move(made).value();
    return wanted(wish.wanted);
  }
  Status operator()(const MassGoal& wish) {
    where_ += "/mass";
    goal.objective = make_mass({rods(wish.rods), membranes(wish.membranes)});
    return wanted(wish.wanted);
  }
  Status operator()(const EnergyGoal& wish) {
    where_ += "/strain_energy";
    goal.objective = make_strain_energy();
    return wanted(wish.wanted);
  }
  Status operator()(const StretchGoal& wish) {
    where_ += "/smallest_stretch";
    goal.objective = make_smallest_stretch(design_.system.structure, membranes(wish.membranes));
    return wanted(wish.wanted);
  }
  Status operator()(const StrainGoal& wish) {
    where_ += "/rod_strain";
    goal.objective = make_rod_strain(design_.system, rods(wish.rods));
    return wanted(wish.wanted);
  }
  Status operator()(const StabilityGoal& wish) {
    where_ += "/stability_margin";
    goal.objective = make_stability_margin();
    return wanted(wish.wanted);
  }

  /// After the kind: name, scale, and what all have in common.
  Status finish(const GoalBrief& entry) {
    const Pose& pose = design_.model.poses[static_cast<std::size_t>(pose_)];
    goal.name = fmt::format("pose \"{}\": {}", pose.name, goal.objective->name());
    goal.pose = pose_;
    goal.force = entry.strength == GoalStrength::kHard ? GoalForce::kHard : GoalForce::kSoft;
    goal.weight = entry.weight;
    goal.scale = goal.objective->scale({design_, pose, ground_.problem, ground_.state});
    if (!(goal.scale > 0)) goal.scale = kFelt * goal.target.cwiseAbs().maxCoeff();
    if (!(goal.scale > 0)) {
      return Error{ErrorCode::kConflict, where_, "this is zero in the shape as drawn and is to be zero, so that nothing says "
                   "how much of it matters", "give a value that is not zero"};
    }
    return check_goal(goal, where_);
  }

 private:
  Status at_goal(Error error) const {
    error.where = where_;
    return error;
  }

  /// One value for every component.
  Status wanted(const GoalValue& value) {
    constexpr GoalKind kKinds[] = {GoalKind::kReach, GoalKind::kAtMost, GoalKind::kAtLeast};
    const int n = goal.objective->size();
    if (n == 0) {
      return Error{ErrorCode::kConflict, where_, "there is nothing that it could be measured on",
                   "name other rods or membranes"};
    }
    goal.kind = kKinds[static_cast<int>(value.kind)];
    goal.target = VecX::Constant(n, value.value);
    goal.weights = VecX::Constant(n, 1.0 / n);
    return {};
  }

  /// Where a part is that nothing holds cannot be said.
  Status check_held(const std::vector<int>& selected) const {
    const std::vector<int>& parts = ground_.problem.supports.free_parts();
    for (const int node : selected) {
      const int part = design_.system.structure.component[static_cast<std::size_t>(node)];
      if (std::find(parts.begin(), parts.end(), part) == parts.end()) continue;
      return Error{ErrorCode::kConflict, where_,
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

Result<PoseGround> make_ground(const Design& base, int pose) {
  const Pose& described = base.model.poses[static_cast<std::size_t>(pose)];
  Result<StaticProblem> problem =
      make_static_problem(base.model, base.system, described, "/poses/" + std::to_string(pose));
  if (!problem) return problem.error();
  State state = start_state(problem.value(), described);
  return PoseGround{std::move(problem).value(), std::move(state)};
}

/// Two goals that want one node at two places: both hard is a contradiction, else it is a compromise that is worth a note.
class Places {
 public:
  explicit Places(double size) : near_(kSamePlace * size) {}

  Status add(const GoalMaker& made, const GoalBrief& entry, std::size_t number, BriefGoals& result) {
    bool noted = false;
    for (std::size_t i = 0; i < made.nodes.size(); ++i) {
      const Wanted wanted{made.targets[i], number, entry.strength};
      const auto [found, fresh] = wanted_.emplace(std::pair(made.goal.pose, made.nodes[i]), wanted);
      if (fresh) continue;
      const double apart = (found->second.target - wanted.target).norm();
      if (!(apart > near_)) continue;
      const std::string what =
          fmt::format("goals {} and {} want node {} at two places, {:.4g} mm apart", found->second.goal, number,
                      made.nodes[i], 1e3 * apart);
      if (entry.strength == GoalStrength::kHard && found->second.strength == GoalStrength::kHard) {
        return Error{ErrorCode::kConflict, fmt::format("/design/goals/{}/positions", number), what,
                     "let one of them be soft, or leave the node out of it"};
      }
      if (!noted) result.notes.push_back(what);
      noted = true;
    }
    return {};
  }

 private:
  double near_;
  std::map<std::pair<int, int>, Wanted> wanted_;
};

Status add_wishes(const Brief& brief, const BriefSpace& space, BriefGoals& result) {
  if (brief.wishes.closeness > 0) {
    result.wishes.push_back(make_closeness(space.space->parameters(), space.space->start(), brief.wishes.closeness));
  }
  if (!(brief.wishes.smoothness > 0)) return {};
  if (space.neighbours.empty()) {
    return Error{ErrorCode::kConflict, "/design/wishes/smoothness", "there are no parameters that have neighbours",
                 "let radii or the rest shape change one by one, or leave it out"};
  }
  result.wishes.push_back(
      make_smoothness(space.space->parameters(), space.neighbours, brief.wishes.smoothness));
  return {};
}

}  // namespace

Result<BriefGoals> make_brief_goals(const Brief& brief, const BriefSpace& space) {
  const Design& base = *space.base;
  BriefGoals result;
  std::map<int, PoseGround> grounds;
  Places places(base.system.structure.size);
  int equalities = 0;
  for (std::size_t i = 0; i < brief.goals.size(); ++i) {
    const GoalBrief& entry = brief.goals[i];
    const int pose = brief_pose(base.model, entry.pose);
    auto ground = grounds.find(pose);
    if (ground == grounds.end()) {
      Result<PoseGround> made = make_ground(base, pose);
      if (!made) return made.error();
      ground = grounds.emplace(pose, std::move(made).value()).first;
    }
    GoalMaker made(base, ground->second, pose, fmt::format("/design/goals/{}", i));
    if (const Status s = std::visit(made, entry.what); !s) return s.error();
    if (const Status s = made.finish(entry); !s) return s.error();
    if (const Status s = places.add(made, entry, i, result); !s) return s.error();
    if (made.goal.force == GoalForce::kHard && made.goal.kind == GoalKind::kReach) {
      equalities += made.goal.objective->size();
    }
    result.goals.push_back(std::move(made.goal));
    result.nodes.push_back(std::move(made.nodes));
  }
  if (equalities > space.space->size()) {
    return Error{ErrorCode::kConflict, "/design/goals",
                 fmt::format("hard goals ask for {} numbers, but there are only {} parameters", equalities,
                             space.space->size()),
                 "let some goals be soft, or more parameters change"};
  }
  if (const Status s = add_wishes(brief, space, result); !s) return s.error();
  return result;
}

}  // namespace lissom
