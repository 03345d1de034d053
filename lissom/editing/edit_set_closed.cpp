#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"rod", "rod", "", false, "Which rod."},
    {"closed", "flag", "", false, "Whether it returns to its first point."},
};

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  const int rod = edit.rod("rod");
  const bool closed = edit.flag("closed");
  if (edit.failed()) return edit.error();
  EditOutcome out{model};
  rod_of(*out.model.plan, rod).closed = closed;
  mend_rods(*out.model.plan, out.notes);
  if (out.model.plan->rods.size() < model.plan->rods.size()) {
    edit.fail(ErrorCode::kGeometry, "rod", "a closed rod needs three points", "add a point to it first");
    return edit.error();
  }
  out.title = (closed ? "Close " : "Open ") + rods_in_words(*model.plan, {rod});
  return out;
}

}  // namespace

constinit const EditInfo kEditSetClosed = {"set_closed", "Closes a rod to a ring, or opens it.", kFields, apply};

}  // namespace lissom
