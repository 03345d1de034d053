#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"rods", "rods", "", false, "Which rods."},
    {"curve", "choice", "", false, "\"spline\", \"straight\" or \"arc\" (through three points each)."},
};
constexpr std::string_view kCurves[] = {"spline", "straight", "arc"};
constexpr PlanCurve kKinds[] = {PlanCurve::kSpline, PlanCurve::kStraight, PlanCurve::kArc};
constexpr const char* kTitles[] = {"Draw {} as a smooth line", "Draw {} straight", "Draw {} as arcs"};

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  const std::vector<int> rods = edit.rods("rods");
  const std::size_t curve = edit.choice("curve", kCurves);
  if (edit.failed()) return edit.error();
  EditOutcome out{model};
  for (const int r : rods) rod_of(*out.model.plan, r).curve = kKinds[curve];
  out.title = fmt::format(fmt::runtime(kTitles[curve]), rods_in_words(*model.plan, rods));
  return out;
}

}  // namespace

constinit const EditInfo kEditSetCurve = {"set_curve", "Draws rods as splines, straight pieces or arcs.", kFields,
                                          apply};

}  // namespace lissom
