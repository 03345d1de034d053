#include "lissom/design/reshaped.h"

#include "lissom/model/natural_formulas.h"

namespace lissom {

namespace {

using Frames = FrameT<double>;

Frames along(const Frame& from, const Vec3& rates, double length) {
  return advanced<double>({from.t, from.b}, natural_curvature<double>(rates[0], rates[1], length), rates[2] * length);
}

Frame frame_of(const Frames& f) { return {f.t, f.b, f.n()}; }

}  // namespace

void reshape(Structure& structure, int rod, double length_factor, const Vec3& rates) {
  StructureRod& own = structure.rods[rod];
  const bool constant = own.natural_rates.has_value();
  for (StructureJoint& joint : structure.joints) {
    for (JointConnection& connection : joint.connections) {
      const StructureEdge& edge = structure.edges[connection.edge];
      if (edge.rod != rod || !constant) continue;
      // Back to the joint with the present rates, and half an edge away with the new ones.
      const double half = 0.5 * connection.direction * edge.rest_length;
      const Frame at_joint = frame_of(along(connection.rest, *own.natural_rates, -half));
      connection.rest = frame_of(along(at_joint, rates, half * length_factor / own.length_factor));
    }
  }
  for (const int e : own.edges) {
    StructureEdge& edge = structure.edges[e];
    edge.rest_length = length_factor * (edge.rest_length / own.length_factor);
  }
  own.length_factor = length_factor;
  if (!constant) return;
  own.natural_rates = rates;
  const auto between = [&](int a, int b) {
    return 0.5 * (structure.edges[a].rest_length + structure.edges[b].rest_length);
  };
  for (StructurePair& pair : structure.pairs) {
    if (structure.edges[pair.edge0].rod != rod) continue;
    const double length = between(pair.edge0, pair.edge1);
    const Curvature<double> k = natural_curvature<double>(rates[0], rates[1], length);
    pair.rest_kappa_1 = k.kappa_1;
    pair.rest_kappa_2 = k.kappa_2;
    pair.rest_twist = rates[2] * length;
  }
  for (std::size_t i = 1; i < own.edges.size(); ++i) {
    const int before = own.edges[i - 1], edge = own.edges[i];
    structure.edges[edge].rest = frame_of(along(structure.edges[before].rest, rates, between(before, edge)));
  }
}

}  // namespace lissom
