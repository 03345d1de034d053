// What rods pass on to each other at joints. The moment at a place is the derivative of its energy by the turn of one
// frame against the other; the force in an edge is its stretching force and the shear that balances the moments at its
// ends (Kirchhoff: m' + t x n = 0).

#include <algorithm>
#include <limits>

#include "lissom/session/field_families.h"
#include "lissom/session/rod_places.h"

namespace lissom {

namespace {

struct EdgeMoments {
  Vec3 start = Vec3::Zero(), end = Vec3::Zero();  // N m, that the part behind exerts on the part before
};

/// Moment that what follows a place exerts on what comes before it, N m.
Vec3 moment_at(const FieldSource& s, const RodPlace& place) {
  const PairStrain strain = strain_at(s.system, s.state, place);
  const Frame frame = s.state.edges[place.edge0 >= 0 ? place.edge0 : place.edge1].material();
  const PairRest& rest = place.rest;
  return (frame.n * (rest.bend_1 * (strain.kappa_1 - rest.kappa_1)) -
          frame.b * (rest.bend_2 * (strain.kappa_2 - rest.kappa_2)) +
          frame.t * (rest.twist_stiffness * (strain.twist - rest.twist))) /
         rest.length;
}

std::vector<double> at_joints(const FieldSource& s) {
  std::vector<double> values(s.system.structure.nodes.size(), std::numeric_limits<double>::quiet_NaN());
  for (const StructureJoint& joint : s.system.structure.joints) values[joint.node] = 0;
  return values;
}

}  // namespace

std::vector<double> joint_moment(const FieldSource& s) {
  std::vector<double> values = at_joints(s);
  for (const RodPlace& place : rod_places(s.system)) {
    if (place.connection >= 0) values[place.node] = std::max(values[place.node], moment_at(s, place).norm());
  }
  return values;
}

std::vector<double> joint_force(const FieldSource& s) {
  const Structure& structure = s.system.structure;
  std::vector<EdgeMoments> moments(structure.edges.size());
  for (const RodPlace& place : rod_places(s.system)) {
    const Vec3 moment = moment_at(s, place);
    if (place.edge0 >= 0) moments[place.edge0].end = moment;
    if (place.edge1 >= 0) moments[place.edge1].start = moment;
  }
  std::vector<double> values = at_joints(s);
  for (int e = 0; e < s.system.edge_count(); ++e) {
    const EdgeState& edge = s.state.edges[e];
    const EdgeRest& rest = s.system.rest.edges[e];
    const Vec3 shear = (moments[e].start - moments[e].end).cross(edge.t) / edge.length;
    const double force = (edge.t * (rest.stretch * (edge.length / rest.length - 1)) + shear).norm();
    for (const int node : {structure.edges[e].node0, structure.edges[e].node1}) {
      if (s.system.joint_of_node[node] >= 0) values[node] = std::max(values[node], force);
    }
  }
  return values;
}

}  // namespace lissom
