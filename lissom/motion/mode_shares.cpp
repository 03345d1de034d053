#include "lissom/motion/mode_shares.h"

#include <cmath>

namespace lissom {

void measure_shares(const System& system, const State& state, RollInertia roll_inertia, NaturalMode& mode) {
  double torsional = 0, axial = 0;
  Mat3 translation = Mat3::Zero();
  for (int e = 0; e < system.edge_count(); ++e) {
    const StructureEdge& edge = system.structure.edges[e];
    const EdgeRest& rest = system.rest.edges[e];
    for (const int node : {edge.node0, edge.node1}) {
      const Vec3 u = mode.shape.segment<3>(3 * node);
      translation += rest.mass / 2 * u * u.transpose();
      axial += rest.mass / 2 * std::pow(u.dot(state.edges[e].t), 2);
    }
    if (roll_inertia == RollInertia::kLumped) {
      torsional += rest.roll_inertia * std::pow(mode.shape[system.layout.roll(e)], 2);
    }
  }
  const double total = translation.trace() + torsional;
  mode.translation = translation / total;
  mode.axial = axial / total;
  mode.torsional = torsional / total;
  mode.bending = 1 - mode.axial - mode.torsional;
}

double filter_product(const System& system, const State& state, RollInertia roll_inertia, const ModeFilter& filter,
                      const VecX& u, const VecX& v) {
  double product = 0;
  for (int e = 0; e < system.edge_count(); ++e) {
    const StructureEdge& edge = system.structure.edges[e];
    const EdgeRest& rest = system.rest.edges[e];
    const Vec3& t = state.edges[e].t;
    if (filter.kind == ModeKind::kTorsional) {
      const int roll = system.layout.roll(e);
      if (roll_inertia == RollInertia::kLumped) product += rest.roll_inertia * u[roll] * v[roll];
      continue;
    }
    for (const int node : {edge.node0, edge.node1}) {
      const Vec3 a = u.segment<3>(3 * node), b = v.segment<3>(3 * node);
      Vec3 c = a, d = b;
      if (filter.kind == ModeKind::kBending) {
        c -= t * t.dot(a);
        d -= t * t.dot(b);
      } else if (filter.kind == ModeKind::kAxial) {
        c = t * t.dot(a);
        d = t * t.dot(b);
      }
      const double along =
          filter.axis.isZero() ? c.dot(d) : filter.axis.dot(c) * filter.axis.dot(d) / filter.axis.squaredNorm();
      product += rest.mass / 2 * along;
    }
  }
  return product;
}

}  // namespace lissom
