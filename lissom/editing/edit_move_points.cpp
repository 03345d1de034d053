#include <algorithm>
#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"moves", "list", "", false, "What goes where: [{\"point\": \"a\", \"to_mm\": [x, y]}]."},
};
constexpr std::string_view kMove[] = {"point", "to_mm"};

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  EditOutcome out{model};
  std::vector<int> moved;
  for (EditReader& move : edit.items("moves")) {
    move.only(kMove);
    const int point = move.point("point");
    const Vec2 to = move.place("to_mm");
    if (edit.failed()) return edit.error();
    if (std::find(moved.begin(), moved.end(), point) != moved.end()) {
      move.fail(ErrorCode::kConflict, "point",
                fmt::format("the point \"{}\" is moved twice", point_of(*model.plan, point).name), "move it once");
      return edit.error();
    }
    moved.push_back(point);
    point_of(*out.model.plan, point).at = to;
  }
  if (edit.failed()) return edit.error();
  out.title = "Move " + points_in_words(*model.plan, moved);
  return out;
}

}  // namespace

constinit const EditInfo kEditMovePoints = {"move_points", "Moves points of the plan to other places.", kFields, apply};

}  // namespace lissom
