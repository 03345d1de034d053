#include "lissom/session/cloth.h"

#include <Eigen/QR>
#include <array>

#include "lissom/session/quantity_families.h"

namespace lissom {

Vec2 Sides::parts(const Vec3& direction) const { return drawn.colPivHouseholderQr().solve(direction); }
Vec2 Sides::parts_across(const Vec3& direction) const {
  const Vec3 normal = drawn.col(0).cross(drawn.col(1)).normalized();
  return parts(normal.cross(direction));
}

namespace {

/// Part of the pre-stretch that is there in the situation.
double share_of(const Situation& s) { return s.problem->stretches_with_load ? s.state.load_factor : 1; }

}  // namespace

Vec2 present_pre_stretch(const Situation& s, const StructureMembrane& membrane) {
  return Vec2::Ones() + share_of(s) * (membrane.pre_stretch - Vec2::Ones());
}

Sides sides_of(const Situation& s, int t) {
  const StructureTriangle& triangle = s.system->structure.triangles[t];
  const TriangleRest& rest = s.system->rest.triangles[t];
  std::array<Vec3, 3> now;
  for (int i = 0; i < 3; ++i) now[i] = s.state.position(triangle.node[i]);
  Sides sides;
  sides.moduli = &rest;
  const Vec2& pre_stretch = s.system->structure.membranes[triangle.membrane].pre_stretch;
  sides.stretch = triangle_stretch(rest, now, pre_stretch, share_of(s));
  for (int i = 0; i < 2; ++i) {
    sides.drawn.col(i) = s.system->structure.nodes[triangle.node[i + 1]] - s.system->structure.nodes[triangle.node[0]];
    sides.now.col(i) = now[i + 1] - now[0];
  }
  return sides;
}

Result<Cloth> cloth_at(const Measurement& m) {
  const Result<const Situation*> found = m.study.situation(m.pose(), m.refine);
  if (!found) return found.error();
  const System& system = *found.value()->system;
  const Result<std::vector<int>> nodes = selected_nodes(m, m.at, system);
  if (!nodes) return nodes.error();
  std::vector<bool> selected(system.structure.nodes.size(), false);
  for (const int node : nodes.value()) selected[node] = true;
  Cloth cloth{found.value(), {}};
  for (int t = 0; t < static_cast<int>(system.structure.triangles.size()); ++t) {
    const std::array<int, 3>& node = system.structure.triangles[t].node;
    if (selected[node[0]] && selected[node[1]] && selected[node[2]]) cloth.triangles.push_back(t);
  }
  if (!cloth.triangles.empty()) return cloth;
  return Error{ErrorCode::kGeometry, m.where + "/at", "no triangle of a membrane has all its corners in this selection",
               "select more of a membrane"};
}

}  // namespace lissom
