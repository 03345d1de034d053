#include "lissom/design/calibration_steps.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "lissom/design/brief_space.h"
#include "lissom/design/calibration_loads.h"
#include "lissom/design/objective_distance.h"
#include "lissom/design/objective_node_positions.h"
#include "lissom/design/objective_reaction_force.h"

namespace lissom {

namespace {

constexpr double kFelt = 0.01;  // of what is measured: nominal standard deviation where none is known

using Prescribed = ForceLengthBrief::Prescribed;

Goal goal_of(const std::string& where, int pose, std::shared_ptr<const Objective> objective) {
  Goal goal;
  goal.name = where;
  goal.pose = pose;
  goal.target = VecX::Zero(objective->size());
  goal.weights = VecX::Zero(objective->size());
  goal.objective = std::move(objective);
  return goal;
}

class StepMaker {
 public:
  StepMaker(const Design& base, CalibrationSteps& out) : base_(base), out_(out) {}

  Status operator()(const ForceLengthData& data) {
    const int pose = brief_pose(base_.model, data.brief.pose);
    const Result<LengthLoads> made = LengthLoads::make(base_, pose, data.brief, data.where + "/force_length");
    if (!made) return made.error();
    const LengthLoads& loads = made.value();
    const double shift = data.meaning == ForceLengthData::Length::kChange ? loads.drawn_length() : 0;
    const bool by_force = data.brief.prescribed == Prescribed::kForce;
    for (const ForceLengthPair& pair : data.pairs) {
      const double length = pair.length + shift;
      Result<Pose> loaded = by_force ? loads.with_force(pair.force) : loads.with_length(length, pair.where);
      if (!loaded) return loaded.error();
      const int step = add_step(std::move(loaded).value(), pose, pair.where);
      out_.steps.back().meaning = data.meaning;
      Goal goal = goal_of(pair.where, out_.steps.back().pose, by_force ? loads.length() : loads.reaction());
      MeasuredNumber number{set_,
                            step,
                            0,
                            by_force ? pair.force : pair.length,
                            by_force ? length : pair.force,
                            by_force ? shift : 0,
                            pair.sigma.value_or(data.brief.sigma),
                            pair.where};
      goal.target[0] = number.measured;
      out_.numbers.push_back(std::move(number));
      out_.goals.push_back(std::move(goal));
    }
    return {};
  }

  Status operator()(const ShapeData& data) {
    for (const ShapeData::Shape& shape : data.shapes) {
      const std::string& first = shape.places.front().where;
      const Pose& pose = base_.model.poses[static_cast<std::size_t>(shape.pose)];
      const Result<StaticProblem> problem =
          make_static_problem(base_.model, base_.system, pose, fmt::format("/poses/{}", shape.pose));
      if (!problem) return problem.error();
      const int step = add_step(Pose(pose), shape.pose, first);
      std::vector<int>& nodes = out_.steps.back().nodes;
      for (const MeasuredPlace& place : shape.places) nodes.push_back(place.node);
      Goal goal = goal_of(first, out_.steps.back().pose, make_node_positions(nodes));
      for (std::size_t i = 0; i < shape.places.size(); ++i) {
        const MeasuredPlace& place = shape.places[i];
        if (const Status s = check_held(base_, problem.value(), {place.node}, pose.name, place.where); !s) return s;
        for (int axis = 0; axis < 3; ++axis) {
          if (std::isnan(place.place[axis])) continue;
          const int component = 3 * static_cast<int>(i) + axis;
          goal.target[component] = place.place[axis];
          out_.numbers.push_back(
              {set_, step, component, 0, place.place[axis], 0, place.sigma.value_or(data.brief.sigma), place.where});
        }
      }
      out_.goals.push_back(std::move(goal));
    }
    return {};
  }

  void next_set() { ++set_; }

 private:
  /// Number of a new step: a pose after all others, called by the line that it stands for.
  int add_step(Pose pose, int base_pose, const std::string& where) {
    pose.name = fmt::format("{} [{}]", pose.name, where);
    out_.steps.push_back({static_cast<int>(out_.model.poses.size()), base_pose, set_, where, {}, {}});
    out_.model.poses.push_back(std::move(pose));
    return static_cast<int>(out_.steps.size()) - 1;
  }

  const Design& base_;
  CalibrationSteps& out_;
  int set_ = 0;
};

bool measures_force(const MeasurementData& data) {
  const auto* pairs = std::get_if<ForceLengthData>(&data);
  return pairs != nullptr && pairs->brief.prescribed == Prescribed::kLength;
}

const std::string& place_of(const MeasurementData& data) {
  return std::visit([](const auto& set) -> const std::string& { return set.where; }, data);
}

/// One standard deviation for all where none is known.
Status settle_sigmas(const std::vector<MeasurementData>& data, CalibrationSteps& out) {
  const auto unknown = [](const MeasuredNumber& n) { return !(n.sigma > 0); };
  const auto first = std::find_if(out.numbers.begin(), out.numbers.end(), unknown);
  out.sigma_known = first == out.numbers.end();
  if (out.sigma_known) return {};
  const bool alike = std::all_of(out.numbers.begin(), out.numbers.end(), unknown) &&
                     std::all_of(data.begin(), data.end(), [&](const MeasurementData& set) {
                       return measures_force(set) == measures_force(data.front());
                     });
  if (!alike) {
    return Error{ErrorCode::kConflict, place_of(data[static_cast<std::size_t>(first->set)]),
                 "nothing says how far these measurements can be trusted, compared with the others",
                 "give \"sigma\" here, or a column \"sigma [mm]\" in the file"};
  }
  double size = 0;
  for (const MeasuredNumber& number : out.numbers) size = std::max(size, std::abs(number.measured));
  for (MeasuredNumber& number : out.numbers) number.sigma = size > 0 ? kFelt * size : 1;
  return {};
}

}  // namespace

Result<CalibrationSteps> make_calibration_steps(const Design& base, const std::vector<MeasurementData>& data) {
  CalibrationSteps out;
  out.model = base.model;
  out.model.design.reset();
  out.model.calibration.reset();
  StepMaker maker(base, out);
  for (const MeasurementData& set : data) {
    if (const Status s = std::visit(maker, set); !s) return s.error();
    maker.next_set();
  }
  if (const Status s = settle_sigmas(data, out); !s) return s.error();
  for (const MeasuredNumber& number : out.numbers) {
    out.goals[static_cast<std::size_t>(number.step)].weights[number.component] = 1 / (number.sigma * number.sigma);
  }
  return out;
}

}  // namespace lissom
