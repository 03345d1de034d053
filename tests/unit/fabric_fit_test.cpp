/// Moduli fitted to pulled strips: exact data give them back, what says too little is refused.

#include "lissom/design/fabric_fit.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace lissom {
namespace {

FabricTest pulled(const FabricFit& fabric, const std::vector<double>& angles, const std::vector<double>& forces,
                  double noise = 0) {
  std::mt19937 random(3);
  std::normal_distribution<double> error(0, noise > 0 ? noise : 1);
  FabricTest test{"strips", {}};
  for (const double angle : angles) {
    for (const double force : forces) {
      const StripState s = strip_state(fabric, angle, force);
      const double along = noise > 0 ? error(random) : 0, across = noise > 0 ? error(random) : 0;
      test.pulls.push_back({angle, s.stretch + along, force, s.across + across});
    }
  }
  return test;
}

constexpr double kBias = std::numbers::pi / 4, kWeft = std::numbers::pi / 2;

TEST(FabricFit, StripsHaveTheirClosedForm) {
  const FabricFit fabric{40, 15, 0.25};
  for (const double angle : {0.0, kBias, kWeft, 0.3}) {
    const double stretch = 1.2, force = stretch * (stretch * stretch - 1) / 2 * fabric.modulus(angle);
    EXPECT_NEAR(strip_state(fabric, angle, force).stretch, stretch, 1e-14);
  }
  EXPECT_DOUBLE_EQ(fabric.modulus(0), 40);
  EXPECT_NEAR(fabric.modulus(kWeft), 15, 1e-12);
  // Lateral contraction of a small pull along the warp: mu sqrt(Y1 / Y2).
  const StripState small = strip_state(fabric, 0, 1e-4);
  EXPECT_NEAR((1 - small.across) / (small.stretch - 1), 0.25 * std::sqrt(40.0 / 15), 1e-5);
}

TEST(FabricFit, ExactDataGiveTheModuliBack) {
  int fits = 0;
  for (const FabricFit& fabric : {FabricFit{40, 15, 0.25}, FabricFit{3, 300, -0.3}, FabricFit{0.3, 0.3, 0.48}}) {
    const double y = std::sqrt(fabric.stiffness_1 * fabric.stiffness_2);
    const Result<FabricFit> fit = fit_fabric(pulled(fabric, {0, kBias, kWeft}, {0.05 * y, 0.2 * y}), "/here");
    ASSERT_TRUE(fit) << fit.error().text();
    EXPECT_NEAR(fit.value().stiffness_1 / fabric.stiffness_1, 1, 1e-9);
    EXPECT_NEAR(fit.value().stiffness_2 / fabric.stiffness_2, 1, 1e-9);
    EXPECT_NEAR(fit.value().poisson_ratio, fabric.poisson_ratio, 1e-9);
    EXPECT_LT(fit.value().largest, 1e-12);
    ++fits;
  }
  EXPECT_EQ(fits, 3);
}

TEST(FabricFit, NoiseIsAveraged) {
  const FabricFit fabric{40, 15, 0.25};
  const double noise = 1e-3;
  const Result<FabricFit> fit =
      fit_fabric(pulled(fabric, {0, 0.4, kBias, 1.2, kWeft}, {2, 4, 6, 8, 10, 12}, noise), "/here");
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit.value().stiffness_1, 40, 0.2);
  EXPECT_NEAR(fit.value().stiffness_2, 15, 0.1);
  EXPECT_NEAR(fit.value().poisson_ratio, 0.25, 0.01);
  EXPECT_NEAR(fit.value().rms, noise, 0.3 * noise);
  EXPECT_LT(fit.value().iterations, 20);
}

TEST(FabricFit, SaysWhatThePullsLeaveOpen) {
  const FabricFit fabric{40, 15, 0.25};
  FabricTest blind = pulled(fabric, {0, kBias, kWeft}, {2, 4});
  for (StripPull& pull : blind.pulls) pull.across = 0;
  const Result<FabricFit> without_across = fit_fabric(blind, "/fabric_tests/strips");
  ASSERT_FALSE(without_across);
  EXPECT_NE(without_across.error().message.find("Poisson"), std::string::npos);
  EXPECT_EQ(without_across.error().where, "/fabric_tests/strips");

  const Result<FabricFit> one_direction = fit_fabric(pulled(fabric, {0}, {1e-4, 2e-4}), "/here");
  ASSERT_FALSE(one_direction);
  EXPECT_NE(one_direction.error().hint.find("two directions"), std::string::npos);
}

}  // namespace
}  // namespace lissom
