#include "scenes/parts.h"

#include <algorithm>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/model/import_network.h"

namespace lissom::scene_models {

Rod round_rod(std::string name, Curve curve, double radius, std::string material, int edges) {
  Rod rod;
  rod.name = std::move(name);
  rod.curve = std::move(curve);
  rod.material = std::move(material);
  rod.section.r_n = {radius};
  rod.section.r_b = {radius};
  rod.edges = edges;
  return rod;
}

Selector rod_place(std::string rod, double fraction) {
  Selector at;
  at.kind = Selector::Kind::kRod;
  at.name = std::move(rod);
  at.fraction = fraction;
  return at;
}

Selector box(const Vec3& low, const Vec3& high) {
  Selector at;
  at.kind = Selector::Kind::kBox;
  at.low = low;
  at.high = high;
  return at;
}

Selector at_point(const Vec3& point) {
  Selector at;
  at.kind = Selector::Kind::kPoint;
  at.point = point;
  return at;
}

Support hold(Selector at, SupportKind kind) {
  Support support;
  support.at = std::move(at);
  support.kind = kind;
  return support;
}

Model sheet(const std::string& title, const ObjLines& lines, double radius, const std::string& material, int edges) {
  NetworkOptions options;
  options.material = material;
  options.section.r_n = {radius};
  options.section.r_b = {radius};
  options.edges_per_segment = edges;
  options.rods = NetworkRods::kSegments;
  Result<ImportedNetwork> network = import_network(lines, options);
  LISSOM_ASSERT(network.ok());
  network.value().model.title = title;
  return std::move(network.value().model);
}

Pose hanging_pose(const ObjLines& lines, double margin) {
  double reach = 0;
  for (const Vec3& p : lines.points) reach = std::max(reach, p.x());
  Pose pose;
  pose.name = "hanging";
  for (const double side : {-1.0, 1.0}) {
    const double inner = side * (reach - margin), outer = side * (reach + margin);
    pose.supports.push_back(
        hold(box(Vec3(std::min(inner, outer), -10, -10), Vec3(std::max(inner, outer), 10, 10)), SupportKind::kPin));
  }
  pose.gravity = Gravity{};
  return pose;
}

}  // namespace lissom::scene_models
