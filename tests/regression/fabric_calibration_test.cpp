/// Moduli of fabrics from strips and from shapes: pulls have a closed form, which needs no discretised structure.

#include <cmath>
#include <numbers>

#include "lissom/design/fabric_fit.h"
#include "tests/regression/calibration_samples.h"

namespace lissom {
namespace {

using samples::base_of;
using samples::fitted;
using samples::pairs_of;
using Certainty = ParameterCertainty::State;

constexpr double kLong = 0.1, kWide = 0.03;  // m, of the strips

/// Two strips side by side, cut along the warp and across it, each pulled by its right edge; free to narrow.
std::string strips(const FabricFit& fabric, const std::string& more = "") {
  return fmt::format(R"({{"lissom": 1,
    "membrane_materials": {{"jersey": {{"stiffness": ["{} N/m", "{} N/m"], "poisson_ratio": {}}}}},
    "membranes": [
      {{"name": "warp", "grid": {{"size": [100, 30], "cells": [4, 2]}}, "material": "jersey"}},
      {{"name": "weft", "grid": {{"corner": [0, 100], "size": [100, 30], "cells": [4, 2]}}, "material": "jersey",
        "warp_angle": "90 deg"}}],
    "sets": {{"left": {{"box": [[0, 0, 0], [0, 30, 0]]}}, "right": {{"box": [[100, 0, 0], [100, 30, 0]]}},
              "corner": {{"point": [0, 0, 0]}}, "side": {{"point": [50, 30, 0]}},
              "weft left": {{"box": [[0, 100, 0], [0, 130, 0]]}}, "weft right": {{"box": [[100, 100, 0], [100, 130, 0]]}},
              "weft corner": {{"point": [0, 100, 0]}}}},
    "poses": [{{"name": "pulled", "supports": [
      {{"at": "left", "hold": ["x", "z"]}}, {{"at": "right", "hold": ["x", "z"]}}, {{"at": "corner", "hold": "pin"}},
      {{"at": "weft left", "hold": ["x", "z"]}}, {{"at": "weft right", "hold": ["x", "z"]}},
      {{"at": "weft corner", "hold": "pin"}},
      {{"at": {{"box": [[1, 0, 0], [99, 130, 0]]}}, "hold": ["z"]}}]}}],
    "calibration": {{
      "parameters": [{{"fabric": {{"stiffness_1": ["1 N/m", "1000 N/m"], "stiffness_2": ["1 N/m", "1000 N/m"],
                                   "poisson_ratio": [-0.5, 0.8]}}}}],
      "measurements": [
        {{"force_length": {{"file": "warp.csv", "from": "left", "to": "right", "prescribed": "length"}}}},
        {{"force_length": {{"file": "weft.csv", "from": "weft left", "to": "weft right", "prescribed": "length"}}}}{}]}}}})",
                     fabric.stiffness_1, fabric.stiffness_2, fabric.poisson_ratio, more);
}

/// By the closed form, of a strip cut at this angle (rad) to the warp.
std::vector<std::pair<double, double>> pulls(const FabricFit& fabric, double angle, const std::vector<double>& forces) {
  std::vector<std::pair<double, double>> rows;
  for (const double force : forces) {
    rows.emplace_back(force * kWide, kLong * strip_state(fabric, angle, force).stretch);
  }
  return rows;
}

const FabricFit kTruth{40, 15, 0.25};
const FabricFit kStart{20, 20, 0.1};
constexpr double kWeft = std::numbers::pi / 2;

TEST(FabricCalibration, StripsGiveTheirModuliAndSayThatTheyKnowNothingOfTheContraction) {
  const Design base = base_of(strips(kStart));
  const CalibrationFit fit = fitted(
      base, {pairs_of(base, pulls(kTruth, 0, {2, 5, 10}), 0), pairs_of(base, pulls(kTruth, kWeft, {1, 2, 4}), 1)});
  EXPECT_EQ(fit.verdict, DesignVerdict::kConverged) << fit.message;
  ASSERT_EQ(fit.values.size(), 3);
  EXPECT_NEAR(fit.values[0] / kTruth.stiffness_1, 1, 1e-7);
  EXPECT_NEAR(fit.values[1] / kTruth.stiffness_2, 1, 1e-7);
  EXPECT_EQ(fit.statistics.parameters[0].state, Certainty::kDetermined);
  EXPECT_EQ(fit.statistics.parameters[1].state, Certainty::kDetermined);
  EXPECT_EQ(fit.statistics.parameters[2].state, Certainty::kUndetermined);
  EXPECT_EQ(fit.parameters[2].name, "fabric \"jersey\": Poisson's ratio");
  EXPECT_NEAR(fit.statistics.correlation(0, 1), 0, 1e-5);  // each strip tells of one of them alone
}

TEST(FabricCalibration, AMeasuredSideGivesTheContraction) {
  const Design base = base_of(strips(kStart, R"(, {"shapes": {"file": "side.csv", "sigma": "0.1 mm"}})"));
  ForceLengthData warp = pairs_of(base, pulls(kTruth, 0, {2, 5, 10}), 0);
  ForceLengthData weft = pairs_of(base, pulls(kTruth, kWeft, {1, 2, 4}), 1);
  warp.brief.sigma = weft.brief.sigma = 1e-3;
  // The same strip in the pose as it is described, with its right edge moved by 20 mm.
  Design moved = base;
  moved.model.poses[0].supports[1].move = Vec3(0.02, 0, 0);
  const double stretch = 1.2, force = stretch * (stretch * stretch - 1) / 2 * kTruth.stiffness_1;
  ShapeData side;
  side.brief = std::get<ShapesBrief>(base.model.calibration->measurements[2]);
  side.where = "/calibration/measurements/2";
  const Result<std::vector<int>> node =
      select(base.model, base.system.structure, base.model.sets[3].nodes, "/sets/side");
  ASSERT_TRUE(node) << node.error().text();
  const double nan = std::nan("");
  side.shapes = {
      {0, {{node.value()[0], Vec3(nan, kWide * strip_state(kTruth, 0, force).across, nan), {}, "side.csv:2"}}}};
  const CalibrationFit fit = fitted(moved, {warp, weft, side});
  EXPECT_EQ(fit.verdict, DesignVerdict::kConverged) << fit.message;
  EXPECT_EQ(fit.statistics.residuals, 7);
  EXPECT_NEAR(fit.values[0] / kTruth.stiffness_1, 1, 1e-6);
  EXPECT_NEAR(fit.values[1] / kTruth.stiffness_2, 1, 1e-6);
  EXPECT_NEAR(fit.values[2], kTruth.poisson_ratio, 1e-6);
  for (const ParameterCertainty& p : fit.statistics.parameters) EXPECT_EQ(p.state, Certainty::kDetermined);
}

TEST(FabricCalibration, AgreesWithTheFitOfStrips) {
  FabricTest test{"jersey", {}};
  for (const auto& [angle, forces] : {std::pair<double, std::vector<double>>{0, {2, 5, 10}}, {kWeft, {1, 2, 4}}}) {
    for (const double force : forces) {
      const StripState s = strip_state(kTruth, angle, force);
      test.pulls.push_back({angle, s.stretch, force, s.across});
    }
  }
  const Result<FabricFit> closed = fit_fabric(test, "/fabric_tests/jersey");
  ASSERT_TRUE(closed);
  const Design base = base_of(strips(kStart));
  const CalibrationFit fit = fitted(
      base, {pairs_of(base, pulls(kTruth, 0, {2, 5, 10}), 0), pairs_of(base, pulls(kTruth, kWeft, {1, 2, 4}), 1)});
  EXPECT_NEAR(fit.values[0] / closed.value().stiffness_1, 1, 1e-7);
  EXPECT_NEAR(fit.values[1] / closed.value().stiffness_2, 1, 1e-7);
}

TEST(FabricCalibration, AStepWithoutAStableShapeIsNamedByItsLine) {
  Design base = base_of(strips(kStart));
  base.model.poses[0].supports.pop_back();  // slack fabric may go out of its plane at no cost
  const std::string error = samples::error_of(base, {pairs_of(base, pulls(kTruth, 0, {0.5, 1, 2}), 0)});
  EXPECT_TRUE(error.starts_with("warp.csv:")) << error;
  EXPECT_NE(error.find("check the numbers of this row"), std::string::npos) << error;
}

/// A strip that sticks out from a table and bends under its own weight.
std::string overhang(double thickness) {
  return fmt::format(R"({{"lissom": 1,
    "membrane_materials": {{"felt": {{"stiffness": "2000 N/m", "poisson_ratio": 0.2, "thickness": "{} mm",
                                      "area_density": "300 g/m^2"}}}},
    "membranes": [{{"name": "strip", "grid": {{"size": [60, 20], "cells": [9, 3]}}, "material": "felt"}}],
    "sets": {{"table": {{"box": [[0, 0, 0], [7, 20, 0]]}}, "edge": {{"box": [[59, 0, 0], [61, 20, 0]]}}}},
    "poses": [{{"name": "hung", "supports": [{{"at": "table", "hold": "pin"}}], "gravity": true}}],
    "calibration": {{
      "parameters": [{{"fabric": {{"thickness": ["0.1 mm", "5 mm"]}}}}],
      "measurements": [{{"shapes": {{"file": "edge.csv"}}}}]}}}})",
                     thickness);
}

TEST(FabricCalibration, AnOverhangTellsTheThicknessThatBends) {
  const double thickness = 0.9;  // mm
  const Design truth = base_of(overhang(thickness));
  ShapeData edge;
  edge.brief = {"", "edge.csv", 0};
  edge.where = "/calibration/measurements/0";
  const Result<std::vector<int>> nodes =
      select(truth.model, truth.system.structure, truth.model.sets[1].nodes, "/sets/edge");
  ASSERT_TRUE(nodes);
  const double nan = std::nan("");
  edge.shapes = {{0, {}}};
  for (const int node : nodes.value()) edge.shapes[0].places.push_back({node, Vec3(nan, nan, 0), {}, "edge.csv:2"});
  const VecX heights = samples::shown(truth, {edge});
  EXPECT_LT(heights.maxCoeff(), -0.005);
  for (Eigen::Index i = 0; i < heights.size(); ++i) {
    edge.shapes[0].places[static_cast<std::size_t>(i)].place.z() = heights[i];
  }
  const CalibrationFit fit = fitted(base_of(overhang(2)), {edge});
  EXPECT_EQ(fit.verdict, DesignVerdict::kConverged) << fit.message;
  EXPECT_NEAR(1e3 * fit.values[0] / thickness, 1, 1e-6);
  EXPECT_EQ(fit.statistics.parameters[0].state, Certainty::kDetermined);
}

}  // namespace
}  // namespace lissom
