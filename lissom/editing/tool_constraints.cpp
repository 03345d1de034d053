#include "lissom/editing/tool_constraints.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <string_view>

#include "lissom/model/json_value.h"

namespace lissom {

namespace {

constexpr std::string_view kPinned = "pinned", kAttached = "attached", kInPlane = "in plane", kSymmetric = "symmetric";
constexpr std::string_view kAxes = "xy";

/// The number in "attached 3"; 0 when the name is of another kind.
int number_in(std::string_view name, std::string_view word) {
  if (!name.starts_with(word) || name.size() < word.size() + 2 || name[word.size()] != ' ') return 0;
  name.remove_prefix(word.size() + 1);
  int number = 0;
  const auto [rest, code] = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool whole = code == std::errc() && rest == name.data() + name.size() && name.front() != '0';
  return whole && number > 0 ? number : 0;
}

/// Names of the points that a selector lists; empty when it says anything else.
std::vector<std::string> listed_points(const Selector& selector) {
  if (selector.kind == Selector::Kind::kPlanPoint) return {selector.name};
  std::vector<std::string> names;
  if (selector.kind != Selector::Kind::kUnion) return names;
  for (const Selector& part : selector.parts) {
    if (part.kind != Selector::Kind::kPlanPoint) return {};
    names.push_back(part.name);
  }
  return names;
}

/// The axis of "symmetric x"; -1 when the name is another.
int axis_in(std::string_view name) {
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    if (name == fmt::format("{} {}", kSymmetric, kAxes[axis])) return static_cast<int>(axis);
  }
  return -1;
}

/// Takes over what a set says; false when it is none of ours.
bool take(const NamedSet& set, ToolConstraints& all) {
  const std::vector<std::string> points = listed_points(set.nodes);
  if (set.name == kPinned && !points.empty()) {
    all.pinned = points;
  } else if (number_in(set.name, kAttached) > 0 && points.size() == 2) {
    all.attached.push_back({points[0], points[1]});
  } else if (number_in(set.name, kInPlane) > 0 && points.size() >= 3) {
    all.in_plane.push_back(points);
  } else if (axis_in(set.name) >= 0 && set.nodes.kind == Selector::Kind::kPoint) {
    if (!all.symmetric) all.symmetric = {axis_in(set.name), set.nodes.point[axis_in(set.name)]};
  } else {
    return false;
  }
  return true;
}

NamedSet set_of(std::string name, std::span<const std::string> points) {
  NamedSet set{std::move(name), {}};
  set.nodes.kind = Selector::Kind::kUnion;
  for (const std::string& point : points) {
    Selector part;
    part.kind = Selector::Kind::kPlanPoint;
    part.name = point;
    set.nodes.parts.push_back(std::move(part));
  }
  return set;
}

std::vector<NamedSet> sets_of(const ToolConstraints& constraints) {
  std::vector<NamedSet> sets;
  if (!constraints.pinned.empty()) sets.push_back(set_of(std::string(kPinned), constraints.pinned));
  for (std::size_t i = 0; i < constraints.attached.size(); ++i) {
    sets.push_back(set_of(fmt::format("{} {}", kAttached, i + 1), constraints.attached[i]));
  }
  for (std::size_t i = 0; i < constraints.in_plane.size(); ++i) {
    sets.push_back(set_of(fmt::format("{} {}", kInPlane, i + 1), constraints.in_plane[i]));
  }
  if (constraints.symmetric) {
    const auto [axis, at] = *constraints.symmetric;
    NamedSet& set = sets.emplace_back();
    set.name = fmt::format("{} {}", kSymmetric, kAxes[static_cast<std::size_t>(axis)]);
    set.nodes.kind = Selector::Kind::kPoint;
    set.nodes.point[axis] = at;
  }
  return sets;
}

}  // namespace

ToolConstraints constraints_of(const Model& model) {
  ToolConstraints all;
  for (const NamedSet& set : model.sets) take(set, all);
  return all;
}

Result<Model> with_constraints(Model model, const ToolConstraints& constraints) {
  ToolConstraints ignored;
  std::erase_if(model.sets, [&](const NamedSet& set) { return take(set, ignored); });
  for (NamedSet& set : sets_of(constraints)) {
    const auto same = [&](const NamedSet& other) { return other.name == set.name; };
    if (std::any_of(model.sets.begin(), model.sets.end(), same)) {
      return Error{
          ErrorCode::kConflict, "/sets/" + pointer_step(set.name),
          fmt::format("the document has a set \"{}\" of its own, which the studio needs for its constraints", set.name),
          "rename that set"};
    }
    model.sets.push_back(std::move(set));
  }
  return model;
}

}  // namespace lissom
