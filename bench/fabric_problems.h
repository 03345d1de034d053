#pragma once
/// Rods on pre-stretched fabric: the problems on which the methods of the static solver are compared.

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "scenes/parts.h"

namespace lissom::networks {

/// Square frame of PLA rods on a square of fabric, `cells` triangles pairs and rod edges along each side.
struct SquareFrame {
  int cells = 8;
  double side = 0.12;                 ///< m
  double r_n = 0.2e-3, r_b = 0.4e-3;  ///< m
  double pre_stretch = 1.3;
  double stiffness = 0.3;  ///< N/m, Young's modulus times thickness
};

inline Model square_frame_on_fabric(const SquareFrame& frame) {
  Model model;
  MembraneMaterial fabric{"fabric", frame.stiffness, frame.stiffness, 0.3, 0, 0, "preset A of the mathematics"};
  model.membrane_materials.push_back(fabric);
  model.torsion = TorsionModel::kPolar;
  Membrane sheet;
  sheet.name = "fabric";
  sheet.material = fabric.name;
  sheet.pre_stretch = Vec2::Constant(frame.pre_stretch);
  sheet.shape = MembraneGrid{Vec2::Constant(-frame.side / 2), Vec2::Constant(frame.side), frame.cells, frame.cells};
  model.membranes.push_back(sheet);
  const double h = frame.side / 2;
  const Vec3 corner[] = {{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}};
  for (int k = 0; k < 4; ++k) {
    Rod rod;
    rod.name = "side " + std::to_string(k + 1);
    rod.curve = Polyline{{corner[k], corner[(k + 1) % 4]}, false};
    rod.material = "PLA";
    rod.section.r_n = {frame.r_n};
    rod.section.r_b = {frame.r_b};
    rod.edges = frame.cells;
    model.rods.push_back(rod);
  }
  Pose pose;
  pose.name = "released";
  model.poses.push_back(pose);
  return model;
}

/// A plan of PLA rods with one radius pair on taut knit, released.
inline Model empty_plan(double pre_stretch, double edge_length, double fabric_edge) {
  Model model;
  Plan& plan = model.plan.emplace();
  plan.material = "PLA";
  plan.edge_length = edge_length;
  plan.fabric.material = "elastane-cotton knit";
  plan.fabric.pre_stretch = Vec2::Constant(pre_stretch);
  plan.fabric.edge_length = fabric_edge;
  plan.fabric.bending = 0;
  model.torsion = TorsionModel::kPolar;
  Pose pose;
  pose.name = "released";
  model.poses.push_back(pose);
  return model;
}

inline int add_point(Model& model, const char* name, Vec2 at, double r_n, double r_b) {
  model.plan->points.push_back({name, at, r_n, r_b, false});
  return static_cast<int>(model.plan->points.size()) - 1;
}

/// Disc of 75 mm radius: a boundary ring and two crossing rods, 0.65 by 1.3 mm, about 700 rod edges.
inline Model crossed_disc() {
  Model model = empty_plan(1.4, 1.1e-3, 3.4e-3);
  std::vector<int> ring;
  for (int k = 0; k < 4; ++k) {
    const double angle = k * std::numbers::pi / 2;
    ring.push_back(add_point(model, std::array{"e", "n", "w", "s"}[k], 0.075 * Vec2(std::cos(angle), std::sin(angle)),
                             0.65e-3, 1.3e-3));
  }
  const int centre = add_point(model, "centre", Vec2::Zero(), 0.65e-3, 1.3e-3);
  model.plan->rods.push_back({"ring", ring, PlanCurve::kArc, PlanRole::kRod, true});
  model.plan->rods.push_back({"along", {ring[0], centre, ring[2]}, PlanCurve::kStraight, PlanRole::kRod, false});
  model.plan->rods.push_back({"across", {ring[1], centre, ring[3]}, PlanCurve::kStraight, PlanRole::kRod, false});
  return model;
}

/// Leaf of 200 mm: two outline halves, a midrib, five pairs of veins; 17 joints, about 890 rod edges.
inline Model leaf(double r_n, double pre_stretch) {
  Model model = empty_plan(pre_stretch, 1.35e-3, 3.6e-3);
  const double r_b = 1.3e-3;
  const auto half_width = [](double x) { return 0.055 * std::sin(std::numbers::pi * std::pow(x / 0.2, 0.85)); };
  constexpr int kPairs = 5;
  std::vector<int> midrib{add_point(model, "base", {0, 0}, r_n, r_b)}, left = midrib, right = midrib;
  constexpr std::array kNames{"1", "2", "3", "4", "5"};
  for (int k = 0; k < kPairs; ++k) {
    const double on_rib = 0.022 + 0.028 * k, on_edge = on_rib + 0.03;
    midrib.push_back(add_point(model, kNames[k], {on_rib, 0.002 * std::sin(1.3 * k)}, r_n, r_b));
    left.push_back(add_point(model, (std::string("l") + kNames[k]).c_str(), {on_edge, half_width(on_edge)}, r_n, r_b));
    right.push_back(
        add_point(model, (std::string("r") + kNames[k]).c_str(), {on_edge, -half_width(on_edge)}, r_n, r_b));
  }
  const int tip = add_point(model, "tip", {0.2, 0}, r_n, r_b);
  const auto rod = [&](std::string name, std::vector<int> points) {
    model.plan->rods.push_back({std::move(name), std::move(points), PlanCurve::kSpline, PlanRole::kRod, false});
  };
  for (int k = 1; k <= kPairs; ++k) {
    rod("vein l" + std::to_string(k), {midrib[k], left[k]});
    rod("vein r" + std::to_string(k), {midrib[k], right[k]});
  }
  for (std::vector<int>* path : {&midrib, &left, &right}) path->push_back(tip);
  rod("midrib", midrib);
  rod("left edge", left);
  rod("right edge", right);
  return model;
}

}  // namespace lissom::networks
