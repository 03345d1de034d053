#pragma once
/// Energy of the strains of a pair of frames [mathematics 1.4; Bergou et al. 2008, 2010; erratum E5]. Written once for
/// doubles, packs and duals.

#include <array>
#include <cmath>
#include <span>

#include "lissom/geometry/frame_strain.h"
#include "lissom/mechanics/rest_state.h"

namespace lissom {

/// Tangent, length and material binormal of an edge whose anchor frame is (anchor_t, anchor_b).
template <class T>
FrameT<T> edge_frame(const Vec3T<T>& edge, const T& theta, const Vec3& anchor_t, const Vec3& anchor_b) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const T length = sqrt(edge.dot(edge));
  const Vec3T<T> t = edge * (T(1) / length);
  const Vec3T<T> reference = transported<T>(anchor_t.cast<T>(), t, anchor_b.cast<T>());
  return {t, Vec3T<T>(reference * cos(theta) + t.cross(reference) * sin(theta))};
}

/// Rest numbers of a bending-twist spring, in this order wherever they are active variables.
enum PairRestIndex { kKappa1, kKappa2, kRestTwist, kBend1, kBend2, kTwistStiffness, kPairLength, kPairRestCount };

/// Rest numbers of a connection: those of a pair, then a rotation vector that turns the rest frame of the edge.
enum { kRestTurn = kPairRestCount, kConnectionRestCount = kPairRestCount + 3 };

inline std::array<double, kPairRestCount> rest_values(const PairRest& r) {
  return {r.kappa_1, r.kappa_2, r.twist, r.bend_1, r.bend_2, r.twist_stiffness, r.length};
}

/// V = (B_1 (kappa_1 - kappabar_1)^2 + B_2 (kappa_2 - kappabar_2)^2 + beta (m - mbar)^2) / (2 l), J.
template <class T>
T bend_twist_energy(const Curvature<T>& k, const T& m, std::span<const T, kPairRestCount> rest) {
  const T d1 = k.kappa_1 - rest[kKappa1], d2 = k.kappa_2 - rest[kKappa2], d3 = m - rest[kRestTwist];
  return (rest[kBend1] * d1 * d1 + rest[kBend2] * d2 * d2 + rest[kTwistStiffness] * d3 * d3) /
         (rest[kPairLength] * T(2));
}

}  // namespace lissom
