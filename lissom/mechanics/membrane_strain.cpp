#include "lissom/mechanics/membrane_strain.h"

#include <algorithm>
#include <cmath>

namespace lissom {

namespace {

/// Eigenvalues of a symmetric 2x2 matrix, descending, and the unit vector of the first.
struct Principal {
  double first = 0, second = 0;
  Vec2 direction = Vec2::UnitX();
};

Principal principal(double xx, double yy, double xy) {
  const double mean = (xx + yy) / 2, half = (xx - yy) / 2, radius = std::hypot(half, xy);
  const double angle = radius > 0 ? std::atan2(xy, half) / 2 : 0;
  return {mean + radius, mean - radius, Vec2(std::cos(angle), std::sin(angle))};
}

}  // namespace

std::array<Vec2, 3> rest_corners(const Structure& structure, const StructureTriangle& triangle) {
  std::array<Vec2, 3> corners = triangle.corner;
  for (Vec2& corner : corners) corner = corner.cwiseQuotient(structure.membranes[triangle.membrane].pre_stretch);
  return corners;
}

TriangleStretch triangle_stretch(const Structure& structure, const StructureTriangle& triangle,
                                 const std::vector<Vec3>& positions) {
  const std::array<Vec2, 3> rest = rest_corners(structure, triangle);
  Eigen::Matrix2d sides;
  sides << rest[1] - rest[0], rest[2] - rest[0];
  Eigen::Matrix<double, 3, 2> now;
  const Vec3& origin = positions[triangle.node[0]];
  now << positions[triangle.node[1]] - origin, positions[triangle.node[2]] - origin;
  TriangleStretch stretch;
  stretch.gradient = now * sides.inverse();
  stretch.rest_area = std::abs(sides.determinant()) / 2;
  stretch.area = Vec3(now.col(0)).cross(Vec3(now.col(1))).norm() / 2;
  const Eigen::Matrix2d c = stretch.gradient.transpose() * stretch.gradient;
  stretch.largest = std::sqrt(std::max(0.0, principal(c(0, 0), c(1, 1), c(0, 1)).first));
  // The product of the stretches is the ratio of the areas: more exact than the second eigenvalue when that is small.
  stretch.smallest = stretch.largest > 0 ? stretch.area / stretch.rest_area / stretch.largest : 0;
  return stretch;
}

TriangleTension triangle_tension(const MembraneMaterial& material, const TriangleStretch& stretch) {
  const Eigen::Matrix<double, 3, 2>& f = stretch.gradient;
  const Eigen::Matrix2d e = (f.transpose() * f - Eigen::Matrix2d::Identity()) / 2;
  const double mu = material.poisson_ratio, gamma = 1 / (1 - mu * mu);
  const double y1 = gamma * material.stiffness_1, y2 = gamma * material.stiffness_2;
  const double cross = gamma * mu * std::sqrt(material.stiffness_1 * material.stiffness_2);
  Eigen::Matrix2d s;  // second Piola-Kirchhoff, N/m
  s << y1 * e(0, 0) + cross * e(1, 1), 2 * material.shear() * e(0, 1), 2 * material.shear() * e(0, 1),
      cross * e(0, 0) + y2 * e(1, 1);
  TriangleTension tension;
  tension.energy = (s.cwiseProduct(e)).sum() / 2;
  // F S F^T / J in an orthonormal basis of the plane of the triangle.
  const Vec3 u = f.col(0).normalized();
  const Vec3 v = (f.col(1) - u * u.dot(f.col(1))).normalized();
  Eigen::Matrix2d plane;
  plane << u.dot(f.col(0)), u.dot(f.col(1)), v.dot(f.col(0)), v.dot(f.col(1));
  const double ratio = std::abs(plane.determinant());
  if (!(ratio > 0)) return tension;  // the triangle has no area: no tension is defined
  const Eigen::Matrix2d cauchy = plane * s * plane.transpose() / ratio;
  const Principal p = principal(cauchy(0, 0), cauchy(1, 1), cauchy(0, 1));
  tension.largest = p.first;
  tension.smallest = p.second;
  tension.direction = u * p.direction.x() + v * p.direction.y();
  return tension;
}

}  // namespace lissom
