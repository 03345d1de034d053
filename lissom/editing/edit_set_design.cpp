#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"points", "list", "", false,
     "What becomes of points: [{\"point\": \"a\", \"at_mm\": [x, y], \"r_n_mm\": 0.4, \"r_b_mm\": 0.9}], any of the "
     "last three."},
    {"pre_stretch", "pair", "", true, "Pre-stretch of the fabric along warp and weft."},
    {"title", "text", "", true, "Of the step: where the numbers come from."},
};
constexpr std::string_view kPoint[] = {"point", "at_mm", "r_n_mm", "r_b_mm"};

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  EditOutcome out{model};
  Plan& plan = *out.model.plan;
  std::vector<char> seen(plan.points.size(), 0);
  for (EditReader& part : edit.items("points", 0)) {
    part.only(kPoint);
    const int number = part.point("point");
    if (edit.failed()) return edit.error();
    PlanPoint& point = point_of(plan, number);
    if (seen[static_cast<std::size_t>(number)]++ != 0) {
      part.fail(ErrorCode::kConflict, "point", fmt::format("the point \"{}\" is named twice", point.name),
                "name it once");
    }
    if (part.has("at_mm")) point.at = part.place("at_mm");
    point.r_n = part.optional_length("r_n_mm").value_or(point.r_n);
    point.r_b = part.optional_length("r_b_mm").value_or(point.r_b);
    if (edit.failed()) return edit.error();
  }
  if (edit.has("pre_stretch")) plan.fabric.pre_stretch = edit.pair("pre_stretch");
  out.title = edit.optional_name("title").value_or("Take over a design");
  if (edit.failed()) return edit.error();
  return out;
}

}  // namespace

constinit const EditInfo kEditSetDesign = {
    "set_design", "Sets places, radii and stretch at once: what modes and fits end in.", kFields, apply};

}  // namespace lissom
