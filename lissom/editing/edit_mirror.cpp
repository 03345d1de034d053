#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/mirrored_plan.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"rods", "rods", "", false, "Which rods."},
    {"axis", "choice", "", false, "The coordinate that changes its sign: \"x\" or \"y\"."},
    {"at_mm", "number", "mm", true, "Where the mirror line crosses that axis (0)."},
};

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  const std::vector<int> rods = edit.rods("rods");
  PlanMirror mirror;
  mirror.axis = static_cast<int>(edit.choice("axis", kAxisWords));
  mirror.at = edit.optional_length("at_mm").value_or(0);
  if (edit.failed()) return edit.error();
  EditOutcome out{model};
  const int added = add_mirror_images(out.model, rods, mirror);
  if (added == 0) {
    edit.fail(ErrorCode::kConflict, "rods", "the mirror images of these rods are there already",
              "choose rods of one side, or another line");
    return edit.error();
  }
  out.title = "Mirror " + rods_in_words(*model.plan, rods);
  return out;
}

}  // namespace

constinit const EditInfo kEditMirror = {
    "mirror", "Adds mirror images of rods; points on the line, and images that are there already, are shared.", kFields,
    apply};

}  // namespace lissom
