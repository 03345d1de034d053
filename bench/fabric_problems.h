#pragma once
/// Rods on pre-stretched fabric: the problems on which the methods of the static solver are compared.

#include <string>

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

}  // namespace lissom::networks
