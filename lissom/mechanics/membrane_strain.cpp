#include "lissom/mechanics/membrane_strain.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lissom/mechanics/membrane_stretch.h"

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

Eigen::Matrix2d green_strain(const TriangleStretch& stretch) {
  return (stretch.gradient.transpose() * stretch.gradient - Eigen::Matrix2d::Identity()) / 2;
}

/// Second Piola-Kirchhoff tension, N/m.
Eigen::Matrix2d piola_tension(const TriangleRest& rest, const Eigen::Matrix2d& e) {
  const auto c = SheetModuli<double>::of(rest.stiffness_1, rest.stiffness_2, rest.poisson_ratio);
  Eigen::Matrix2d s;
  s << c.c11 * e(0, 0) + c.c12 * e(1, 1), 2 * c.shear * e(0, 1), 2 * c.shear * e(0, 1),
      c.c12 * e(0, 0) + c.c22 * e(1, 1);
  return s;
}

}  // namespace

double stretch_share(const Pose& pose, double load_factor) {
  return pose.stretch_scaling == Scaling::kProportional ? load_factor : 1;
}

TriangleStretch triangle_stretch(const TriangleRest& rest, const std::array<Vec3, 3>& now, const Vec2& pre_stretch,
                                 double stretch_share) {
  const Vec2 growth = pre_stretch.cwiseQuotient(Vec2::Ones() + stretch_share * (pre_stretch - Vec2::Ones()));
  TriangleStretch stretch;
  Eigen::Matrix2d& sides = stretch.rest_sides;
  sides << (rest.corner[1] - rest.corner[0]).cwiseProduct(growth),
      (rest.corner[2] - rest.corner[0]).cwiseProduct(growth);
  Eigen::Matrix<double, 3, 2> moved;
  moved << now[1] - now[0], now[2] - now[0];
  stretch.gradient = moved * sides.inverse();
  stretch.rest_area = std::abs(sides.determinant()) / 2;
  stretch.area = Vec3(moved.col(0)).cross(Vec3(moved.col(1))).norm() / 2;
  const Eigen::Matrix2d c = stretch.gradient.transpose() * stretch.gradient;
  stretch.largest = std::sqrt(std::max(0.0, principal(c(0, 0), c(1, 1), c(0, 1)).first));
  // The product of the stretches is the ratio of the areas: more exact than the second eigenvalue when that is small.
  stretch.smallest = stretch.largest > 0 ? stretch.area / stretch.rest_area / stretch.largest : 0;
  return stretch;
}

std::vector<TriangleStretch> triangle_stretches(const System& system, const State& state, double stretch_share) {
  const Structure& structure = system.structure;
  std::vector<TriangleStretch> stretches;
  stretches.reserve(structure.triangles.size());
  for (size_t t = 0; t < structure.triangles.size(); ++t) {
    const StructureTriangle& triangle = structure.triangles[t];
    std::array<Vec3, 3> now;
    for (int k = 0; k < 3; ++k) now[k] = state.position(triangle.node[k]);
    const Vec2& pre_stretch = structure.membranes[triangle.membrane].pre_stretch;
    stretches.push_back(triangle_stretch(system.rest.triangles[t], now, pre_stretch, stretch_share));
  }
  return stretches;
}

Mat3 cauchy_tension(const TriangleRest& rest, const TriangleStretch& stretch) {
  const Eigen::Matrix2d s = piola_tension(rest, green_strain(stretch));
  return stretch.gradient * s * stretch.gradient.transpose() * (stretch.rest_area / stretch.area);
}

TriangleTension triangle_tension(const TriangleRest& rest, const TriangleStretch& stretch) {
  const Eigen::Matrix<double, 3, 2>& f = stretch.gradient;
  const Eigen::Matrix2d e = green_strain(stretch), s = piola_tension(rest, e);
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
