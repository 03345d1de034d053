#include "lissom/model/moved_plan.h"

#include <utility>

#include "lissom/model/check_plan.h"

namespace lissom {

MatX control_positions(const Plan& plan) {
  MatX controls(plan.points.size(), 2);
  for (std::size_t i = 0; i < plan.points.size(); ++i) {
    controls.row(static_cast<Eigen::Index>(i)) = plan.points[i].at.transpose();
  }
  return controls;
}

VecX control_radii(const Plan& plan, double PlanPoint::*half_extent) {
  VecX controls(plan.points.size());
  for (std::size_t i = 0; i < plan.points.size(); ++i) {
    controls[static_cast<Eigen::Index>(i)] = plan.points[i].*half_extent;
  }
  return controls;
}

Result<ExpandedPlan> moved_plan(const Model& model, const ExpandedPlan& base, const PlanMap& map) {
  LISSOM_ASSERT(model.plan.has_value());
  const Plan& plan = *model.plan;
  if (Status s = check_plan(model); !s) return s.error();
  ExpandedPlan moved = base;
  const MatX places = map.positions(control_positions(plan));
  const VecX r_n = map.radii(control_radii(plan, &PlanPoint::r_n));
  const VecX r_b = map.radii(control_radii(plan, &PlanPoint::r_b));
  for (std::size_t i = 0; i < moved.samples.nodes.size(); ++i) {
    moved.samples.nodes[i] = places.row(static_cast<Eigen::Index>(i)).transpose();
  }
  if (Status s = check_plan_drawing(plan, moved.samples); !s) return s.error();
  for (std::size_t r = 0; r < moved.rods.size(); ++r) {
    Polyline& line = std::get<Polyline>(moved.rods[r].curve);
    SectionProfile& section = moved.rods[r].section;
    moved.rods[r].material = plan.material;
    for (std::size_t k = 0; k < line.points.size(); ++k) {
      const int vertex = moved.rod_vertices[r][k];
      line.points[k].head<2>() = places.row(vertex).transpose();
      section.r_n[k] = r_n[vertex];
      section.r_b[k] = r_b[vertex];
    }
  }
  MembraneMesh& mesh = std::get<MembraneMesh>(moved.membrane.shape);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    mesh.points[i].head<2>() = places.row(static_cast<Eigen::Index>(i)).transpose();
  }
  const Fabric& fabric = plan.fabric;
  moved.membrane = {kFabricName,        std::move(mesh),   fabric.material,
                    fabric.pre_stretch, fabric.warp_angle, fabric.bending};
  moved.smallest_angle = map.quality(places).smallest_angle;
  moved.notes.clear();
  note_plan(plan, moved.samples, {r_b.data(), r_b.data() + r_b.size()}, moved.notes);
  return moved;
}

}  // namespace lissom
