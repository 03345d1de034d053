#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/plan_tools.h"
#include "lissom/session/solved_remedy.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"pre_stretch_factor", "number", "", false, "Multiplies the pre-stretch of the fabric."},
    {"radius_factor", "number", "", false, "Multiplies all radii of rods."},
};

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  const double stretch = edit.positive("pre_stretch_factor"), radius = edit.positive("radius_factor");
  if (edit.failed()) return edit.error();
  EditOutcome out{remedied(model, stretch, radius)};
  out.title = stretch_title(model.plan->fabric.pre_stretch, out.model.plan->fabric.pre_stretch);
  if (radius > 1) out.title += fmt::format(" and the radii by {:.3g} %", 100 * (radius - 1));
  if (radius < 1) out.title += fmt::format(" and make rods {:.3g} % thinner", 100 * (1 - radius));
  return out;
}

}  // namespace

constinit const EditInfo kEditStrengthen = {
    "strengthen", "Stretches the fabric further and makes rods thicker: the remedy against slack.", kFields, apply};

}  // namespace lissom
