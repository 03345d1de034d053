#include "lissom/design/brief_goals.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <utility>
#include <variant>

#include "lissom/design/brief_goal.h"
#include "lissom/design/clearance.h"
#include "lissom/design/kept_lengths.h"
#include "lissom/design/parameter_goals.h"

namespace lissom {

namespace {

constexpr double kSamePlace = 1e-9;  // of the size: targets that agree

/// Places that goals asked for before.
struct Wanted {
  Vec3 target;
  std::size_t goal;
  GoalStrength strength;
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

  Status add(const BriefGoal& made, const GoalBrief& entry, std::size_t number, BriefGoals& result) {
    bool noted = false;
    for (std::size_t i = 0; i < made.nodes.size(); ++i) {
      const Wanted wanted{made.targets[i], number, entry.strength};
      const auto [found, fresh] = wanted_.emplace(std::pair(made.goal.pose, made.nodes[i]), wanted);
      if (fresh) continue;
      const double apart = (found->second.target - wanted.target).norm();
      if (!(apart > near_)) continue;
      const std::string what = fmt::format("goals {} and {} want node {} at two places, {:.4g} mm apart",
                                           found->second.goal, number, made.nodes[i], 1e3 * apart);
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

bool moves_rest_shape(const Brief& brief) {
  return std::any_of(brief.parameters.begin(), brief.parameters.end(),
                     [](const ParameterBrief& p) { return std::holds_alternative<RestShapeBrief>(p.what); });
}

Status add_wishes(const Brief& brief, const BriefSpace& space, BriefGoals& result) {
  if (moves_rest_shape(brief)) {
    ParameterGoal lengths = make_kept_lengths(*space.base, *space.space);
    if (lengths.rows.rows() > 0) result.wishes.push_back(std::move(lengths));
  }
  if (brief.wishes.closeness > 0) {
    result.wishes.push_back(make_closeness(space.space->parameters(), space.space->start(), brief.wishes.closeness));
  }
  if (brief.wishes.clearance > 0) {
    ParameterGoal room = make_clearance(*space.base, *space.space, brief.wishes.clearance);
    if (room.rows.rows() > 0) result.wishes.push_back(std::move(room));
  }
  if (!(brief.wishes.smoothness > 0)) return {};
  if (space.neighbours.empty()) {
    return Error{ErrorCode::kConflict, "/design/wishes/smoothness", "there are no parameters that have neighbours",
                 "let radii or the rest shape change one by one, or leave it out"};
  }
  result.wishes.push_back(make_smoothness(space.space->parameters(), space.neighbours, brief.wishes.smoothness));
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
    Result<BriefGoal> one = make_brief_goal(entry, base, ground->second, pose, fmt::format("/design/goals/{}", i));
    if (!one) return one.error();
    BriefGoal& made = one.value();
    if (const Status s = places.add(made, entry, i, result); !s) return s.error();
    if (made.goal.force == GoalForce::kHard && made.goal.kind == GoalKind::kReach) {
      equalities += made.goal.objective->size();
    }
    result.goals.push_back(std::move(made.goal));
    result.nodes.push_back(std::move(made.nodes));
  }
  if (equalities > space.space->size()) {
    return Error{
        ErrorCode::kConflict, "/design/goals",
        fmt::format("hard goals ask for {} numbers, but there are only {} parameters", equalities, space.space->size()),
        "let some goals be soft, or more parameters change"};
  }
  if (const Status s = add_wishes(brief, space, result); !s) return s.error();
  return result;
}

}  // namespace lissom
