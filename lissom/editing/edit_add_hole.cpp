#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"at_mm", "place", "mm", false, "A place in it: the hole reaches up to the rods around."},
};

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  const Vec2 at = edit.place("at_mm");
  if (edit.failed()) return edit.error();
  EditOutcome out{model};
  out.model.plan->fabric.holes.push_back(at);
  out.title = "Cut a hole";
  return out;
}

}  // namespace

constinit const EditInfo kEditAddHole = {"add_hole", "Cuts the fabric out between the rods around a place.", kFields,
                                         apply};

}  // namespace lissom
