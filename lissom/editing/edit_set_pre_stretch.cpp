#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"along", "pair", "", false, "Stretched length over length at rest, along warp and weft, as in 1.45."},
};

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  const Vec2 along = edit.pair("along");
  if (edit.failed()) return edit.error();
  EditOutcome out{model};
  Vec2& stretch = out.model.plan->fabric.pre_stretch;
  out.title = stretch_title(stretch, along);
  stretch = along;
  return out;
}

}  // namespace

constinit const EditInfo kEditSetPreStretch = {
    "set_pre_stretch", "Sets how far the fabric is stretched when rods are printed on it.", kFields, apply};

}  // namespace lissom
