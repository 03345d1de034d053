/// Moduli of rods from measurements: exact ones give them back, scattered ones give intervals that hold the truth as often as
/// they say, and what says nothing is named.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "lissom/design/log_space.h"
#include "lissom/design/stiffness_spaces.h"
#include "tests/regression/calibration_samples.h"

namespace lissom {
namespace {

using samples::bent;
using samples::error_of;
using samples::fitted;
using samples::measured;
using samples::pairs_of;
using samples::pulled_by_force;
using samples::pulled_by_length;
using samples::shown;
using Certainty = ParameterCertainty::State;

constexpr double kArea = std::numbers::pi * 1e-6, kLength = 0.1;  // m^2, m
constexpr double kModulus = 31.7e6;                               // Pa

bool determined(const CalibrationFit& fit, int i = 0) {
  return fit.statistics.parameters[static_cast<std::size_t>(i)].state == Certainty::kDetermined;
}

TEST(Calibration, HookesLawIsFoundFromWeights) {
  std::vector<std::pair<double, double>> rows;
  for (const double force : {5.0, 1.0, 3.0}) rows.emplace_back(force, kLength * (1 + force / (kModulus * kArea)));
  for (const double start : {2e6, 5e9}) {
    const Design base = pulled_by_force(start);
    const CalibrationFit fit = fitted(base, {pairs_of(base, rows)});
    EXPECT_EQ(fit.verdict, DesignVerdict::kConverged) << fit.message;
    EXPECT_NEAR(fit.values[0] / kModulus, 1, 1e-8);
    EXPECT_TRUE(determined(fit));
    EXPECT_EQ(fit.start[0], start);
  }
}

TEST(Calibration, LengthsMayBeChanges) {
  const Design base = pulled_by_force(2e6);
  std::vector<std::pair<double, double>> rows;
  for (const double force : {1.0, 2.0}) rows.emplace_back(force, kLength * force / (kModulus * kArea));
  ForceLengthData data = pairs_of(base, rows);
  data.meaning = ForceLengthData::Length::kChange;
  const CalibrationFit fit = fitted(base, {data});
  EXPECT_NEAR(fit.values[0] / kModulus, 1, 1e-8);
  EXPECT_NEAR(fit.steps.numbers[0].measured, kLength + rows[0].second, 1e-15);
}

TEST(Calibration, IntervalsOfALinearLawAreThoseOfRegressionThroughTheOrigin) {
  const std::vector<double> scatter{0.3, -0.4, 0.1, 0.5, -0.2, -0.1};
  std::vector<std::pair<double, double>> rows;
  VecX x(6), y(6);
  for (int i = 0; i < 6; ++i) {
    const double strain = 0.01 * (i + 1);
    x[i] = kArea * strain;
    y[i] = kModulus * x[i] + scatter[static_cast<std::size_t>(i)];
    rows.emplace_back(y[i], kLength * (1 + strain));
  }
  const Design base = pulled_by_length(5e6);
  const CalibrationFit fit = fitted(base, {pairs_of(base, rows)});
  const double slope = x.dot(y) / x.squaredNorm();
  const double error = std::sqrt((y - slope * x).squaredNorm() / 5 / x.squaredNorm());
  EXPECT_EQ(fit.verdict, DesignVerdict::kConverged) << fit.message;
  EXPECT_NEAR(fit.values[0] / slope, 1, 1e-8);
  EXPECT_EQ(fit.statistics.freedom, 5);
  EXPECT_NEAR(fit.statistics.parameters[0].standard_error / error, 1, 1e-7);
  EXPECT_NEAR(fit.statistics.parameters[0].half_width / (student_quantile(5, 0.95) * error), 1, 1e-7);
}

TEST(Calibration, ABentRodTellsItsModulusWhereverTheSearchBegins) {
  const std::vector<std::pair<double, double>> steps{{0.001, 0}, {0.005, 0}, {0.01, 0}, {0.02, 0}};
  const Design truth = bent(kModulus);
  const VecX tips = shown(truth, {pairs_of(truth, steps)});
  EXPECT_GT(tips[3], 0.03);  // far beyond small deflections
  for (const double start : {5e6, 2e9}) {
    const Design base = bent(start);
    const CalibrationFit fit = fitted(base, {measured(pairs_of(base, steps), tips)});
    EXPECT_EQ(fit.verdict, DesignVerdict::kConverged) << fit.message;
    EXPECT_NEAR(fit.values[0] / kModulus, 1, 1e-6);
    EXPECT_LT(fit.iterations, 20);
  }
}

TEST(Calibration, IntervalsHoldTheTruthAsOftenAsTheySay) {
  const std::vector<std::pair<double, double>> steps{{0.002, 0}, {0.005, 0}, {0.01, 0}, {0.015, 0}, {0.02, 0}};
  const Design truth = bent(kModulus, 4);
  const VecX tips = shown(truth, {pairs_of(truth, steps)});
  const Design base = bent(0.7 * kModulus, 4);
  const ForceLengthData data = pairs_of(base, steps);
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 0.5e-3);
  constexpr int kRounds = 200;
  int held = 0, good = 0;
  double sum = 0, squares = 0, claimed = 0;
  for (int round = 0; round < kRounds; ++round) {
    VecX seen = tips;
    for (double& value : seen) value += noise(random);
    const CalibrationFit fit = fitted(base, {measured(data, seen)});
    good += fit.verdict == DesignVerdict::kConverged && determined(fit);
    const double off = fit.values[0] - kModulus, error = fit.statistics.parameters[0].standard_error;
    held += std::abs(off) <= fit.statistics.parameters[0].half_width;
    sum += off;
    squares += off * off;
    claimed += error * error;
  }
  EXPECT_EQ(good, kRounds);
  const double spread = std::sqrt(0.95 * 0.05 / kRounds);
  EXPECT_NEAR(static_cast<double>(held) / kRounds, 0.95, 3 * spread);
  // The errors that are claimed are those that are made.
  EXPECT_NEAR(std::sqrt(claimed / squares), 1, 0.15);
  EXPECT_LT(std::abs(sum) / kRounds, 3 * std::sqrt(squares) / kRounds);
  RecordProperty("held", held);
}

TEST(Calibration, KnownStandardDeviationsWeighMeasurements) {
  const Design base = pulled_by_force(5e6);
  std::vector<std::pair<double, double>> rows;
  for (const double force : {1.0, 2.0}) rows.emplace_back(force, kLength * (1 + force / (kModulus * kArea)));
  rows[1].second += 2e-3;  // a row that is wrong, and known to be unsure
  ForceLengthData data = pairs_of(base, rows);
  data.pairs[0].sigma = 1e-8;
  data.pairs[1].sigma = 1e-2;
  const CalibrationFit fit = fitted(base, {data});
  EXPECT_TRUE(fit.steps.sigma_known);
  EXPECT_NEAR(fit.values[0] / kModulus, 1, 1e-6);
}

TEST(Calibration, WhatIsHeldByABoundIsSaid) {
  const Design base = pulled_by_force(5e6);
  // Ten times as soft as the softest material that is allowed.
  const std::vector<std::pair<double, double>> rows{{1, kLength * (1 + 1 / (1e5 * kArea))}};
  const CalibrationFit fit = fitted(base, {pairs_of(base, rows)});
  EXPECT_EQ(fit.statistics.parameters[0].state, Certainty::kAtLowerBound);
  EXPECT_EQ(fit.values[0], 1e6);
}

TEST(Calibration, MeasurementsOfNothingDetermineNothing) {
  const Design base = pulled_by_force(5e6);
  const CalibrationFit fit = fitted(base, {pairs_of(base, {{0, kLength}, {0, kLength}})});
  EXPECT_EQ(fit.statistics.parameters[0].state, Certainty::kUndetermined);
  EXPECT_EQ(fit.values[0], 5e6);
}

TEST(Calibration, TheDocumentGetsTheMaterialAndItsSource) {
  const Design base = pulled_by_force(5e6);
  const CalibrationFit fit = fitted(
      base,
      {pairs_of(base, {{1, kLength * (1 + 1 / (kModulus * kArea))}, {2, kLength * (1 + 2 / (kModulus * kArea))}})});
  EXPECT_TRUE(fit.model.validate());
  EXPECT_EQ(fit.model.poses.size(), 1u);
  EXPECT_FALSE(fit.model.calibration.has_value());
  EXPECT_EQ(fit.model.material("print")->youngs_modulus, fit.values[0]);
  EXPECT_EQ(fit.model.material("print")->source, "calibrated from pull.csv");
}

TEST(Calibration, SaysWhatCannotBeMeant) {
  const Design base = pulled_by_force(5e6);
  Design changed = base;
  changed.model.poses[0].forces.clear();
  EXPECT_EQ(error_of(changed, {pairs_of(changed, {{1, 0.1}})}),
            "/calibration/measurements/0/force_length/prescribed: pose \"loaded\" has no force that could be scaled to "
            "those of the file (add one to its \"forces\", of any size, or write \"prescribed\": \"length\")");
  changed = base;
  changed.model.poses[0].forces.push_back({changed.model.sets[1].nodes, Vec3(-1, 0, 0)});
  EXPECT_TRUE(error_of(changed, {pairs_of(changed, {{1, 0.1}})})
                  .starts_with("/poses/0/forces: these forces cancel each other"));
  changed = pulled_by_length(5e6);
  changed.model.poses[0].supports.pop_back();
  EXPECT_TRUE(error_of(changed, {pairs_of(changed, {{1, 0.1}})})
                  .starts_with("/calibration/measurements/0/force_length/to: no support of pose \"loaded\" holds"));
  changed = pulled_by_length(5e6);
  changed.model.poses[0].supports[1].directions = {Vec3::UnitY()};
  EXPECT_TRUE(
      error_of(changed, {pairs_of(changed, {{1, 0.11}})})
          .starts_with("pull.csv:2: the supports of pose \"loaded\" do not bring the ends to a distance of 110 mm"));
  const ForceLengthData one = pairs_of(base, {{1, 0.1}});
  ForceLengthData known = one;
  known.brief.sigma = 1e-4;
  EXPECT_TRUE(error_of(base, {known, one})
                  .starts_with("/calibration/measurements/0: nothing says how far these measurements can be trusted"));
}

TEST(Calibration, StartsOutsideOfTheirBoundsAreNamedWhereTheDocumentHasThem) {
  const Design base = pulled_by_force(0.5e6);
  const std::string error = error_of(base, {pairs_of(base, {{1, 0.1}})});
  EXPECT_TRUE(
      error.starts_with("/calibration/parameters/0: material \"print\": Young's modulus: the present value is outside"))
      << error;
}

TEST(LogSpace, FollowsTheSpaceThatItIsMadeOf) {
  const Design design = bent(5e6);
  const auto base = std::make_shared<const Design>(design);
  Result<LinearSpace> linear = youngs_modulus_space(base, ModulusChoice::kPerMaterial, {1e6, 1e8});
  ASSERT_TRUE(linear);
  Result<LogSpace> made = LogSpace::make(std::make_shared<const LinearSpace>(std::move(linear).value()));
  ASSERT_TRUE(made) << made.error().text();
  const LogSpace& space = made.value();
  EXPECT_NEAR(space.start()[0], std::log(5e6), 1e-15);
  EXPECT_EQ(space.values(VecX::Constant(1, space.parameters()[0].upper))[0], 1e8);
  EXPECT_FALSE(space.at(VecX::Constant(1, std::log(1.1e8))));
  // Derivatives by differences.
  const VecX u = VecX::Constant(1, std::log(2e7)), v = VecX::Constant(1, 1.0);
  const double step = 1e-4;
  const VecX low = u - step * v, high = u + step * v;
  EXPECT_NEAR((space.values(high) - space.values(low))[0] / (2 * step * space.slope(u)[0]), 1, 1e-7);
  const VecX y = VecX::LinSpaced(space.jacobian(design, u).inputs.rows(), 0.5, 1.5);
  const VecX change =
      (space.jacobian(design, high).inputs.transpose() * y - space.jacobian(design, low).inputs.transpose() * y) /
      (2 * step);
  EXPECT_NEAR(space.curvature(design, u, y, v)[0] / change[0], 1, 1e-7);
}

}  // namespace
}  // namespace lissom
