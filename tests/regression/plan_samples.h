#pragma once
/// Plans that tests of designs share, and a design opened.

#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "lissom/core/file_io.h"
#include "lissom/design/live_design.h"
#include "lissom/model/document.h"

namespace lissom::samples {

/// A ring on fabric with a spline across, one straight rod, and a short free one.
inline Model ring_with_rods(double edge_length = 5e-3) {
  Model model;
  Plan& plan = model.plan.emplace();
  plan.material = "PLA";
  plan.edge_length = edge_length;
  plan.fabric.material = "soft knit";
  plan.fabric.pre_stretch = {1.35, 1.3};
  const auto point = [&](const char* name, double radius, double degrees, double r_n, double r_b) {
    const double angle = degrees * std::numbers::pi / 180;
    plan.points.push_back({name, Vec2(radius * std::cos(angle), radius * std::sin(angle)), r_n, r_b, false});
    return static_cast<int>(plan.points.size()) - 1;
  };
  std::vector<int> ring;
  for (const auto& [name, angle] : {std::pair("e", 0), std::pair("n", 85), std::pair("w", 170), std::pair("s", 260)}) {
    ring.push_back(point(name, 0.05, angle, 3e-4, 4.5e-4));
  }
  const int middle = point("middle", 0.012, 30, 2.5e-4, 4e-4), free = point("free", 0.03, 210, 3e-4, 3e-4);
  plan.rods.push_back({"ring", ring, PlanCurve::kSpline, PlanRole::kRod, true});
  plan.rods.push_back({"across", {ring[0], middle, ring[2]}, PlanCurve::kSpline, PlanRole::kRod, false});
  plan.rods.push_back({"stub", {middle, free}, PlanCurve::kStraight, PlanRole::kRod, false});
  Pose pose;
  pose.name = "released";
  model.poses.push_back(pose);
  return model;
}

inline Model fabric_scene(const std::string& name) {
  const Result<std::string> text = read_file("scenes/data/fabric/" + name + ".lissom");
  EXPECT_TRUE(text.ok()) << text.error().text();
  Result<Model> model = read_document(text.value());
  EXPECT_TRUE(model.ok()) << model.error().text();
  return std::move(model).value();
}

inline Support pin(const char* point) {
  Support support;
  support.kind = SupportKind::kPin;
  support.at.kind = Selector::Kind::kPlanPoint;
  support.at.name = point;
  return support;
}

inline std::unique_ptr<LiveDesign> open(const Model& model, double tolerance = 1e-6) {
  LiveDesign::Options options;
  options.solve.tolerance = tolerance;
  options.solve.modes = 0;
  Result<std::unique_ptr<LiveDesign>> made = LiveDesign::make(model, 0, options);
  EXPECT_TRUE(made.ok()) << made.error().text();
  EXPECT_EQ(made.value()->equilibrium().verdict, Verdict::kStable) << made.value()->equilibrium().message;
  return std::move(made).value();
}

}  // namespace lissom::samples
