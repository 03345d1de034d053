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

/// At the edge of `left` that starts at its corner `from`; `bend`: modulus, N m; `multiplier`: of it, left and right;
/// `angle`: rad, at rest. The same moment passes through both triangles, one after the other, so their compliances add:
/// the modulus is the harmonic mean by heights above the edge, which are to each other as the areas.
template <class T>
HingeRestT<T> hinge_rest(const TriangleRestT<T>& left, int from, const TriangleRestT<T>& right, const T& bend,
                         const std::array<double, 2>& multiplier, const T& angle) {
  const Eigen::Matrix<T, 2, 1> edge = left.corner[(from + 1) % 3] - left.corner[from];
  return {bend * edge.squaredNorm() / (left.area / T(multiplier[0]) + right.area / T(multiplier[1])), angle};
}

/// Multipliers of the bending modulus on both sides of a hinge.
inline std::array<double, 2> multipliers(const Structure& structure, const StructureHinge& hinge) {
  return {structure.triangles[hinge.triangle[0]].stiffness, structure.triangles[hinge.triangle[1]].stiffness};
}

/// Lame's parameters from Young's modulus (Pa) and Poisson's ratio; volume from the corners.
template <class T>
TetrahedronRestT<T> tetrahedron_rest(const std::array<Eigen::Matrix<T, 3, 1>, 4>& corner, const T& youngs_modulus,
                                     double poisson_ratio) {
  const double nu = poisson_ratio;
  const Eigen::Matrix<T, 3, 1> b = corner[1] - corner[0], c = corner[2] - corner[0], d = corner[3] - corner[0];
  return {corner, youngs_modulus * T(nu / ((1 + nu) * (1 - 2 * nu))), youngs_modulus * T(1 / (2 * (1 + nu))),
          b.cross(c).dot(d) * T(1.0 / 6)};
}

}  // namespace lissom
