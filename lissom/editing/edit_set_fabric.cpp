#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/people_units.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"material", "text", "", true, "Its material."},
    {"warp_angle_deg", "number", "deg", true, "Turn from x to the warp."},
    {"edge_length_mm", "number", "mm", true, "Length of the edges of triangles; 0: that of the rods' edges."},
    {"min_angle_deg", "number", "deg", true, "Smallest angle asked of triangles, at most 30."},
    {"bending", "number", "", true, "Multiplies its stiffness against bending; 0 switches that off."},
};

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  EditOutcome out{model};
  Fabric& fabric = out.model.plan->fabric;
  std::vector<std::string> what;
  const auto note = [&](bool given, std::string text) {
    if (given) what.push_back(std::move(text));
  };
  fabric.material = edit.optional_name("material").value_or(fabric.material);
  fabric.warp_angle = edit.optional_angle("warp_angle_deg").value_or(fabric.warp_angle);
  fabric.edge_length = edit.optional_length("edge_length_mm").value_or(fabric.edge_length);
  fabric.min_angle = edit.optional_angle("min_angle_deg").value_or(fabric.min_angle);
  fabric.bending = edit.optional_number("bending").value_or(fabric.bending);
  note(edit.has("material"), "Take " + fabric.material + " as fabric");
  note(edit.has("warp_angle_deg"), fmt::format("Turn the warp to {:.4g} degrees", degrees_of(fabric.warp_angle)));
  note(edit.has("edge_length_mm"), fabric.edge_length > 0 ? "Mesh the fabric by " + length_in_words(fabric.edge_length)
                                                          : "Mesh the fabric like the rods");
  note(edit.has("min_angle_deg"), fmt::format("Ask for angles of {:.4g} degrees", degrees_of(fabric.min_angle)));
  note(edit.has("bending"), fmt::format("Multiply the bending of the fabric by {:.4g}", fabric.bending));
  if (what.empty()) edit.fail(ErrorCode::kType, {}, "nothing of the fabric is given", "give a field");
  if (edit.failed()) return edit.error();
  out.title = what.size() == 1 ? what[0] : "Change the fabric";
  return out;
}

}  // namespace

constinit const EditInfo kEditSetFabric = {"set_fabric", "Changes material, direction and mesh of the fabric.", kFields,
                                           apply};

}  // namespace lissom
