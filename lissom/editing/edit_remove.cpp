#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"points", "points", "", true, "Points that go; rods run on without them."},
    {"rods", "rods", "", true, "Rods that go, and points that no other rod uses with them."},
};

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  const std::vector<int> points = edit.has("points") ? edit.points("points", 0) : std::vector<int>();
  const std::vector<int> rods = edit.has("rods") ? edit.rods("rods", 0) : std::vector<int>();
  if (points.empty() && rods.empty()) {
    edit.fail(ErrorCode::kType, {}, "nothing is named that could go", "name points or rods");
  }
  if (edit.failed()) return edit.error();
  const Plan& before = *model.plan;
  EditOutcome out{model};
  Plan& plan = *out.model.plan;
  take_out(plan, points);
  drop_rods(plan, rods);
  mend_rods(plan, out.notes);
  if (rods.empty()) out.title = "Remove " + points_in_words(before, points);
  if (points.empty()) out.title = "Remove " + rods_in_words(before, rods);
  if (out.title.empty()) {
    out.title = fmt::format("Remove {} and {}", rods_in_words(before, rods), points_in_words(before, points));
  }
  return out;
}

}  // namespace

constinit const EditInfo kEditRemove = {
    "remove", "Removes points and rods; rods that are left with too few points go too.", kFields, apply};

}  // namespace lissom
