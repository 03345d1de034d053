#include "lissom/mechanics/membrane_strain.h"

#include <cmath>
#include <gtest/gtest.h>

namespace lissom {
namespace {

constexpr double kS = 1.3;

TriangleRest knit(double y1 = 47.2, double y2 = 47.2) {
  return {.corner = {}, .stiffness_1 = y1, .stiffness_2 = y2, .poisson_ratio = 0.3};
}

/// One triangle drawn in a plane and moved by `map` there, then turned in space.
struct Sheet {
  TriangleRest rest;
  std::array<Vec3, 3> now;
  Vec2 pre_stretch;
};

Sheet sheet(const Vec2& pre_stretch, const Eigen::Matrix2d& map) {
  Sheet s{knit(), {}, pre_stretch};
  const std::array<Vec2, 3> drawn = {Vec2(0.01, 0.02), Vec2(0.05, 0.01), Vec2(0.02, 0.06)};
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  for (int k = 0; k < 3; ++k) {
    s.rest.corner[k] = drawn[k].cwiseQuotient(pre_stretch);
    const Vec2 moved = map * drawn[k];
    s.now[k] = turn * Vec3(moved.x(), moved.y(), 0) + Vec3(0.1, -0.2, 0.3);
  }
  return s;
}

TriangleStretch stretch_of(const Sheet& s) { return triangle_stretch(s.rest, s.now, s.pre_stretch); }

TEST(MembraneStrain, FlatPlanHasItsPreStretchInAllDirections) {
  const TriangleStretch stretch = stretch_of(sheet(Vec2(kS, kS), Eigen::Matrix2d::Identity()));
  EXPECT_NEAR(stretch.largest, kS, 1e-7);  // the square root of a double eigenvalue
  EXPECT_NEAR(stretch.smallest, kS, 1e-7);
  EXPECT_NEAR(stretch.area, kS * kS * stretch.rest_area, 1e-15);
  EXPECT_NEAR(stretch.area, 0.5 * (0.04 * 0.04 + 0.01 * 0.01), 1e-15);
  const TriangleTension tension = triangle_tension(knit(), stretch);
  const double t = 47.2 / (1 - 0.3) * (kS * kS - 1) / 2;  // mathematics 3.1
  EXPECT_NEAR(tension.largest, t, 1e-9 * t);
  EXPECT_NEAR(tension.smallest, t, 1e-9 * t);
  const double e = (kS * kS - 1) / 2;
  EXPECT_NEAR(tension.energy, 47.2 / (1 - 0.3) * e * e, 1e-9);
}

TEST(MembraneStrain, PartOfThePreStretchIsThere) {
  const Sheet s = sheet(Vec2(1.4, 1.2), Eigen::Matrix2d::Identity());
  Pose pose;
  EXPECT_EQ(stretch_share(pose, 0.5), 1);
  pose.stretch_scaling = Scaling::kProportional;
  const TriangleStretch half = triangle_stretch(s.rest, s.now, s.pre_stretch, stretch_share(pose, 0.5));
  EXPECT_NEAR(half.largest, 1.2, 1e-12);
  EXPECT_NEAR(half.smallest, 1.1, 1e-12);
}

TEST(MembraneStrain, StretchesAlongTheAxesAreToldApart) {
  Eigen::Matrix2d map;
  map << 1.5, 0, 0, 0.8;
  const Sheet s = sheet(Vec2(1.2, 1.1), map);
  const TriangleStretch stretch = stretch_of(s);
  EXPECT_NEAR(stretch.largest, 1.5 * 1.2, 1e-12);
  EXPECT_NEAR(stretch.smallest, 0.8 * 1.1, 1e-12);
  // Uniaxial Green strains: S_1 = g (Y_1 E_1 + mu sqrt(Y_1 Y_2) E_2); Cauchy = S_1 l_1 / l_2.
  const double e1 = (1.8 * 1.8 - 1) / 2, e2 = (0.88 * 0.88 - 1) / 2, g = 1 / (1 - 0.09);
  const double s1 = g * (60 * e1 + 0.3 * std::sqrt(60 * 20.0) * e2),
               s2 = g * (0.3 * std::sqrt(60 * 20.0) * e1 + 20 * e2);
  const TriangleTension tension = triangle_tension(knit(60, 20), stretch);
  EXPECT_NEAR(tension.largest, s1 * 1.8 / 0.88, 1e-9);
  EXPECT_NEAR(tension.smallest, s2 * 0.88 / 1.8, 1e-9);
  EXPECT_NEAR(tension.energy, (s1 * e1 + s2 * e2) / 2, 1e-9);
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  EXPECT_NEAR(std::abs(tension.direction.dot(turn.col(0))), 1, 1e-12);
}

TEST(MembraneStrain, SimpleShearHasItsClosedForm) {
  const double gamma = 0.4;
  Eigen::Matrix2d map;
  map << 1, gamma, 0, 1;
  const TriangleStretch stretch = stretch_of(sheet(Vec2(1, 1), map));
  const double largest = std::sqrt(1 + gamma * gamma / 4) + gamma / 2;
  EXPECT_NEAR(stretch.largest, largest, 1e-12);
  EXPECT_NEAR(stretch.smallest, 1 / largest, 1e-12);
  EXPECT_NEAR(stretch.area, stretch.rest_area, 1e-17);
  const double shear = 30 / (2 * 1.3);
  const double e22 = gamma * gamma / 2, e12 = gamma / 2, g = 1 / (1 - 0.09);
  const TriangleTension tension = triangle_tension(knit(30, 30), stretch);
  EXPECT_NEAR(tension.energy, 0.5 * g * 30 * e22 * e22 + 2 * shear * e12 * e12, 1e-12);
  // An isotropic sheet pulls along the principal stretch: tan(2 angle) = 2 / gamma in space.
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  const double angle = std::atan2(2, gamma) / 2;
  EXPECT_NEAR(std::abs(tension.direction.dot(turn * Vec3(std::cos(angle), std::sin(angle), 0))), 1, 1e-12);
}

TEST(MembraneStrain, SlackAndFlatTrianglesStayFinite) {
  const TriangleStretch slack = stretch_of(sheet(Vec2(1.4, 1.4), 0.5 * Eigen::Matrix2d::Identity()));
  EXPECT_NEAR(slack.smallest, 0.7, 1e-7);
  EXPECT_LT(triangle_tension(knit(), slack).largest, 0);
  Eigen::Matrix2d flat;
  flat << 1, 0, 0, 0;  // squeezed into a line
  const TriangleStretch line = stretch_of(sheet(Vec2(1, 1), flat));
  EXPECT_NEAR(line.smallest, 0, 1e-12);
  const TriangleTension tension = triangle_tension(knit(), line);
  EXPECT_TRUE(std::isfinite(tension.largest) && std::isfinite(tension.energy) && tension.direction.allFinite());
  const TriangleStretch point = stretch_of(sheet(Vec2(1, 1), Eigen::Matrix2d::Zero()));
  EXPECT_EQ(point.largest, 0);
  EXPECT_EQ(triangle_tension(knit(), point).largest, 0);
}

}  // namespace
}  // namespace lissom
