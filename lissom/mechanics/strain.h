#pragma once
/// Strains of a pair of frames and their energy: the one place where bending and twist are defined [mathematics 1.3, 1.4;
/// Bergou et al. 2008, 2010; errata E3 to E5]. Written once for doubles, packs and duals.

#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "lissom/core/dual.h"
#include "lissom/core/types.h"
#include "lissom/mechanics/rest_state.h"

namespace lissom {

template <class T>
using Vec3T = Eigen::Matrix<T, 3, 1>;

/// Material frame; n = t x b is not stored.
template <class T>
struct FrameT {
  Vec3T<T> t, b;
  Vec3T<T> n() const { return t.cross(b); }
};

/// x carried from unit vector a to unit vector b by the minimal rotation [mathematics 1.1, erratum E1].
template <class T>
Vec3T<T> transported(const Vec3T<T>& a, const Vec3T<T>& b, const Vec3T<T>& x) {
  const T c = a.dot(b);
  const Vec3T<T> s = a.cross(b);
  const T along = s.dot(x) / (T(1) + c);
  const Vec3T<T> turned = s.cross(x);
  return Vec3T<T>(x * c + turned + s * along);
}

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

/// Integrated curvatures: kappa_1 in the t-b plane, kappa_2 in the t-n plane.
template <class T>
struct Curvature {
  T kappa_1, kappa_2;
};
template <class T>
Curvature<T> curvature(const FrameT<T>& first, const FrameT<T>& second) {
  const Vec3T<T> binormal = first.t.cross(second.t) * (T(2) / (T(1) + first.t.dot(second.t)));
  const Vec3T<T> n = first.n() + second.n();
  const Vec3T<T> b = first.b + second.b;
  return {binormal.dot(n) * T(0.5), binormal.dot(b) * T(-0.5)};
}

/// Twist from the first frame to the second: the branch next to `near`.
template <class T>
T twist(const FrameT<T>& first, const FrameT<T>& second, double near) {
  using std::atan2;
  const Vec3T<T> carried = transported<T>(first.t, second.t, first.b);
  const Vec3T<T> across = carried.cross(second.b);
  const T angle = atan2(second.t.dot(across), carried.dot(second.b));
  const double turns = std::round((near - primal(angle)) / (2 * std::numbers::pi));
  return angle + T(2 * std::numbers::pi * turns);
}

/// Rest numbers of a bending-twist spring, in this order wherever they are active variables.
enum PairRestIndex { kKappa1, kKappa2, kRestTwist, kBend1, kBend2, kTwistStiffness, kPairLength, kPairRestCount };

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
