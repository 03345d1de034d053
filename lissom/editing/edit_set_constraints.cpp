#include <algorithm>
#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/mirrored_plan.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"pinned", "points", "", true, "Points that stay where they are in space."},
    {"attached", "list", "", true, "Pairs of points that keep their distance: [[\"a\", \"b\"], ...]."},
    {"in_plane", "list", "", true,
     "Groups of three points or more that stay in a plane: [[\"a\", \"b\", \"c\"], ...]."},
    {"symmetric", "object", "", true, "{\"axis\": \"x\", \"at_mm\": 0}: mirror images across that line; null: none."},
};
constexpr std::string_view kMirror[] = {"axis", "at_mm"};

std::vector<std::string> names_of(const Plan& plan, const std::vector<int>& points) {
  std::vector<std::string> names;
  for (const int i : points) names.push_back(point_of(plan, i).name);
  return names;
}

std::optional<PlanMirror> read_mirror(EditReader& edit) {
  if (edit.is_null("symmetric")) return std::nullopt;
  EditReader object = edit.object("symmetric");
  object.only(kMirror);
  PlanMirror mirror;
  mirror.axis = static_cast<int>(object.choice("axis", kAxisWords));
  mirror.at = object.optional_length("at_mm").value_or(0);
  return mirror;
}

std::string pin_title(const ToolConstraints& before, const ToolConstraints& after) {
  const auto extra = [](const std::vector<std::string>& of, const std::vector<std::string>& without) {
    std::vector<std::string> names;
    std::copy_if(of.begin(), of.end(), std::back_inserter(names), [&](const std::string& name) {
      return std::find(without.begin(), without.end(), name) == without.end();
    });
    return names;
  };
  const auto words = [](const std::vector<std::string>& names) {
    return names.size() == 1 ? "point " + names[0] : fmt::format("{} points", names.size());
  };
  const std::vector<std::string> pinned = extra(after.pinned, before.pinned),
                                 freed = extra(before.pinned, after.pinned);
  if (freed.empty()) return pinned.empty() ? "Leave the pins as they are" : "Pin " + words(pinned);
  return pinned.empty() ? "Unpin " + words(freed) : "Pin other points";
}

std::string title_of(const EditReader& edit, const ToolConstraints& before, const ToolConstraints& after) {
  const bool pinned = edit.has("pinned"), attached = edit.has("attached"), plane = edit.has("in_plane"),
             mirror = edit.has("symmetric");
  if (int{pinned} + int{attached} + int{plane} + int{mirror} > 1) return "Change what is kept";
  if (pinned) return pin_title(before, after);
  if (attached) return after.attached.size() < before.attached.size() ? "Let attached points go" : "Attach points";
  if (plane)
    return after.in_plane.size() < before.in_plane.size() ? "Let points leave their plane" : "Keep points in a plane";
  if (!after.symmetric) return "Let go of the symmetry";
  return fmt::format("Keep the plan symmetric in {}", kAxisWords[static_cast<std::size_t>(after.symmetric->axis)]);
}

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  const ToolConstraints before = constraints_of(model);
  ToolConstraints after = before;
  const Plan& plan = *model.plan;
  if (edit.has("pinned")) after.pinned = names_of(plan, edit.points("pinned", 0));
  if (edit.has("attached")) {
    after.attached.clear();
    for (const std::vector<int>& pair : edit.point_lists("attached", 2, 2)) {
      if (pair.size() == 2) after.attached.push_back({point_of(plan, pair[0]).name, point_of(plan, pair[1]).name});
    }
  }
  if (edit.has("in_plane")) {
    after.in_plane.clear();
    for (const std::vector<int>& group : edit.point_lists("in_plane", 3, plan.points.size())) {
      after.in_plane.push_back(names_of(plan, group));
    }
  }
  if (edit.has("symmetric")) after.symmetric = read_mirror(edit);
  if (edit.failed()) return edit.error();
  Result<Model> changed = with_constraints(model, after);
  if (!changed) return changed.error();
  EditOutcome out{std::move(changed).value()};
  out.title = title_of(edit, before, after);
  if (after.symmetric && !before.symmetric && pairs_of(plan, *after.symmetric).empty()) {
    out.notes.emplace_back("No point of the plan has a mirror image yet.");
  }
  return out;
}

}  // namespace

constinit const EditInfo kEditSetConstraints = {
    "set_constraints", "Says what the tools keep: pins, attached points, planes, a symmetry.", kFields, apply};

}  // namespace lissom
