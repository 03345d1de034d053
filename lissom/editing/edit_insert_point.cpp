#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/plan_tools.h"
#include "lissom/editing/rod_curve.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"rod", "rod", "", false, "On which rod."},
    {"at_mm", "place", "mm", false, "Near which place: the point goes where the rod is nearest."},
    {"r_n_mm", "number", "mm", true, "Radius out of the plane; as the rod has it there."},
    {"r_b_mm", "number", "mm", true, "Radius in the plane; as the rod has it there."},
};

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  const int rod = edit.rod("rod");
  const Vec2 at = edit.place("at_mm");
  const std::optional<double> r_n = edit.optional_length("r_n_mm"), r_b = edit.optional_length("r_b_mm");
  if (edit.failed()) return edit.error();
  EditOutcome out{model};
  Plan& plan = *out.model.plan;
  const OnRod put = point_on_rod(plan, static_cast<std::size_t>(rod), at);
  PlanPoint& point = point_of(plan, put.point);
  if (!put.made) {
    edit.fail(ErrorCode::kConflict, "at_mm", fmt::format("the point \"{}\" is there already", point.name),
              "choose a place further away from it");
    return edit.error();
  }
  point.r_n = r_n.value_or(point.r_n);
  point.r_b = r_b.value_or(point.r_b);
  out.title = "Add a point to " + rods_in_words(plan, {rod});
  return out;
}

}  // namespace

constinit const EditInfo kEditInsertPoint = {
    "insert_point", "Adds a point to a rod, at the place of the rod that is nearest.", kFields, apply};

}  // namespace lissom
