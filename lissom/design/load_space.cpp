#include "lissom/design/load_space.h"

#include <cmath>
#include <fmt/format.h>
#include <set>
#include <utility>

#include "lissom/design/linear_columns.h"
#include "lissom/mechanics/load_numbers.h"
#include "lissom/mechanics/supports.h"

namespace lissom {

namespace {

struct LoadWords {
  const char* name;
  const char* list;
  ParameterKind kind;
};

LoadWords words_of(LoadKind kind) {
  switch (kind) {
    case LoadKind::kForce:
      return {"force", "forces", ParameterKind::kForce};
    case LoadKind::kMoment:
      return {"moment", "moments", ParameterKind::kMoment};
    case LoadKind::kLineLoad:
      return {"line load", "line_loads", ParameterKind::kForcePerLength};
    case LoadKind::kEdgeLoad:
      return {"edge load", "edge_loads", ParameterKind::kForcePerLength};
    case LoadKind::kGravity:
      return {"gravity", "gravity", ParameterKind::kAcceleration};
    case LoadKind::kPinStiffness:
      return {"stiffness of soft pin", "soft_pins", ParameterKind::kPinStiffness};
    case LoadKind::kPinTarget:
      return {"target of soft pin", "soft_pins", ParameterKind::kPinTarget};
    case LoadKind::kMove:
      break;
  }
  return {"movement of support", "supports", ParameterKind::kMove};
}

/// Where a load is among the numbers of its pose, and what selects its nodes.
struct LoadPlace {
  int count = 0;  ///< of its list
  int first = 0;
  Vec3 value = Vec3::Zero();
  const Selector* at = nullptr;
};

template <class List>
bool has(const List& list, int index) {
  return index >= 0 && index < static_cast<int>(list.size());
}

LoadPlace place_of(const Pose& pose, const LoadNumbers& numbers, const LoadChoice& choice) {
  const int i = choice.index;
  const auto n = static_cast<std::size_t>(i);
  const auto of = [&](const auto& list, int first, const auto& value) -> LoadPlace {
    LoadPlace place{static_cast<int>(list.size()), first, Vec3::Zero(), nullptr};
    if (!has(list, i)) return place;
    place.value = value(list[n]);
    if constexpr (requires { list[n].at; }) place.at = &list[n].at;
    return place;
  };
  switch (choice.kind) {
    case LoadKind::kForce:
      return of(pose.forces, numbers.force(i), [](const PointForce& f) { return f.force; });
    case LoadKind::kMoment:
      return of(pose.moments, numbers.moment(i), [](const PointMoment& m) { return m.moment; });
    case LoadKind::kLineLoad:
      return of(pose.line_loads, numbers.line_load(i), [](const LineLoad& l) { return l.force_per_length; });
    case LoadKind::kEdgeLoad:
      return of(pose.edge_loads, numbers.edge_load(i), [](const EdgeLoad& l) { return l.force_per_length; });
    case LoadKind::kPinStiffness:
      return of(pose.soft_pins, numbers.pin_stiffness(i), [](const SoftPin& p) { return Vec3(p.stiffness, 0, 0); });
    case LoadKind::kPinTarget:
      return of(pose.soft_pins, numbers.pin_target(i),
                [](const SoftPin& p) { return p.target.value_or(Vec3::Zero()); });
    case LoadKind::kMove:
      return of(pose.supports, 3 * i, [](const Support& s) { return s.move; });
    case LoadKind::kGravity:
      break;
  }
  return {pose.gravity ? 1 : 0, numbers.gravity(), pose.gravity ? pose.gravity->acceleration : Vec3(Vec3::Zero()),
          nullptr};
}

Status check_choice(const Model& model, const LoadChoice& choice, const LoadPlace& place) {
  const Pose& pose = model.poses[static_cast<std::size_t>(choice.pose)];
  const std::string where = fmt::format("/poses/{}/{}", choice.pose, words_of(choice.kind).list);
  const int index = choice.kind == LoadKind::kGravity ? 0 : choice.index;
  if (index < 0 || index >= place.count) {
    return Error{ErrorCode::kUnknown, where,
                 fmt::format("pose \"{}\" has no {} number {}", pose.name, words_of(choice.kind).name, index),
                 fmt::format("there are {} in this list", place.count)};
  }
  const auto n = static_cast<std::size_t>(index);
  if (choice.kind == LoadKind::kPinTarget && !pose.soft_pins[n].target) {
    return Error{ErrorCode::kUnsupported, where, "this soft pin pulls towards where its nodes are drawn",
                 "give it a target"};
  }
  if (choice.kind == LoadKind::kMove && pose.supports[n].kind == SupportKind::kSymmetry) {
    return Error{ErrorCode::kUnsupported, where, "a mirror plane does not move", "choose another support"};
  }
  if (choice.kind == LoadKind::kPinStiffness && !(choice.range[0] > 0)) {
    return Error{ErrorCode::kRange, where, fmt::format("the stiffness of a soft pin may be {:g}", choice.range[0]),
                 "give a positive lower bound"};
  }
  const bool size = choice.part == LoadPart::kSize && choice.kind != LoadKind::kPinStiffness;
  if (size && (place.value.isZero() || choice.kind == LoadKind::kPinTarget)) {
    return Error{ErrorCode::kRange, where, fmt::format("a {} of no direction has no size", words_of(choice.kind).name),
                 "choose its x, y or z"};
  }
  return {};
}

}  // namespace

Result<LinearSpace> load_space(std::shared_ptr<const Design> base, const std::vector<LoadChoice>& choices) {
  const Model& model = base->model;
  const Structure& structure = base->system.structure;
  LinearColumns columns;
  std::set<std::tuple<int, bool, int>> taken;  // pose, whether of supports, number
  for (const LoadChoice& choice : choices) {
    if (!has(model.poses, choice.pose)) {
      return Error{ErrorCode::kUnknown, "/poses", fmt::format("there is no pose number {}", choice.pose),
                   "choose one of the poses"};
    }
    const Pose& pose = model.poses[static_cast<std::size_t>(choice.pose)];
    const LoadPlace place = place_of(pose, LoadNumbers(pose, structure), choice);
    if (Status s = check_choice(model, choice, place); !s) return s.error();
    const LoadWords words = words_of(choice.kind);
    const bool number = choice.kind == LoadKind::kPinStiffness, moves = choice.kind == LoadKind::kMove;
    const int axis = number || choice.part == LoadPart::kSize ? -1 : static_cast<int>(choice.part);
    std::string name = fmt::format("pose \"{}\": {}", pose.name, words.name);
    if (choice.kind != LoadKind::kGravity) name += fmt::format(" {}", choice.index);
    if (axis >= 0) name += fmt::format(": {}", "xyz"[axis]);
    Parameter parameter{words.kind, std::move(name), choice.range[0], choice.range[1], 1, {}, axis};
    if (place.at != nullptr && axis >= 0) {
      const Result<std::vector<int>> nodes = select(model, structure, *place.at, "");
      if (nodes && nodes.value().size() == 1) parameter.at = structure.nodes[nodes.value()[0]];
    }
    // What is multiplied by the parameter.
    const Vec3 unit = number ? Vec3(Vec3::UnitX()) : axis >= 0 ? Vec3(Vec3::Unit(axis)) : place.value.normalized();
    columns.add(std::move(parameter), unit.dot(place.value));
    for (int i = 0; i < 3; ++i) {
      if (unit[i] == 0) continue;
      if (!taken.insert({choice.pose, moves, place.first + i}).second) {
        return Error{ErrorCode::kConflict, fmt::format("/poses/{}/{}", choice.pose, words.list),
                     fmt::format("{} {} is chosen in more than one way", words.name, choice.index), "choose it once"};
      }
      if (moves) {
        columns.move(choice.pose, place.first + i, unit[i]);
      } else {
        columns.load(choice.pose, place.first + i, unit[i]);
      }
    }
  }
  for (std::size_t k = 0; k < model.poses.size(); ++k) {
    // Whoever asks for the Jacobian cannot be told that a support is wrong.
    const Result<Supports> supports =
        Supports::make(model, base->system, model.poses[k], fmt::format("/poses/{}", k), NullMotions::kKeep);
    if (!supports) return supports.error();
  }
  return std::move(columns).space(std::move(base));
}

}  // namespace lissom
