#include "lissom/session/branches_json.h"

#include <nlohmann/json.hpp>

#include "lissom/session/layout_json.h"

namespace lissom {

std::string branches_summary(const PoseBranches& found) {
  using Json = nlohmann::ordered_json;
  Json json;
  json["pose"] = found.pose;
  json["solves"] = found.search.solves;
  json["not_settled"] = found.search.not_settled;
  json["exhausted"] = found.search.exhausted;
  json["drawn_shape_negative_modes"] = found.search.drawn_negative;
  Json shapes = Json::array();
  for (size_t k = 0; k < found.search.branches.size(); ++k) {
    const Branch& branch = found.search.branches[k];
    Json shape = {{"energy_J", branch.equilibrium.energy},
                  {"height_m", found.heights[k]},
                  {"lowest_stiffness_N_per_m",
                   branch.equilibrium.modes.empty() ? 0.0 : branch.equilibrium.modes.front().stiffness},
                  {"barrier_free", branch.barrier_free},
                  {"mirror_image_is_stable_too", branch.mirrored},
                  {"found_by", branch.found_by}};
    if (branch.same_energy_as >= 0) shape["alike"] = branch.same_energy_as;
    shapes.push_back(std::move(shape));
  }
  json["shapes"] = std::move(shapes);
  json["files"] = file_list(found.files);
  return json_line(json);
}

}  // namespace lissom
