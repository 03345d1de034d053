#include "lissom/model/section.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <set>

namespace lissom {
namespace {

constexpr double kPi = std::numbers::pi;
/// E = 2, nu = 0: G = 1, so that stiffnesses are section constants.
const Material kUnit{"unit", 2, 0, 3, 1, ""};

TEST(Section, EllipseFollowsTheErrata) {
  const Section s{SectionShape::kEllipse, 1e-3, 2e-3, 0};
  const Material pla = *find_material("PLA");
  const double area = kPi * 2e-6, e = 3.31e9, g = e / 2.72;
  const SectionStiffness k = section_stiffness(s, pla, TorsionModel::kSaintVenant);
  EXPECT_NEAR(k.stretch, e * area, 1e-9 * e * area);
  EXPECT_NEAR(k.bend_b / (e * area * 4e-6 / 4), 1, 1e-14);  // E5: along b the larger half-axis counts
  EXPECT_NEAR(k.bend_n / (e * area * 1e-6 / 4), 1, 1e-14);
  EXPECT_NEAR(k.twist / (g * area * 4e-12 / 5e-6), 1, 1e-14);
  EXPECT_NEAR(k.mass, 1240 * area, 1e-15);
  EXPECT_NEAR(k.roll_inertia / (1240 * area * 5e-6 / 4), 1, 1e-14);  // E7
  const double polar = section_stiffness(s, pla, TorsionModel::kPolar).twist;
  EXPECT_NEAR(polar / k.twist, 1.5625, 1e-12);  // E6: 1.56 times at aspect 2
  EXPECT_NEAR(polar / (g * area * 5e-6 / 4), 1, 1e-14);
}

TEST(Section, SquareAndStripHaveTheirKnownTorsion) {
  const double side = 2e-3;
  const SectionStiffness square =
      section_stiffness({SectionShape::kRectangle, side / 2, side / 2, 0}, kUnit, TorsionModel::kSaintVenant);
  EXPECT_NEAR(square.twist / std::pow(side, 4), 0.140577, 1e-6);
  EXPECT_NEAR(square.bend_b / 2, std::pow(side, 4) / 12, 1e-20);
  const double thick = 2e-4, wide = 2e-2;
  const Section strip{SectionShape::kRectangle, thick / 2, wide / 2, 0};
  const SectionStiffness k = section_stiffness(strip, kUnit, TorsionModel::kSaintVenant);
  EXPECT_NEAR(k.twist / (wide * std::pow(thick, 3) / 3), 1 - 0.630249 * thick / wide, 1e-6);
  EXPECT_NEAR(k.bend_n / 2 / (wide * std::pow(thick, 3) / 12), 1, 1e-12);
  EXPECT_NEAR(k.bend_b / 2 / (thick * std::pow(wide, 3) / 12), 1, 1e-12);
  const SectionStiffness turned =
      section_stiffness({SectionShape::kRectangle, wide / 2, thick / 2, 0}, kUnit, TorsionModel::kSaintVenant);
  EXPECT_EQ(turned.twist, k.twist);
  EXPECT_NEAR(section_stiffness({SectionShape::kRectangle, 1, 2, 0}, kUnit, TorsionModel::kSaintVenant).twist / (4 * 8),
              0.228682, 1e-6);  // sides 4 and 2
}

TEST(Section, TubeIsRoundInBothTorsionModels) {
  const Section tube{SectionShape::kTube, 0.02, 0.02, 0.003};
  const double i = kPi / 4 * (std::pow(0.02, 4) - std::pow(0.017, 4));
  for (const TorsionModel torsion : {TorsionModel::kSaintVenant, TorsionModel::kPolar}) {
    const SectionStiffness k = section_stiffness(tube, kUnit, torsion);
    EXPECT_NEAR(k.bend_b / 2 / i, 1, 1e-13);
    EXPECT_NEAR(k.bend_n / 2 / i, 1, 1e-13);
    EXPECT_NEAR(k.twist / (2 * i), 1, 1e-13);
    EXPECT_NEAR(k.mass / (3 * kPi * (4e-4 - 2.89e-4)), 1, 1e-13);
  }
}

TEST(Section, ImpossibleOnesAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE((Section{SectionShape::kEllipse, 1e-3, 2e-3, 0}.validate("s").ok()));
  EXPECT_TRUE((Section{SectionShape::kTube, 1e-3, 1e-3, 1e-4}.validate("s").ok()));
  const Section bad[] = {{SectionShape::kEllipse, 0, 1, 0},   {SectionShape::kRectangle, 1, -1, 0},
                         {SectionShape::kEllipse, nan, 1, 0}, {SectionShape::kTube, 1, 2, 0.1},
                         {SectionShape::kTube, 1, 1, 0},      {SectionShape::kTube, 1, 1, 1}};
  for (const Section& section : bad) {
    const Status status = section.validate("/rods/0/section");
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().where, "/rods/0/section");
    EXPECT_FALSE(status.error().hint.empty());
  }
}

TEST(Material, LibraryIsPossibleNamedOnceAndSourced) {
  std::set<std::string> names;
  for (const Material& m : material_library()) {
    EXPECT_TRUE(m.validate(m.name).ok()) << m.name;
    EXPECT_FALSE(m.source.empty()) << m.name;
    EXPECT_TRUE(names.insert(m.name).second) << m.name;
    EXPECT_LT(m.strain_limit, 1) << m.name;
  }
  EXPECT_GE(names.size(), 12u);
  EXPECT_EQ(find_material("PLA")->youngs_modulus, 3.31e9);  // E27
  EXPECT_NEAR(find_material("TPU 92A")->shear_modulus(), 10.81e6, 1e4);
  EXPECT_EQ(find_material("unobtainium"), nullptr);
}

TEST(Material, ImpossibleOnesAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Material bad[] = {{"", 0, 0.3, 1, 1, ""},  {"", -1, 0.3, 1, 1, ""},  {"", nan, 0.3, 1, 1, ""},
                          {"", 1, 0.51, 1, 1, ""}, {"", 1, -1, 1, 1, ""},    {"", 1, nan, 1, 1, ""},
                          {"", 1, 0.3, -1, 1, ""}, {"", 1, 0.3, nan, 1, ""}, {"", 1, 0.3, 1, 0, ""}};
  for (const Material& m : bad) EXPECT_FALSE(m.validate("m").ok());
  EXPECT_TRUE((Material{"", 1, 0.5, 0, 1, ""}.validate("m").ok()));  // incompressible and weightless are possible
}

}  // namespace
}  // namespace lissom
