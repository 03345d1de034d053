#pragma once
/// Material axes and folds of flat triangles in space, bending of sheets: written once, for doubles and duals.

#include <array>
#include <cmath>
#include <utility>

#include "lissom/geometry/frame_strain.h"

namespace lissom {

/// Material axes 1 and 2 in the plane with unit normal n: axis 1 is the warp direction of the drawing laid into the plane.
template <class T>
std::pair<Vec3T<T>, Vec3T<T>> material_axes(const Vec3T<T>& n, double warp_angle) {
  using std::sqrt;
  const Vec3T<T> warp(T(std::cos(warp_angle)), T(std::sin(warp_angle)), T(0));
  Vec3T<T> axis = warp - n * n.dot(warp);
  if (primal(axis.dot(axis)) < 1e-12) axis = Vec3T<T>(T(0), T(0), T(1)) - n * n[2];
  axis *= T(1) / sqrt(axis.dot(axis));
  return {axis, n.cross(axis)};
}

/// m, corners of a triangle along its material axes.
template <class T>
std::array<Eigen::Matrix<T, 2, 1>, 3> material_corners(const std::array<Vec3T<T>, 3>& x, double warp_angle) {
  using std::sqrt;
  Vec3T<T> normal = Vec3T<T>(x[1] - x[0]).cross(Vec3T<T>(x[2] - x[0]));
  normal *= T(1) / sqrt(normal.dot(normal));
  const auto [axis_1, axis_2] = material_axes(normal, warp_angle);
  std::array<Eigen::Matrix<T, 2, 1>, 3> corner;
  for (std::size_t i = 0; i < 3; ++i) corner[i] = {axis_1.dot(x[i]), axis_2.dot(x[i])};
  return corner;
}

/// rad, angle by which the triangles on the left and right of the edge x0-x1 fold away from their normals
/// [mathematics 3.2].
template <class T>
T fold_angle(const Vec3T<T>& x0, const Vec3T<T>& x1, const Vec3T<T>& left, const Vec3T<T>& right) {
  using std::atan2;
  using std::sqrt;
  const Vec3T<T> e = x1 - x0, normal_left = e.cross(Vec3T<T>(left - x0)), normal_right = Vec3T<T>(right - x0).cross(e);
  const T length = sqrt(e.dot(e));
  return atan2(e.dot(normal_left.cross(normal_right)), length * normal_left.dot(normal_right));
}

/// Bending modulus of a sheet, N m [mathematics 3.2].
template <class T>
T sheet_bend(const T& stiffness_1, const T& stiffness_2, const T& poisson_ratio, const T& thickness) {
  using std::sqrt;
  return sqrt(stiffness_1 * stiffness_2) * thickness * thickness / (T(12) * (T(1) - poisson_ratio * poisson_ratio));
}

}  // namespace lissom
