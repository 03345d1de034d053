#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/people_units.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"material", "text", "", true, "Material of the rods."},
    {"edge_length_mm", "number", "mm", true, "Length that edges of rods should have; 0: from max_turn_deg alone."},
    {"max_turn_deg", "number", "deg", true, "Largest turn of a rod from edge to edge."},
};

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  EditOutcome out{model};
  Plan& plan = *out.model.plan;
  std::vector<std::string> what;
  plan.material = edit.optional_name("material").value_or(plan.material);
  plan.edge_length = edit.optional_length("edge_length_mm").value_or(plan.edge_length);
  plan.max_turn = edit.optional_angle("max_turn_deg").value_or(plan.max_turn);
  if (edit.has("material")) what.push_back(fmt::format("Print the rods in {}", plan.material));
  if (edit.has("edge_length_mm")) what.push_back("Cut rods into edges of " + length_in_words(plan.edge_length));
  if (edit.has("max_turn_deg")) {
    what.push_back(fmt::format("Let edges turn by {:.4g} degrees", degrees_of(plan.max_turn)));
  }
  if (what.empty()) edit.fail(ErrorCode::kType, {}, "nothing of the rods is given", "give a field");
  if (edit.failed()) return edit.error();
  out.title = what.size() == 1 ? what[0] : "Change all rods";
  return out;
}

}  // namespace

constinit const EditInfo kEditSetRods = {"set_rods", "Changes the material and the mesh of all rods.", kFields, apply};

}  // namespace lissom
