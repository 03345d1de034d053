#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"rods", "rods", "", false, "Which rods."},
    {"role", "choice", "", false, "\"rod\": printed; \"ghost\": only drawn, the fabric keeps its edge there."},
};
constexpr std::string_view kRoles[] = {"rod", "ghost"};

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  const std::vector<int> rods = edit.rods("rods");
  const PlanRole role = edit.choice("role", kRoles) == 0 ? PlanRole::kRod : PlanRole::kGhost;
  if (edit.failed()) return edit.error();
  EditOutcome out{model};
  for (const int r : rods) rod_of(*out.model.plan, r).role = role;
  const std::string what = rods_in_words(*model.plan, rods);
  out.title = role == PlanRole::kRod ? "Print " + what
                                     : fmt::format("Make {} {}", what, rods.size() == 1 ? "a ghost" : "ghosts");
  return out;
}

}  // namespace

constinit const EditInfo kEditSetRole = {"set_role", "Makes rods ghosts, or ghosts rods.", kFields, apply};

}  // namespace lissom
