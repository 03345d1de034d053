#include "lissom/editing/kept_references.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "lissom/editing/name_keeper.h"
#include "lissom/editing/tool_constraints.h"

namespace lissom {

namespace {

/// Rewrites names in a model after an edit of its plan.
class Keeper {
 public:
  Keeper(const Plan& before, EditOutcome& outcome)
      : model_(outcome.model), names_(before, outcome.model, outcome.names) {}

  void run() {
    outline();
    sets();
    std::erase_if(model_.joints, [&](JointChoice& joint) { return gone(joint.at, "exception from the joints"); });
    for (Pose& pose : model_.poses) loads(pose);
    for (MotionCase& motion : model_.motions) {
      std::erase_if(motion.kicks, [&](MotionCase::Kick& kick) { return gone(kick.at, "kick"); });
    }
    design();
    calibration();
    std::erase_if(model_.expectations, [&](Expectation& one) { return expectation(one); });
  }

  std::string note() const {
    if (gone_.empty()) return {};
    std::string list;
    for (const auto& [what, count] : gone_) {
      list += list.empty() ? "" : ", ";
      list += count == 1 ? what : fmt::format("{} ({} times)", what, count);
    }
    return "What named nothing but what is gone went too: " + list + ".";
  }

 private:
  bool lose(const std::string& what) {
    ++gone_[what];
    return true;
  }
  bool gone(Selector& selector, const std::string& what) { return names_.keep(selector) == Kept::kNone && lose(what); }
  /// Of what needs every node that it names.
  bool incomplete(Selector& selector, const std::string& what) {
    return names_.keep(selector) != Kept::kWhole && lose(what);
  }
  /// A list where an empty one would mean all.
  bool none_left(std::vector<std::string>& names, std::vector<std::string> now, const std::string& what) {
    const bool had = !names.empty();
    names = std::move(now);
    return had && names.empty() && lose(what);
  }
  bool gone(std::vector<std::string>& rods, const std::string& what) {
    return none_left(rods, names_.keep_rods(rods), what);
  }

  void outline() {
    std::vector<std::string> now;
    for (const std::string& rod : model_.plan->fabric.outline) {
      for (std::string& name : names_.heirs().of_plan_rod(rod)) now.push_back(std::move(name));
    }
    none_left(model_.plan->fabric.outline, std::move(now), "the outline of the fabric, which is found now");
  }

  void sets() {
    keep_tools();
    const auto drop_sets = [&](const auto& keep) {
      return std::erase_if(model_.sets, [&](NamedSet& set) {
        if (keep(set.nodes) != Kept::kNone) return false;
        names_.lose_set(set.name);
        return lose("set " + set.name);
      });
    };
    drop_sets([&](Selector& nodes) { return names_.keep(nodes); });
    while (drop_sets([&](Selector& nodes) { return names_.keep_sets(nodes); }) > 0) continue;
  }

  /// The studio's own sets, which need all their points.
  void keep_tools() {
    const ToolConstraints before = constraints_of(model_);
    if (before.none()) return;
    ToolConstraints now;
    now.symmetric = before.symmetric;
    now.pinned = names_.keep_points(before.pinned);
    for (const auto& [a, b] : before.attached) {
      const std::vector<std::string> both = names_.keep_points({a, b});
      if (both.size() == 2) now.attached.push_back({both[0], both[1]});
    }
    for (const std::vector<std::string>& group : before.in_plane) {
      std::vector<std::string> all = names_.keep_points(group);
      if (all.size() >= 3) now.in_plane.push_back(std::move(all));
    }
    const std::vector<NamedSet> sets = model_.sets;
    Result<Model> changed = with_constraints(std::move(model_), now);
    LISSOM_ASSERT(changed.ok());  // these sets are ours, and no more than before
    model_ = std::move(changed).value();
    for (const NamedSet& set : sets) {
      const auto same = [&](const NamedSet& other) { return other.name == set.name; };
      if (std::any_of(model_.sets.begin(), model_.sets.end(), same)) continue;
      names_.lose_set(set.name);
      lose("set " + set.name);
    }
  }

  /// Drops what is gone and notes how the rest is numbered then; -1 for what is gone.
  template <class T, class Gone>
  static std::vector<int> drop(std::vector<T>& list, const Gone& gone) {
    std::vector<int> numbers;
    std::vector<T> kept;
    for (T& one : list) {
      const bool goes = gone(one);
      numbers.push_back(goes ? -1 : static_cast<int>(kept.size()));
      if (!goes) kept.push_back(std::move(one));
    }
    list = std::move(kept);
    return numbers;
  }

  void loads(Pose& pose) {
    Numbers& numbers = numbers_[pose.name];
    const auto at = [&](const std::string& what) {
      return [this, name = fmt::format("{} of pose {}", what, pose.name)](auto& one) { return gone(one.at, name); };
    };
    numbers[LoadBrief::Kind::kForce] = drop(pose.forces, at("force"));
    numbers[LoadBrief::Kind::kMoment] = drop(pose.moments, at("moment"));
    numbers[LoadBrief::Kind::kPinTarget] = drop(pose.soft_pins, at("soft pin"));
    numbers[LoadBrief::Kind::kMove] = drop(pose.supports, at("support"));
    std::erase_if(pose.edge_loads, at("edge load"));
    std::erase_if(pose.line_loads, [&](LineLoad& load) { return gone(load.rods, "line load of pose " + pose.name); });
  }

  bool parameter(ParameterBrief& brief) {
    if (auto* length = std::get_if<LengthBrief>(&brief.what)) return gone(length->rods, "parameter");
    if (auto* natural = std::get_if<NaturalBrief>(&brief.what)) return gone(natural->rods, "parameter");
    if (auto* plan = std::get_if<PlanBrief>(&brief.what))
      return none_left(plan->points, names_.keep_points(plan->points), "parameter");
    auto* load = std::get_if<LoadBrief>(&brief.what);
    if (load == nullptr || model_.poses.empty()) return false;
    const auto pose = numbers_.find(load->pose.empty() ? model_.poses[0].name : load->pose);
    if (pose == numbers_.end()) return false;
    const std::vector<int>& numbers = pose->second[load->kind];
    if (load->number < 0 || static_cast<std::size_t>(load->number) >= numbers.size()) return false;
    load->number = numbers[static_cast<std::size_t>(load->number)];
    return load->number < 0 && lose("parameter");
  }

  bool goal(GoalBrief& brief) {
    if (auto* places = std::get_if<PositionsGoal>(&brief.what)) return incomplete(places->at, "goal");
    if (auto* place = std::get_if<PlaceGoal>(&brief.what)) return gone(place->at, "goal");
    if (auto* reaction = std::get_if<ReactionGoal>(&brief.what)) return gone(reaction->at, "goal");
    if (auto* strain = std::get_if<StrainGoal>(&brief.what)) return gone(strain->rods, "goal");
    if (auto* mass = std::get_if<MassGoal>(&brief.what)) return mass->membranes.empty() && gone(mass->rods, "goal");
    auto* angle = std::get_if<AngleGoal>(&brief.what);
    if (angle == nullptr) return false;
    bool lost = false;
    for (Selector& end : angle->from) lost = names_.keep(end) != Kept::kWhole || lost;
    for (Selector& end : angle->to) lost = names_.keep(end) != Kept::kWhole || lost;
    return lost && lose("goal");
  }

  void design() {
    if (!model_.design) return;
    Brief& brief = *model_.design;
    const auto parameters = [&](ParameterBrief& one) { return parameter(one); };
    std::size_t lost = 0;
    for (StageBrief& stage : brief.stages) std::erase_if(stage.parameters, parameters);
    std::erase_if(brief.stages, [](const StageBrief& stage) { return stage.parameters.empty(); });
    lost += std::erase_if(brief.parameters, parameters);
    lost += std::erase_if(brief.goals, [&](GoalBrief& one) { return goal(one); });
    if (lost == 0 || (!brief.parameters.empty() && !brief.goals.empty())) return;
    model_.design.reset();
    lose("the design");
  }

  void calibration() {
    if (!model_.calibration) return;
    Calibration& brief = *model_.calibration;
    std::size_t lost = std::erase_if(brief.parameters, [&](ParameterBrief& one) { return parameter(one); });
    lost += std::erase_if(brief.measurements, [&](MeasurementBrief& one) {
      auto* pairs = std::get_if<ForceLengthBrief>(&one);
      if (pairs == nullptr) return false;
      const bool from = pairs->from && names_.keep(*pairs->from) != Kept::kWhole;
      return (names_.keep(pairs->to) != Kept::kWhole || from) && lose("measurement");
    });
    if (lost == 0 || (!brief.parameters.empty() && !brief.measurements.empty())) return;
    model_.calibration.reset();
    lose("the calibration");
  }

  bool expectation(Expectation& one) {
    const std::string what = "expected number";
    if (incomplete(one.at, what) || (one.to && incomplete(*one.to, what))) return true;
    if (one.rod.empty() || !names_.heirs().known(one.rod)) return false;
    if (one.fraction >= 0) {
      const PlaceOnRod place = names_.heirs().of(PlaceOnRod{one.rod, one.fraction});
      one.rod = place.rod;
      one.fraction = place.fraction;
      return one.rod.empty() && lose(what);
    }
    const std::vector<std::string> rods = names_.heirs().of(one.rod);
    if (rods.size() == 1) one.rod = rods[0];
    return rods.size() != 1 && lose(what);
  }

  using Numbers = std::map<LoadBrief::Kind, std::vector<int>>;

  Model& model_;
  NameKeeper names_;
  std::map<std::string, Numbers> numbers_;  ///< by pose: how what is left of its lists is numbered
  std::map<std::string, int> gone_;
};

/// Whether all that documents can name is there as before.
bool same_names(const Model& before, const EditOutcome& outcome) {
  const Model& after = outcome.model;
  const auto equal = [](const auto& a, const auto& b, const auto& same) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
  };
  const auto same_point = [](const PlanPoint& a, const PlanPoint& b) { return a.name == b.name && a.split == b.split; };
  const auto same_rod = [](const PlanRod& a, const PlanRod& b) {
    return a.name == b.name && a.points == b.points && a.role == b.role && a.closed == b.closed;
  };
  const auto same_set = [](const NamedSet& a, const NamedSet& b) { return a.name == b.name; };
  return outcome.names.points.empty() && outcome.names.rods.empty() &&
         equal(before.plan->points, after.plan->points, same_point) &&
         equal(before.plan->rods, after.plan->rods, same_rod) && equal(before.sets, after.sets, same_set);
}

}  // namespace

void keep_references(const Model& before, EditOutcome& outcome) {
  if (same_names(before, outcome)) return;
  Keeper keeper(*before.plan, outcome);
  keeper.run();
  if (std::string note = keeper.note(); !note.empty()) outcome.notes.push_back(std::move(note));
}

}  // namespace lissom
