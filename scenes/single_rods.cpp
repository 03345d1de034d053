/// Single rods, rings and frames.

#include <numbers>
#include <utility>

#include "scenes/parts.h"
#include "scenes/scene_models.h"

namespace lissom::scene_models {

namespace {

PointForce force_at(Selector at, const Vec3& force) {
  PointForce load;
  load.at = std::move(at);
  load.force = force;
  return load;
}

}  // namespace

Model cantilever() {
  Model model;
  model.title = "Cantilever";
  model.rods.push_back(round_rod("beam", Polyline{{Vec3(0, 0, 0), Vec3(0.2, 0, 0)}, false}, 0.001, "TPU 92A", 100));
  Pose pose;
  pose.name = "loaded";
  pose.supports.push_back(hold(rod_place("beam", 0), SupportKind::kClamp));
  pose.forces.push_back(force_at(rod_place("beam", 1), Vec3(0, 0, -0.00125663706144)));
  model.poses.push_back(pose);
  return model;
}

Model ring() {
  Model model;
  model.title = "Ring under two opposite forces";
  Arc circle;
  circle.start = Vec3(0.05, 0, 0);
  circle.angle = 2 * std::numbers::pi;
  circle.closed = true;
  model.rods.push_back(round_rod("ring", circle, 0.001, "TPU 92A", 120));
  Pose pose;
  pose.name = "pulled";
  pose.forces.push_back(force_at(rod_place("ring", 0), Vec3(0.02, 0, 0)));
  pose.forces.push_back(force_at(rod_place("ring", 0.5), Vec3(-0.02, 0, 0)));
  model.poses.push_back(pose);
  return model;
}

Model square_frame() {
  Model model;
  model.title = "Square frame under two opposite forces";
  const Vec3 corner[4] = {Vec3(-0.06, -0.06, 0), Vec3(0.06, -0.06, 0), Vec3(0.06, 0.06, 0), Vec3(-0.06, 0.06, 0)};
  const char* names[4] = {"bottom", "right", "top", "left"};
  for (int k = 0; k < 4; ++k) {
    Rod rod = round_rod(names[k], Polyline{{corner[k], corner[(k + 1) % 4]}, false}, 0.001, "TPU 92A", 20);
    rod.section.r_b = {0.002};
    model.rods.push_back(rod);
  }
  Pose pose;
  pose.name = "pulled";
  pose.forces.push_back(force_at(rod_place("top", 0.5), Vec3(0, 0.02, 0)));
  pose.forces.push_back(force_at(rod_place("bottom", 0.5), Vec3(0, -0.02, 0)));
  model.poses.push_back(pose);
  return model;
}

Model grid() {
  const ObjLines lines = square_pattern(0.02, 4, 4);
  Model model = sheet("Square grid bent as a plate", lines, 0.001, "TPU 92A", 10);
  Pose pose;
  pose.name = "loaded";
  pose.supports.push_back(hold(box(Vec3(-0.041, -1, -1), Vec3(-0.039, 1, 1)), SupportKind::kPin));
  pose.supports.push_back(hold(box(Vec3(-0.021, -1, -1), Vec3(-0.019, 1, 1)), SupportKind::kPin));
  pose.forces.push_back(force_at(box(Vec3(0.039, -1, -1), Vec3(0.041, 1, 1)), Vec3(0, 0, -0.01)));
  pose.forces.back().shared = true;
  model.poses.push_back(pose);
  return model;
}

Model helix() {
  Model model;
  model.title = "Helical spring";
  Helix coil;
  coil.start = Vec3(0.01, 0, 0);
  coil.pitch = 0.004;
  coil.turns = 5;
  model.rods.push_back(round_rod("spring", coil, 0.0008, "PLA", 300));
  Pose pose;
  pose.name = "pulled";
  pose.supports.push_back(hold(rod_place("spring", 0), SupportKind::kClamp));
  pose.supports.push_back(hold(rod_place("spring", 1), SupportKind::kClamp));
  pose.supports.back().move = Vec3(0, 0, 0.01);
  model.poses.push_back(pose);
  return model;
}

}  // namespace lissom::scene_models
