#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"points", "points", "", false, "Which points."},
    {"split", "flag", "", false, "Whether rods are cut there: they hold together but may kink."},
};

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  const std::vector<int> points = edit.points("points");
  const bool split = edit.flag("split");
  if (edit.failed()) return edit.error();
  EditOutcome out{model};
  for (const int i : points) point_of(*out.model.plan, i).split = split;
  out.title =
      fmt::format("{} at {}", split ? "Let rods kink" : "Keep rods smooth", points_in_words(*model.plan, points));
  return out;
}

}  // namespace

constinit const EditInfo kEditSetSplit = {
    "set_split", "Cuts rods at points, so that the shape may kink there, or makes them whole.", kFields, apply};

}  // namespace lissom
