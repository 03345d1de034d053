#include <algorithm>
#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"points", "points", "", false, "The first stays where it is; the others become it."},
};

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  const std::vector<int> points = edit.points("points", 2);
  if (edit.failed()) return edit.error();
  EditOutcome out{model};
  Plan& plan = *out.model.plan;
  const std::string kept = point_of(plan, points[0]).name;
  for (PlanRod& rod : plan.rods) {
    for (int& i : rod.points) {
      if (std::find(points.begin(), points.end(), i) != points.end()) i = points[0];
    }
  }
  for (const int i : points) {
    if (i != points[0]) out.names.points[point_of(plan, i).name] = kept;
  }
  mend_rods(plan, out.notes);
  out.title = points.size() == 2 ? fmt::format("Merge {} into {}", point_of(*model.plan, points[1]).name, kept)
                                 : fmt::format("Merge {} points into {}", points.size() - 1, kept);
  return out;
}

}  // namespace

constinit const EditInfo kEditMergePoints = {
    "merge_points", "Makes one point of several, so that their rods are joined there.", kFields, apply};

}  // namespace lissom
