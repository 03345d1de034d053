#include "lissom/model/model.h"

namespace lissom {

const Material* Model::material(std::string_view name) const {
  for (const Material& own : materials) {
    if (own.name == name) return &own;
  }
  return find_material(name);
}

const Pose* Model::pose(std::string_view name) const {
  for (const Pose& candidate : poses) {
    if (candidate.name == name) return &candidate;
  }
  return nullptr;
}

}  // namespace lissom
