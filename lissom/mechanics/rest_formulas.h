#pragma once
/// How rest numbers follow from shapes and sections: written once, for doubles and duals.

#include "lissom/geometry/frame_strain.h"
#include "lissom/mechanics/rest_state.h"
#include "lissom/model/section.h"

namespace lissom {

template <class T>
EdgeRestT<T> edge_rest(const T& length, const SectionStiffnessT<T>& s) {
  return {length, s.stretch, s.mass * length, s.roll_inertia * length, (s.bend_b + s.bend_n) / s.stretch};
}

/// Between edges of the lengths l0, l1 (m): length-weighted means where the section changes [mathematics 1.4].
template <class T>
PairRestT<T> pair_rest(const Curvature<T>& k, const T& twist, const T& l0, const T& l1, const SectionStiffnessT<T>& s0,
                       const SectionStiffnessT<T>& s1) {
  const T w0 = l0 / (l0 + l1), w1 = T(1) - w0;
  return {k.kappa_1,
          k.kappa_2,
          twist,
          w0 * s0.bend_b + w1 * s1.bend_b,
          w0 * s0.bend_n + w1 * s1.bend_n,
          w0 * s0.twist + w1 * s1.twist,
          (l0 + l1) * T(0.5)};
}

/// Of an edge of this length (m) against its joint, half an edge away (erratum E8).
template <class T>
PairRestT<T> connection_rest(const T& length, const SectionStiffnessT<T>& s) {
  return {T(0), T(0), T(0), s.bend_b, s.bend_n, s.twist, length * T(0.5)};
}

template <class T>
TriangleRestT<T> triangle_rest(const std::array<Eigen::Matrix<T, 2, 1>, 3>& drawn_corner, const T& pre_stretch_1,
                               const T& pre_stretch_2, const T& stiffness_1, const T& stiffness_2,
                               const T& poisson_ratio) {
  TriangleRestT<T> rest{{}, stiffness_1, stiffness_2, poisson_ratio, T(0)};
  for (int i = 0; i < 3; ++i) {
    rest.corner[i] = {drawn_corner[i].x() / pre_stretch_1, drawn_corner[i].y() / pre_stretch_2};
  }
  const Eigen::Matrix<T, 2, 1> u = rest.corner[1] - rest.corner[0], v = rest.corner[2] - rest.corner[0];
  rest.area = T(0.5) * (u.x() * v.y() - u.y() * v.x());
  return rest;
}

/// At the edge of `left` that starts at its corner `from`; `bend`: modulus, N m; `angle`: rad, at rest.
template <class T>
HingeRestT<T> hinge_rest(const TriangleRestT<T>& left, int from, const TriangleRestT<T>& right, const T& bend,
                         const T& angle) {
  const Eigen::Matrix<T, 2, 1> edge = left.corner[(from + 1) % 3] - left.corner[from];
  return {bend * edge.squaredNorm() / (left.area + right.area), angle};
}

}  // namespace lissom
