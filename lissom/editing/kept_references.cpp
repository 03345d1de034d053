#include "lissom/editing/kept_references.h"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>
#include <set>

#include "lissom/editing/rod_heirs.h"
#include "lissom/editing/tool_constraints.h"

namespace lissom {

namespace {

/// What became of a selection.
enum class Kept {
  kWhole,  ///< it selects what it did
  kPart,   ///< some of it is gone
  kNone,
};

/// Rewrites names in a model after an edit of its plan.
class Keeper {
 public:
  Keeper(const Plan& before, EditOutcome& outcome)
      : model_(outcome.model), names_(outcome.names), heirs_(before, *model_.plan, names_.points, names_.rods) {
    for (const PlanPoint& point : before.points) points_before_.insert(point.name);
    for (const PlanPoint& point : model_.plan->points) points_.insert(point.name);
  }

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
  /// The name that a point has now; empty when it is gone.
  std::string point(const std::string& name) const {
    const auto changed = names_.points.find(name);
    const std::string& now = changed == names_.points.end() ? name : changed->second;
    return points_.contains(now) ? now : std::string();
  }

  Kept keep(Selector& selector) {
    switch (selector.kind) {
      case Selector::Kind::kPlanPoint: {
        if (!points_before_.contains(selector.name)) return Kept::kWhole;
        selector.name = point(selector.name);
        return selector.name.empty() ? Kept::kNone : Kept::kWhole;
      }
      case Selector::Kind::kSet:
        return lost_sets_.contains(selector.name) ? Kept::kNone : Kept::kWhole;
      case Selector::Kind::kRod:
        return keep_rod(selector);
      case Selector::Kind::kUnion:
        return keep_union(selector);
      default:
        return Kept::kWhole;
    }
  }

  Kept keep_rod(Selector& selector) const {
    if (!heirs_.known(selector.name)) return Kept::kWhole;
    if (selector.fraction >= 0) {
      const PlaceOnRod place = heirs_.of(PlaceOnRod{selector.name, selector.fraction});
      selector.name = place.rod;
      selector.fraction = place.fraction;
      return place.rod.empty() ? Kept::kNone : Kept::kWhole;
    }
    const std::vector<std::string> rods = heirs_.of(selector.name);
    if (rods.empty()) return Kept::kNone;
    if (rods.size() == 1) {
      selector.name = rods[0];
      return Kept::kWhole;
    }
    Selector all;
    all.kind = Selector::Kind::kUnion;
    for (const std::string& rod : rods) all.parts.push_back(selector), all.parts.back().name = rod;
    selector = std::move(all);
    return Kept::kWhole;
  }

  Kept keep_union(Selector& selector) {
    Kept all = Kept::kWhole;
    std::vector<Selector> parts;
    for (Selector& part : selector.parts) {
      const Kept own = keep(part);
      if (own != Kept::kWhole) all = Kept::kPart;
      if (own == Kept::kNone) continue;
      const auto same = [&](const Selector& other) {
        return part.kind == Selector::Kind::kPlanPoint && other.kind == part.kind && other.name == part.name;
      };
      if (std::none_of(parts.begin(), parts.end(), same)) parts.push_back(std::move(part));
    }
    selector.parts = std::move(parts);
    return selector.parts.empty() ? Kept::kNone : all;
  }

  bool lose(const std::string& what) {
    ++gone_[what];
    return true;
  }
  bool gone(Selector& selector, const std::string& what) { return keep(selector) == Kept::kNone && lose(what); }
  /// Of what needs every node that it names.
  bool incomplete(Selector& selector, const std::string& what) { return keep(selector) != Kept::kWhole && lose(what); }
  /// A list of rods where an empty one would mean all.
  bool gone(std::vector<std::string>& rods, const std::string& what) {
    if (rods.empty()) return false;
    std::vector<std::string> now;
    for (const std::string& rod : rods) {
      const std::vector<std::string> own = heirs_.known(rod) ? heirs_.of(rod) : std::vector<std::string>{rod};
      for (const std::string& name : own) {
        if (std::find(now.begin(), now.end(), name) == now.end()) now.push_back(name);
      }
    }
    rods = std::move(now);
    return rods.empty() && lose(what);
  }

  void outline() {
    std::vector<std::string>& rods = model_.plan->fabric.outline;
    std::vector<std::string> now;
    for (const std::string& rod : rods) {
      for (std::string& name : heirs_.of_plan_rod(rod)) now.push_back(std::move(name));
    }
    if (now.empty() && !rods.empty()) lose("the outline of the fabric, which is found now");
    rods = std::move(now);
  }

  void sets() {
    const ToolConstraints tools = constraints_of(model_);
    std::set<std::string> before;
    for (const NamedSet& set : model_.sets) before.insert(set.name);
    if (!tools.none()) set_tools(tools);
    bool again = true;
    while (again) {
      again = false;
      std::erase_if(model_.sets, [&](NamedSet& set) {
        if (lost_sets_.contains(set.name) || keep(set.nodes) != Kept::kNone) return false;
        lost_sets_.insert(set.name);
        return again = lose("set " + set.name);
      });
    }
  }

  /// The studio's own sets, which need all their points.
  void set_tools(const ToolConstraints& tools) {
    ToolConstraints now;
    now.symmetric = tools.symmetric;
    const auto add = [&](std::vector<std::string>& to, const std::string& name) {
      const std::string here = points_before_.contains(name) ? point(name) : name;
      if (!here.empty() && std::find(to.begin(), to.end(), here) == to.end()) to.push_back(here);
    };
    for (const std::string& name : tools.pinned) add(now.pinned, name);
    for (const auto& pair : tools.attached) {
      std::vector<std::string> both;
      for (const std::string& name : pair) add(both, name);
      if (both.size() == 2) now.attached.push_back({both[0], both[1]});
    }
    for (const std::vector<std::string>& group : tools.in_plane) {
      std::vector<std::string> all;
      for (const std::string& name : group) add(all, name);
      if (all.size() >= 3) now.in_plane.push_back(std::move(all));
    }
    std::set<std::string> there;
    for (const NamedSet& set : model_.sets) there.insert(set.name);
    Result<Model> changed = with_constraints(std::move(model_), now);
    LISSOM_ASSERT(changed.ok());  // these sets are ours, and fewer than before
    model_ = std::move(changed).value();
    for (const NamedSet& set : model_.sets) there.erase(set.name);
    for (const std::string& name : there) lost_sets_.insert(name), lose("set " + name);
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
    if (auto* plan = std::get_if<PlanBrief>(&brief.what)) return points_gone(plan->points);
    auto* load = std::get_if<LoadBrief>(&brief.what);
    if (load == nullptr || model_.poses.empty()) return false;
    const auto pose = numbers_.find(load->pose.empty() ? model_.poses[0].name : load->pose);
    if (pose == numbers_.end()) return false;
    const std::vector<int>& numbers = pose->second[load->kind];
    if (load->number < 0 || static_cast<std::size_t>(load->number) >= numbers.size()) return false;
    load->number = numbers[static_cast<std::size_t>(load->number)];
    return load->number < 0 && lose("parameter");
  }

  bool points_gone(std::vector<std::string>& names) {
    if (names.empty()) return false;
    std::vector<std::string> now;
    for (const std::string& name : names) {
      std::string here = point(name);
      if (!here.empty() && std::find(now.begin(), now.end(), here) == now.end()) now.push_back(std::move(here));
    }
    names = std::move(now);
    return names.empty() && lose("parameter");
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
    for (Selector& end : angle->from) lost = keep(end) != Kept::kWhole || lost;
    for (Selector& end : angle->to) lost = keep(end) != Kept::kWhole || lost;
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
      const bool from = pairs->from && keep(*pairs->from) != Kept::kWhole;
      return (keep(pairs->to) != Kept::kWhole || from) && lose("measurement");
    });
    if (lost == 0 || (!brief.parameters.empty() && !brief.measurements.empty())) return;
    model_.calibration.reset();
    lose("the calibration");
  }

  bool expectation(Expectation& one) {
    const std::string what = "expected number";
    if (incomplete(one.at, what) || (one.to && incomplete(*one.to, what))) return true;
    if (one.rod.empty() || !heirs_.known(one.rod)) return false;
    if (one.fraction >= 0) {
      const PlaceOnRod place = heirs_.of(PlaceOnRod{one.rod, one.fraction});
      one.rod = place.rod;
      one.fraction = place.fraction;
      return one.rod.empty() && lose(what);
    }
    const std::vector<std::string> rods = heirs_.of(one.rod);
    if (rods.size() == 1) one.rod = rods[0];
    return rods.size() != 1 && lose(what);
  }

  using Numbers = std::map<LoadBrief::Kind, std::vector<int>>;

  Model& model_;
  const NameChanges& names_;
  RodHeirs heirs_;
  std::set<std::string> points_before_, points_, lost_sets_;
  std::map<std::string, Numbers> numbers_;  ///< by pose: how what is left of its lists is numbered
  std::map<std::string, int> gone_;
};

}  // namespace

void keep_references(const Plan& before, EditOutcome& outcome) {
  Keeper keeper(before, outcome);
  keeper.run();
  if (std::string note = keeper.note(); !note.empty()) outcome.notes.push_back(std::move(note));
}

}  // namespace lissom
