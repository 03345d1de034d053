/// Sheets of one cell shape in TPU, hung by two sides; a honeycomb pulled in its plane.

#include "scenes/parts.h"
#include "scenes/scene_models.h"

namespace lissom::scene_models {

namespace {

constexpr double kRadius = 0.001;  // m

Model hung(const char* title, const ObjLines& lines, double margin) {
  Model model = sheet(title, lines, kRadius, "TPU 92A", 8);
  model.poses.push_back(hanging_pose(lines, margin));
  return model;
}

}  // namespace

Model hexagon_sheet() { return hung("Hexagon sheet hung by two sides", hexagon_pattern(0.0145, 8, 9), 1e-6); }
Model quad_sheet() { return hung("Square sheet hung by two sides", square_pattern(0.025, 8, 8), 1e-6); }
Model triangle_sheet() { return hung("Triangle sheet hung by two sides", triangle_pattern(0.03, 6, 7), 1e-6); }

Model honeycomb() {
  const ObjLines lines = hexagon_pattern(0.02, 8, 8);
  Model model = sheet("Honeycomb pulled in its plane", lines, kRadius, "TPU 92A", 10);
  Pose pose = hanging_pose(lines, 1e-6);
  pose.name = "pulled";
  pose.gravity.reset();
  pose.supports[1].move = Vec3(0.02, 0, 0);
  model.poses.push_back(pose);
  return model;
}

}  // namespace lissom::scene_models
