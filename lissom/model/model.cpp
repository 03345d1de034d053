#include "lissom/model/model.h"

namespace lissom {

const Material* Model::material(std::string_view name) const {
  for (const Material& own : materials) {
    if (own.name == name) return &own;
  }
  return find_material(name);
}

const MembraneMaterial* Model::membrane_material(std::string_view wanted) const {
  for (const MembraneMaterial& own : membrane_materials) {
    if (own.name == wanted) return &own;
  }
  return find_membrane_material(wanted);
}

const Pose* Model::pose(std::string_view name) const {
  for (const Pose& candidate : poses) {
    if (candidate.name == name) return &candidate;
  }
  return nullptr;
}

}  // namespace lissom
