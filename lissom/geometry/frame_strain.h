#pragma once
/// Strains of a pair of frames: the one place where bending and twist are measured [mathematics 1.3; Bergou et al. 2008,
/// 2010; errata E3, E4]. Written once for doubles, packs and duals.

#include <cmath>
#include <numbers>

#include "lissom/core/dual.h"
#include "lissom/geometry/frame.h"

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

/// The frame that makes these strains with `first`: the inverse of curvature() and twist(). By the negative strains it goes
/// back.
template <class T>
FrameT<T> advanced(const FrameT<T>& first, const Curvature<T>& strain, const T& twist) {
  using std::cos;
  using std::sin;
  // Averaging two normals that differ by the twist shortens them by cos(twist / 2), and turns them half-way.
  const T half = twist * T(0.5), c = cos(half), s = sin(half);
  const Vec3T<T> n0 = first.n();
  const Vec3T<T> b = first.b * c + n0 * s, n = n0 * c - first.b * s;
  const Vec3T<T> kb = (n * strain.kappa_1 - b * strain.kappa_2) * (T(1) / c);
  // The rotation by 2 arctan(|kb| / 2) about kb.
  const T share = T(1) / (T(1) + kb.dot(kb) * T(0.25));
  const auto bent = [&](const Vec3T<T>& x) -> Vec3T<T> {
    const Vec3T<T> once = kb.cross(x), again = kb.cross(once);
    return x + (once + again * T(0.5)) * share;
  };
  const FrameT<T> turned{bent(first.t), bent(first.b)};
  return {turned.t, turned.b * cos(twist) + turned.n() * sin(twist)};
}

}  // namespace lissom
