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

}  // namespace lissom
