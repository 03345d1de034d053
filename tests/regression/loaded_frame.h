#pragma once
/// Two rods under every kind of load and support, for tests of what follows them.

#include "lissom/model/model.h"
#include "scenes/parts.h"

namespace lissom::samples {

/// Two rods that meet, with every kind of load and support.
inline Model loaded_frame(JointKind joints) {
  Model model;
  const Vec3 foot(0, 0, 0), knee(0.1, 0.02, 0.08), tip(0.22, -0.01, 0.05);
  model.rods.push_back(scene_models::round_rod("leg", Spline{{foot, Vec3(0.04, 0, 0.05), knee}}, 2e-3, "PLA", 6));
  model.rods.push_back(scene_models::round_rod("arm", Polyline{{knee, tip}}, 1.5e-3, "PLA", 6));
  for (Rod& rod : model.rods) rod.axes.kind = MaterialAxes::Kind::kTransport;
  model.joint_kind = joints;
  const auto at = [](const char* rod, double place) { return scene_models::rod_place(rod, place); };
  Pose pose;
  pose.name = "loaded";
  Support clamp = scene_models::hold(at("leg", 0), SupportKind::kClamp);
  clamp.move = {2e-3, -1e-3, 3e-3};
  Support rail = scene_models::hold(at("arm", 1), SupportKind::kFree);
  rail.directions = {Vec3(1, 0, 1).normalized()};
  rail.move = {4e-3, 0, -2e-3};
  pose.supports = {clamp, rail};
  PointForce shared;
  shared.at = at("arm", -1);
  shared.force = {0.2, 0.4, -0.6};
  shared.shared = true;
  PointForce one;
  one.at = at("arm", 0.5);
  one.force = {0, 0.3, 0.1};
  one.scaling = Scaling::kConstant;
  pose.forces = {shared, one};
  PointMoment moment;
  moment.at = at("arm", 1);
  moment.moment = {5e-3, -4e-3, 8e-3};
  pose.moments = {moment};
  LineLoad wind;
  wind.rods = {"leg"};
  wind.force_per_length = {1, 2, -0.5};
  pose.line_loads = {wind};
  pose.gravity = Gravity{};
  SoftPin there, here;
  there.at = at("leg", 0.5);
  there.stiffness = 40;
  there.target = Vec3(0.05, 0.02, 0.06);
  here.at = at("leg", 1);
  here.stiffness = 25;
  pose.soft_pins = {there, here};
  model.poses = {Pose{}, pose};
  model.poses[0].name = "other";
  model.poses[0].supports = {clamp};
  return model;
}

}  // namespace lissom::samples
