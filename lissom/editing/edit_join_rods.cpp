#include <algorithm>
#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"rods", "rods", "", false, "Two rods that end at a common point; the first keeps its name."},
};

/// Turns both such that the first ends where the second begins.
bool line_up(std::vector<int>& a, std::vector<int>& b) {
  if (a.back() != b.front() && a.back() != b.back()) std::reverse(a.begin(), a.end());
  if (a.back() != b.front()) std::reverse(b.begin(), b.end());
  return a.back() == b.front();
}

std::string obstacle(const PlanRod& a, const PlanRod& b) {
  if (a.closed || b.closed) return fmt::format("rod \"{}\" is closed", a.closed ? a.name : b.name);
  if (a.curve != b.curve) return fmt::format("\"{}\" and \"{}\" are drawn as different curves", a.name, b.name);
  if (a.role != b.role)
    return fmt::format("\"{}\" is a ghost, the other is not", a.role == PlanRole::kGhost ? a.name : b.name);
  return {};
}

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  const std::vector<int> rods = edit.rods("rods", 2);
  if (!edit.failed() && rods.size() > 2) {
    edit.fail(ErrorCode::kType, "rods", fmt::format("{} rods are named", rods.size()), "join two at a time");
  }
  if (edit.failed()) return edit.error();
  EditOutcome out{model};
  Plan& plan = *out.model.plan;
  PlanRod& first = rod_of(plan, rods[0]);
  PlanRod second = rod_of(plan, rods[1]);
  if (const std::string why = obstacle(first, second); !why.empty()) {
    edit.fail(ErrorCode::kConflict, "rods", why, "make them alike first");
  } else if (!line_up(first.points, second.points)) {
    edit.fail(ErrorCode::kConflict, "rods",
              fmt::format("\"{}\" and \"{}\" do not end at a common point", first.name, second.name),
              "merge the points where they should meet first");
  }
  if (edit.failed()) return edit.error();
  out.title = fmt::format("Join rods {} and {}", first.name, second.name);
  out.names.rods[second.name] = {first.name};
  first.points.insert(first.points.end(), second.points.begin() + 1, second.points.end());
  drop_rods(plan, {rods[1]});
  mend_rods(plan, out.notes);
  return out;
}

}  // namespace

constinit const EditInfo kEditJoinRods = {"join_rods", "Makes one rod of two that end at a common point.", kFields,
                                          apply};

}  // namespace lissom
