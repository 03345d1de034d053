/// What is said about parameters of least squares: the closed forms of a straight line, tables of Student's t, and parameters
/// that the data do not determine.

#include "lissom/design/fit_statistics.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace lissom {
namespace {

using Certainty = ParameterCertainty::State;

std::vector<FittedParameter> free_parameters(int count, double reach = 1e6) {
  return std::vector<FittedParameter>(static_cast<std::size_t>(count), {FittedParameter::Bound::kNone, reach});
}

/// y = a + b x, with residuals (a + b x - y).
struct Line {
  VecX x, y;
  MatX jacobian;
  Vec2 ab;
  VecX residual;

  Line() {
    x.resize(6), y.resize(6);
    x << 1, 2, 3, 4, 5, 7;
    y << 2.1, 3.9, 6.2, 7.8, 10.1, 13.7;
    jacobian.resize(6, 2);
    jacobian << VecX::Ones(6), x;
    ab = (jacobian.transpose() * jacobian).ldlt().solve(jacobian.transpose() * y);
    residual = jacobian * ab - y;
  }
};

TEST(FitStatistics, StudentsQuantilesAreThoseOfTables) {
  EXPECT_NEAR(student_quantile(1, 0.95), 12.7062, 5e-5);
  EXPECT_NEAR(student_quantile(4, 0.95), 2.77645, 5e-6);
  EXPECT_NEAR(student_quantile(10, 0.99), 3.16927, 5e-6);
  EXPECT_NEAR(student_quantile(30, 0.90), 1.69726, 5e-6);
}

TEST(FitStatistics, AStraightLineHasItsClosedForm) {
  const Line line;
  const FitStatistics s = fit_statistics(line.jacobian, line.residual, free_parameters(2), 0.95);
  const double mean = line.x.mean(), spread = (line.x.array() - mean).square().sum();
  const double deviation = std::sqrt(line.residual.squaredNorm() / 4);
  EXPECT_EQ(s.freedom, 4);
  EXPECT_NEAR(s.deviation, deviation, 1e-14);
  EXPECT_NEAR(s.parameters[0].standard_error, deviation * std::sqrt(1.0 / 6 + mean * mean / spread), 1e-13);
  EXPECT_NEAR(s.parameters[1].standard_error, deviation / std::sqrt(spread), 1e-13);
  EXPECT_NEAR(s.parameters[1].half_width, 2.7764451 * deviation / std::sqrt(spread), 1e-8);
  EXPECT_NEAR(s.correlation(0, 1), -mean / std::sqrt(line.x.squaredNorm() / 6), 1e-13);
  EXPECT_EQ(s.correlation(0, 0), 1);
}

TEST(FitStatistics, UnitsOfParametersDoNotMatter) {
  const Line line;
  const Vec2 units(1e9, 1e-6);
  const FitStatistics plain = fit_statistics(line.jacobian, line.residual, free_parameters(2), 0.95);
  std::vector<FittedParameter> parameters = free_parameters(2);
  parameters[0].reach *= units[0];
  parameters[1].reach *= units[1];
  const FitStatistics scaled =
      fit_statistics(line.jacobian * units.cwiseInverse().asDiagonal(), line.residual, parameters, 0.95);
  for (int i = 0; i < 2; ++i) {
    const auto k = static_cast<std::size_t>(i);
    EXPECT_NEAR(scaled.parameters[k].standard_error / (units[i] * plain.parameters[k].standard_error), 1, 1e-12);
  }
}

TEST(FitStatistics, AParameterWithoutEffectIsNamedAndTheOthersKeepTheirIntervals) {
  const Line line;
  const FitStatistics plain = fit_statistics(line.jacobian, line.residual, free_parameters(2), 0.95);
  MatX wide(6, 3);
  wide << line.jacobian.col(0), 1e-12 * line.x, line.jacobian.col(1);
  const FitStatistics s = fit_statistics(wide, line.residual, free_parameters(3), 0.95);
  EXPECT_EQ(s.parameters[1].state, Certainty::kUndetermined);
  EXPECT_TRUE(std::isnan(s.parameters[1].standard_error));
  EXPECT_TRUE(std::isnan(s.correlation(0, 1)));
  EXPECT_EQ(s.freedom, 4);
  EXPECT_NEAR(s.parameters[2].half_width, plain.parameters[1].half_width, 1e-13);
}

TEST(FitStatistics, ParametersThatOnlyActTogetherAreNamedTogether) {
  const Line line;
  MatX twice(6, 4);
  twice << line.x, line.jacobian.col(0), 3 * line.x, line.x.array().square().matrix();
  const FitStatistics s = fit_statistics(twice, line.residual, free_parameters(4), 0.95);
  EXPECT_EQ(s.rank, 3);
  EXPECT_EQ(s.freedom, 3);
  ASSERT_EQ(s.combinations.size(), 1u);
  EXPECT_EQ(s.combinations[0], (std::vector<int>{0, 2}));
  EXPECT_EQ(s.parameters[0].state, Certainty::kUndetermined);
  EXPECT_EQ(s.parameters[2].state, Certainty::kUndetermined);
  // The others are as certain as with one of the two.
  const FitStatistics once = fit_statistics(twice.rightCols(3), line.residual, free_parameters(3), 0.95);
  EXPECT_EQ(s.parameters[1].state, Certainty::kDetermined);
  EXPECT_NEAR(s.parameters[1].half_width, once.parameters[0].half_width, 1e-10);
  EXPECT_NEAR(s.parameters[3].half_width, once.parameters[2].half_width, 1e-10);
}

TEST(FitStatistics, ABoundIsNoUnknown) {
  const Line line;
  std::vector<FittedParameter> parameters = free_parameters(2);
  parameters[0].bound = FittedParameter::Bound::kUpper;
  const FitStatistics s = fit_statistics(line.jacobian, line.residual, parameters, 0.95);
  EXPECT_EQ(s.parameters[0].state, Certainty::kAtUpperBound);
  EXPECT_EQ(s.freedom, 5);
  EXPECT_NEAR(s.parameters[1].standard_error, s.deviation / line.x.norm(), 1e-14);
  parameters[1].bound = FittedParameter::Bound::kLower;
  const FitStatistics none = fit_statistics(line.jacobian, line.residual, parameters, 0.95);
  EXPECT_EQ(none.parameters[1].state, Certainty::kAtLowerBound);
  EXPECT_EQ(none.freedom, 6);
}

TEST(FitStatistics, WhatIsWiderThanItsReachIsUncertain) {
  const Line line;
  const FitStatistics s = fit_statistics(line.jacobian, line.residual, free_parameters(2, 0.15), 0.95);
  EXPECT_EQ(s.parameters[0].state, Certainty::kUncertain);
  EXPECT_EQ(s.parameters[1].state, Certainty::kDetermined);
}

TEST(FitStatistics, WithoutFreedomThereAreNoIntervals) {
  const Line line;
  const FitStatistics s = fit_statistics(line.jacobian.topRows(2), VecX::Zero(2), free_parameters(2), 0.95);
  EXPECT_EQ(s.freedom, 0);
  EXPECT_EQ(s.parameters[0].state, Certainty::kDetermined);
  EXPECT_TRUE(std::isnan(s.parameters[0].half_width));
}

TEST(FitStatistics, IntervalsHoldTheTruthAsOftenAsTheySay) {
  const Line line;
  const Vec2 truth(0.3, 1.9);
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0, 0.2);
  constexpr int kRounds = 4000;
  int held = 0;
  for (int round = 0; round < kRounds; ++round) {
    VecX y = line.jacobian * truth;
    for (double& value : y) value += noise(random);
    const Vec2 ab = (line.jacobian.transpose() * line.jacobian).ldlt().solve(line.jacobian.transpose() * y);
    const FitStatistics s = fit_statistics(line.jacobian, line.jacobian * ab - y, free_parameters(2), 0.9);
    held += std::abs(ab[1] - truth[1]) <= s.parameters[1].half_width;
  }
  EXPECT_NEAR(static_cast<double>(held) / kRounds, 0.9, 4 * std::sqrt(0.9 * 0.1 / kRounds));
}

}  // namespace
}  // namespace lissom
