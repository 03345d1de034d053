#include <algorithm>
#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"point", "point", "", true, "Which point,"},
    {"rod", "rod", "", true, "or which rod."},
    {"to", "text", "", false, "Its new name."},
};

template <class Named>
void refuse_taken(const std::vector<Named>& list, const std::string& name, const char* what, EditReader& edit) {
  if (std::none_of(list.begin(), list.end(), [&](const Named& one) { return one.name == name; })) return;
  edit.fail(ErrorCode::kConflict, "to", fmt::format("there is a {} named \"{}\" already", what, name),
            "choose another name");
}

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  const bool of_point = edit.has("point");
  if (of_point == edit.has("rod")) edit.fail(ErrorCode::kType, {}, "name a point or a rod, one of both");
  const std::string to = edit.name("to");
  const int number = of_point ? edit.point("point") : edit.rod("rod");
  if (edit.failed()) return edit.error();
  EditOutcome out{model};
  Plan& plan = *out.model.plan;
  std::string& name = of_point ? point_of(plan, number).name : rod_of(plan, number).name;
  out.title = fmt::format("Rename {} {} to {}", of_point ? "point" : "rod", name, to);
  if (name == to) return out;
  if (of_point) {
    refuse_taken(plan.points, to, "point", edit);
    out.names.points[name] = to;
  } else {
    refuse_taken(plan.rods, to, "rod", edit);
    out.names.rods[name] = {to};
  }
  if (edit.failed()) return edit.error();
  name = to;
  return out;
}

}  // namespace

constinit const EditInfo kEditRename = {"rename", "Renames a point or a rod, also where selections name it.", kFields,
                                        apply};

}  // namespace lissom
