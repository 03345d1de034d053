#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"hole", "number", "", false, "Which of the holes, from 0."},
};

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  const int hole = edit.whole("hole");
  const std::size_t count = model.plan->fabric.holes.size();
  if (!edit.failed() && (hole < 0 || static_cast<std::size_t>(hole) >= count)) {
    edit.fail(ErrorCode::kUnknown, "hole", fmt::format("there is no hole number {}", hole),
              count == 0 ? "the fabric has no holes" : fmt::format("there are {}, the first is number 0", count));
  }
  if (edit.failed()) return edit.error();
  EditOutcome out{model};
  std::vector<Vec2>& holes = out.model.plan->fabric.holes;
  holes.erase(holes.begin() + hole);
  out.title = "Fill a hole";
  return out;
}

}  // namespace

constinit const EditInfo kEditRemoveHole = {"remove_hole", "Fills a hole of the fabric.", kFields, apply};

}  // namespace lissom
