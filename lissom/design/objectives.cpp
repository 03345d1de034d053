#include "lissom/design/objectives.h"

namespace lissom {

namespace {

constexpr ObjectiveInfo kObjectives[] = {
    {"node positions", "m", "places of nodes: x, y and z of each"},
    {"distance to a surface", "m", "vector from the nearest point of a surface to each node, or its signed length"},
    {"position of a set", "m", "mean of the places of a set of nodes"},
    {"orientation of a set", "rad",
     "rotation vector of a set of nodes against given places, by the best-fitting rigid motion"},
    {"distance", "m", "distance of the mean places of two sets of nodes, or its part along an axis"},
    {"angle", "rad", "angle between two directions, each from a node to another"},
    {"reaction force", "N", "force of the supports on a set of nodes, along given axes"},
    {"membrane area", "m^2", "area of membranes as they are stretched"},
    {"enclosed volume", "m^3",
     "volume between membranes and caps on their rims; positive on the side away from the normals"},
    {"mass", "kg", "mass of rods and membranes"},
    {"material volume", "m^3", "volume of the material of rods and membranes"},
    {"strain energy", "J", "elastic energy of rods, joints and membranes, without loads"},
    {"smallest stretch", "", "smaller principal stretch of each triangle of membranes; below 1 the fabric is slack"},
    {"rod strain", "",
     "largest equivalent strain of the section at each place where a rod bends, from tension, bending and twist"},
    {"rod bending", "1/m", "curvature vector of rods at each inner node, from second differences of places"},
    {"stability margin", "N/m", "stiffness of the softest mode; 0 where the equilibrium is about to become unstable"},
};

}  // namespace

std::span<const ObjectiveInfo> objectives() { return kObjectives; }

const ObjectiveInfo* find_objective(std::string_view name) {
  for (const ObjectiveInfo& info : kObjectives) {
    if (info.name == name) return &info;
  }
  return nullptr;
}

}  // namespace lissom
