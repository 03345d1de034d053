#include <fmt/format.h>
#include <string>
#include <vector>

#include "lissom/core/nearest_name.h"
#include "lissom/model/discretize_parts.h"
#include "lissom/model/element_map.h"
#include "lissom/model/limits.h"

namespace lissom {

namespace {

std::string solid_place(size_t s) { return fmt::format("/solids/{}", s); }

std::string solid_label(const Model& model, size_t s) {
  const std::string& name = model.solids[s].name;
  return name.empty() ? fmt::format("solid {}", s) : fmt::format("solid \"{}\"", name);
}

Status check_material(const Model& model, size_t s) {
  const Solid& solid = model.solids[s];
  const std::string where = solid_place(s) + "/material";
  if (const Material* material = model.material(solid.material)) return check_solid_material(*material, where);
  std::vector<std::string> names;
  for (const Material& own : model.materials) names.push_back(own.name);
  for (const Material& known : material_library()) names.push_back(known.name);
  return Error{ErrorCode::kUnknown, where,
               fmt::format("{} is of a material \"{}\" that is not known", solid_label(model, s), solid.material),
               suggestion(solid.material, names)};
}

}  // namespace

Status check_solids(const Draft& draft) {
  const Model& model = draft.model;
  size_t nodes = 0;
  for (size_t s = 0; s < model.solids.size(); ++s) {
    if (Status status = check_material(model, s); !status) return status;
    if (Status status = check_solid_mesh(model.solids[s], solid_place(s)); !status) return status;
    nodes += model.solids[s].points.size();
    if (nodes > static_cast<size_t>(kMostNodes)) {
      return Error{ErrorCode::kRange, solid_place(s),
                   fmt::format("the solids would have more than {} points", kMostNodes), "use larger tetrahedra"};
    }
  }
  return {};
}

Status set_solids(Draft& draft) {
  Structure& structure = draft.structure;
  for (size_t s = 0; s < draft.model.solids.size(); ++s) {
    const Solid& solid = draft.model.solids[s];
    StructureSolid& out = structure.solids[s];
    out.first_tetrahedron = static_cast<int>(structure.tetrahedra.size());
    out.tetrahedra = static_cast<int>(solid.tetrahedra.size());
    for (size_t t = 0; t < solid.tetrahedra.size(); ++t) {
      StructureTetrahedron own;
      own.solid = static_cast<int>(s);
      own.stiffness = multiplier(solid.stiffness, t);
      own.density = multiplier(solid.density, t);
      std::array<Vec3, 4> corner;
      for (size_t i = 0; i < 4; ++i) {
        own.node[i] = out.nodes[solid.tetrahedra[t][i]];
        corner[i] = structure.nodes[own.node[i]];
      }
      // Merging moves points, and may make one of two.
      Status status = check_tetrahedron(corner, fmt::format("{}/tetrahedra/{}", solid_place(s), t));
      if (!status) return status;
      structure.tetrahedra.push_back(own);
    }
  }
  return {};
}

}  // namespace lissom
