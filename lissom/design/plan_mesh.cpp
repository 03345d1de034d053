#include "lissom/design/plan_mesh.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <utility>

namespace lissom {

Result<PlanMesh> PlanMesh::make(const Model& model, double refine) {
  Result<ExpandedPlan> made = expand_plan(model, refine);
  if (!made) return made.error();
  Result<PlanMap> map = PlanMap::make(*model.plan, made.value());
  if (!map) return map.error();
  return PlanMesh(std::move(made).value(), std::move(map).value());
}

MeshFit PlanMesh::fit(const Plan& plan, const MeshLimits& limits) const {
  const MatX places = map_.positions(control_positions(plan));
  const MeshQuality quality = map_.quality(places);
  if (quality.ratio < limits.angle_ratio) {
    return {false, quality.ratio < 0 ? "a triangle would turn over" : "a triangle became too thin"};
  }
  const auto place = [&](int node) -> Vec2 { return places.row(node).transpose(); };
  for (std::size_t r = 0; r < made_.rods.size(); ++r) {
    const std::vector<int>& nodes = made_.rod_vertices[r];
    const bool closed = made_.rods[r].edges == static_cast<int>(nodes.size());
    const std::size_t edges = nodes.size() - (closed ? 0 : 1);
    Vec2 before = Vec2::Zero();
    for (std::size_t i = 0; i < edges; ++i) {
      const int a = nodes[i], b = nodes[(i + 1) % nodes.size()];
      const Vec2 edge = place(b) - place(a);
      const double ratio =
          edge.norm() /
          (made_.samples.nodes[static_cast<std::size_t>(b)] - made_.samples.nodes[static_cast<std::size_t>(a)]).norm();
      if (std::max(ratio, 1 / ratio) > limits.length_ratio) {
        return {false, fmt::format("an edge of rod \"{}\" became {:.2g} times as long", made_.rods[r].name, ratio)};
      }
      const bool sampled = static_cast<std::size_t>(a) >= plan.points.size();  // the plan itself may turn at its points
      const double turn = std::abs(std::atan2(before.x() * edge.y() - before.y() * edge.x(), before.dot(edge)));
      if (i > 0 && sampled && turn > limits.turn_ratio * plan.max_turn) {
        return {false, fmt::format("rod \"{}\" turns by {:.0f} degrees from edge to edge", made_.rods[r].name,
                                   turn * 180 / std::numbers::pi)};
      }
      before = edge;
    }
  }
  return {};
}

}  // namespace lissom
