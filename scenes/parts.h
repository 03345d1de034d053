#pragma once
/// Small pieces that scenes are put together from.

#include <string>
#include <vector>

#include "lissom/geometry/line_patterns.h"
#include "lissom/model/model.h"

namespace lissom::scene_models {

/// One straight, spline or other rod with a constant round section.
Rod round_rod(std::string name, Curve curve, double radius, std::string material, int edges);

Selector rod_place(std::string rod, double fraction);
Selector box(const Vec3& low, const Vec3& high);
Selector at_point(const Vec3& point);

Support hold(Selector at, SupportKind kind);

/// A sheet of round rods along these lines (m), one rod per line.
Model sheet(const std::string& title, const ObjLines& lines, double radius, const std::string& material, int edges);

/// Holds the nodes at both ends of the x range and lets the sheet hang under gravity.
Pose hanging_pose(const ObjLines& lines, double margin);

}  // namespace lissom::scene_models
