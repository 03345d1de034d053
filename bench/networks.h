#pragma once
/// Structures that benches measure.

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "scenes/parts.h"
#include "scenes/scenes.h"

namespace lissom::networks {

/// A horizontal rod of 1 m, clamped at one end, under a line load under which its tip falls by 0.28 of its length.
inline Model hanging_cantilever(int nodes) {
  Model model;
  Rod rod = scene_models::round_rod("beam", Polyline{{Vec3(0, 0, 0), Vec3(1, 0, 0)}, false}, 0.005, "", nodes - 1);
  // E I = 8.33e-3 N m^2 with a round section of 5 mm.
  Material material{
      "soft", 8.33e-3 / (0.25 * 3.14159265358979 * 6.25e-10), 0.3, 0, 1, "the load case of the comparison"};
  rod.material = material.name;
  model.materials.push_back(material);
  model.rods.push_back(rod);
  Pose pose;
  pose.name = "loaded";
  pose.supports.push_back(scene_models::hold(scene_models::rod_place("beam", 0), SupportKind::kClamp));
  LineLoad load;
  load.force_per_length = Vec3(0, 0, -0.0196);
  pose.line_loads.push_back(load);
  model.poses.push_back(pose);
  return model;
}

/// A sheet of hexagons hung by two opposite sides.
inline Model hanging_honeycomb(int columns, int rows, int edges) {
  const ObjLines lines = hexagon_pattern(0.02, columns, rows);
  Model model = scene_models::sheet("honeycomb", lines, 0.001, "TPU 92A", edges);
  model.poses.push_back(scene_models::hanging_pose(lines, 1e-6));
  return model;
}

/// Nine limbs of 24 edges that meet in a hub, which is held; limbs rise to a knee and fall to a foot. About 860 unknowns.
inline Model spider() {
  Model model;
  for (int k = 0; k < 9; ++k) {
    const double angle = 2 * 3.14159265358979 * k / 9;
    const Vec3 out(std::cos(angle), std::sin(angle), 0), up(0, 0, 1);
    const Polyline limb{{Vec3::Zero(), 0.06 * out + 0.04 * up, 0.14 * out - 0.08 * up}, false};
    model.rods.push_back(scene_models::round_rod("limb " + std::to_string(k + 1), limb, 0.0006, "TPU 92A", 24));
  }
  Pose pose;
  pose.name = "let go";
  pose.supports.push_back(scene_models::hold(scene_models::rod_place("limb 1", 0), SupportKind::kPin));
  pose.gravity = Gravity{};
  model.poses.push_back(pose);
  return model;
}

inline Model scene(std::string_view name) {
  const auto all = scenes();
  return std::find_if(all.begin(), all.end(), [&](const Scene& s) { return s.name == name; })->make();
}

}  // namespace lissom::networks
