#include "lissom/session/cloth.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include "lissom/session/quantity_families.h"

namespace lissom {

double Sides::rest_area() const { return 0.5 * rest.determinant(); }
double Sides::area() const { return 0.5 * now.col(0).cross(now.col(1)).norm(); }
Mat32 Sides::gradient() const { return now * rest.inverse(); }
Vec2 Sides::parts(const Vec3& direction) const { return drawn.colPivHouseholderQr().solve(direction); }
Vec2 Sides::parts_across(const Vec3& direction) const {
  const Vec3 normal = drawn.col(0).cross(drawn.col(1)).normalized();
  return parts(normal.cross(direction));
}

Vec2 present_pre_stretch(const Situation& s, const StructureMembrane& membrane) {
  if (!s.problem->stretches_with_load) return membrane.pre_stretch;
  return Vec2::Ones() + s.state.load_factor * (membrane.pre_stretch - Vec2::Ones());
}

namespace {

/// Factors by which the rest corners are larger than RestState says, because the pre-stretch grows with the load.
Vec2 rest_growth(const Situation& s, const StructureMembrane& membrane) {
  if (!s.problem->stretches_with_load) return Vec2::Ones();
  return membrane.pre_stretch.cwiseQuotient(present_pre_stretch(s, membrane));
}

}  // namespace

Sides sides_of(const Situation& s, int t) {
  const StructureTriangle& triangle = s.system->structure.triangles[t];
  const TriangleRest& rest = s.system->rest.triangles[t];
  const Vec2 growth = rest_growth(s, s.system->structure.membranes[triangle.membrane]);
  Sides sides;
  sides.moduli = &rest;
  for (int i = 0; i < 2; ++i) {
    const int from = triangle.node[0], to = triangle.node[i + 1];
    sides.drawn.col(i) = s.system->structure.nodes[to] - s.system->structure.nodes[from];
    sides.now.col(i) = s.state.position(to) - s.state.position(from);
    sides.rest.col(i) = (rest.corner[i + 1] - rest.corner[0]).cwiseProduct(growth);
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
