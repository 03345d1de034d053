#pragma once
/// Structures and their shapes as packs: what the page draws (docs/studio/protocol.md, "Packs").

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lissom/mechanics/state.h"
#include "lissom/model/expand_plan.h"
#include "lissom/session/fields.h"

namespace lissom {

using Pack = std::shared_ptr<const std::string>;

/// Where the parts of a plan are in the structure that it was made into.
struct PlanParts {
  std::vector<std::vector<int>> ghosts;  ///< nodes of each ghost rod, the first again at the end of closed ones
  std::vector<int> point_nodes;          ///< of each control point
  std::vector<int> plan_rods;            ///< of each rod of the structure: that of the plan; -1: of none
};
PlanParts plan_parts(const Plan& plan, const ExpandedPlan& expanded, const System& system);
/// Of a structure that was not drawn as a plan.
PlanParts no_plan_parts(const System& system);

/// Which values shapes carry, by their names in field_list(); empty: none.
struct ShownFields {
  std::string rods = "axial strain", fabric = "smallest stretch";
};
/// Refuses what is no field of edges, or of triangles.
Status check_fields(const ShownFields& fields);

/// `header` goes into the header of the pack.
Pack topology_pack(nlohmann::json header, const System& system, const PlanParts& parts);
Pack shape_pack(nlohmann::json header, const FieldSource& source, const ShownFields& fields);
/// Places and normals alone, under the name of `header["pack"]`; `target`: (nodes x 4) wanted place and weight, or empty.
Pack places_pack(nlohmann::json header, const System& system, const State& state, std::span<const float> target);
/// Several shapes by their nodes; each (3 nodes), m.
Pack shapes_pack(nlohmann::json header, const char* name, std::span<const VecX> shapes);

}  // namespace lissom
