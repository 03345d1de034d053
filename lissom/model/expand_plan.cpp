#include "lissom/model/expand_plan.h"

#include <algorithm>
#include <fmt/format.h>
#include <numbers>

#include "lissom/geometry/hermite_curve.h"
#include "lissom/geometry/planar_mesh.h"
#include "lissom/model/check_plan.h"

namespace lissom {

namespace {

/// Radii at all nodes, from those of the points.
std::vector<double> node_radii(const Plan& plan, const PlanSamples& samples, double PlanPoint::*radius) {
  std::vector<double> radii(samples.nodes.size());
  for (std::size_t i = 0; i < plan.points.size(); ++i) radii[i] = plan.points[i].*radius;
  std::vector<HermiteCurve<double>> curves;
  for (const PlanRod& rod : plan.rods) {
    std::vector<double> controls;
    for (const int i : rod.points) controls.push_back(plan.points[static_cast<std::size_t>(i)].*radius);
    curves.emplace_back(controls, rod.closed);
  }
  samples.each_inner(plan.points.size(), [&](std::size_t r, int piece, int step, int steps, std::size_t node) {
    const std::vector<int>& points = plan.rods[r].points;
    const std::size_t k = static_cast<std::size_t>(piece);
    const double start = plan.points[static_cast<std::size_t>(points[k])].*radius;
    const double end = plan.points[static_cast<std::size_t>(points[(k + 1) % points.size()])].*radius;
    radii[node] = std::max(curves[r].point(piece, double(step) / steps), least_radius(start, end));
  });
  return radii;
}

/// The parts of a rod between the points that cut it: nodes of each, and whether it is still closed.
struct Part {
  std::vector<int> nodes;
  bool closed = false;
};

std::vector<Part> cut_at_splits(const Plan& plan, const std::vector<int>& nodes, bool closed) {
  const auto splits = [&](int node) {
    return static_cast<std::size_t>(node) < plan.points.size() && plan.points[static_cast<std::size_t>(node)].split;
  };
  std::vector<int> path = nodes;
  if (closed) {
    const auto first = std::find_if(path.begin(), path.end(), splits);
    if (first == path.end()) return {{std::move(path), true}};
    std::rotate(path.begin(), first, path.end());
    path.push_back(path.front());
  }
  std::vector<Part> parts(1);
  for (std::size_t i = 0; i < path.size(); ++i) {
    parts.back().nodes.push_back(path[i]);
    if (i > 0 && i + 1 < path.size() && splits(path[i])) parts.push_back({{path[i]}, false});
  }
  return parts;
}

Rod make_rod(const Plan& plan, const PlanSamples& samples, const Part& part, const std::vector<double>& r_n,
             const std::vector<double>& r_b) {
  Rod rod;
  rod.material = plan.material;
  Polyline polyline{{}, part.closed};
  for (const int node : part.nodes) {
    const std::size_t i = static_cast<std::size_t>(node);
    polyline.points.emplace_back(samples.nodes[i].x(), samples.nodes[i].y(), 0);
    rod.section.r_n.push_back(r_n[i]);
    rod.section.r_b.push_back(r_b[i]);
  }
  rod.edges = static_cast<int>(part.nodes.size()) - (part.closed ? 0 : 1);
  rod.curve = std::move(polyline);
  return rod;
}

void make_rods(const Plan& plan, const std::vector<double>& r_b, ExpandedPlan& out) {
  const std::vector<double> r_n = node_radii(plan, out.samples, &PlanPoint::r_n);
  std::vector<int> ends(plan.points.size(), 0);  // rod ends and passages at each point
  for (std::size_t r = 0; r < plan.rods.size(); ++r) {
    const PlanRod& drawn = plan.rods[r];
    if (drawn.role == PlanRole::kGhost) continue;
    std::vector<Part> parts = cut_at_splits(plan, out.samples.rods[r], drawn.closed);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      out.rods.push_back(make_rod(plan, out.samples, parts[k], r_n, r_b));
      for (const int node : parts[k].nodes) {
        if (static_cast<std::size_t>(node) < ends.size()) ++ends[static_cast<std::size_t>(node)];
      }
      out.rod_vertices.push_back(std::move(parts[k].nodes));
    }
  }
  const std::vector<std::string> names = plan_rod_names(plan);
  for (std::size_t r = 0; r < out.rods.size(); ++r) out.rods[r].name = names[r];
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (!plan.points[i].split || ends[i] < 2) continue;
    Selector at;
    at.kind = Selector::Kind::kPlanPoint;
    at.name = plan.points[i].name;
    out.joints.push_back({at, JointKind::kBall});
  }
}

/// Everything that the fabric has to conform to.
PlanarRegion make_region(const Plan& plan, const PlanSamples& samples, double refine) {
  PlanarRegion region;
  region.points = samples.nodes;
  region.holes = plan.fabric.holes;
  region.min_angle = plan.fabric.min_angle;
  double length = 0;
  for (std::size_t r = 0; r < plan.rods.size(); ++r) {
    const std::vector<std::string>& names = plan.fabric.outline;
    const bool edge = names.empty() || std::find(names.begin(), names.end(), plan.rods[r].name) != names.end();
    const std::vector<int>& nodes = samples.rods[r];
    for (std::size_t i = 0; i + (plan.rods[r].closed ? 0 : 1) < nodes.size(); ++i) {
      const int a = nodes[i], b = nodes[(i + 1) % nodes.size()];
      if (edge) region.outline.push_back(static_cast<int>(region.segments.size()));
      region.segments.push_back({a, b});
      length += (region.points[static_cast<std::size_t>(b)] - region.points[static_cast<std::size_t>(a)]).norm();
    }
  }
  region.edge_length = plan.fabric.edge_length / refine;
  if (!(region.edge_length > 0)) region.edge_length = length / double(std::max<std::size_t>(region.segments.size(), 1));
  return region;
}

}  // namespace

double least_radius(double start, double end) { return 0.05 * std::min(start, end); }

std::vector<std::string> plan_rod_names(const Plan& plan) {
  std::vector<std::string> names;
  for (const PlanRod& rod : plan.rods) {
    if (rod.role == PlanRole::kGhost) continue;
    const std::size_t parts = cut_at_splits(plan, rod.points, rod.closed).size();
    for (std::size_t k = 0; k < parts; ++k) names.push_back(parts == 1 ? rod.name : fmt::format("{}-{}", rod.name, k));
  }
  return names;
}

Result<ExpandedPlan> expand_plan(const Model& model, double refine) {
  LISSOM_ASSERT(model.plan.has_value());
  const Plan& plan = *model.plan;
  if (Status s = check_plan(model); !s) return s.error();
  Result<PlanSamples> samples = sample_plan(plan, refine);
  if (!samples) return samples.error();
  ExpandedPlan out;
  out.refine = refine;
  out.samples = std::move(samples).value();
  if (Status s = check_plan_drawing(plan, out.samples); !s) return s.error();
  const std::vector<double> r_b = node_radii(plan, out.samples, &PlanPoint::r_b);
  make_rods(plan, r_b, out);
  Result<PlanarMesh> mesh = mesh_planar_region(make_region(plan, out.samples, refine), "/plan/fabric");
  if (!mesh) return mesh.error();
  if (Status s = check_plan_mesh(plan, out.samples, mesh.value()); !s) return s.error();
  MembraneMesh shape;
  for (const Vec2& p : mesh.value().points) shape.points.emplace_back(p.x(), p.y(), 0);
  shape.triangles = std::move(mesh.value().triangles);
  const Fabric& fabric = plan.fabric;
  out.membrane = {kFabricName,        std::move(shape),  fabric.material,
                  fabric.pre_stretch, fabric.warp_angle, fabric.bending};
  out.smallest_angle = mesh.value().smallest_angle;
  if (out.smallest_angle < fabric.min_angle) {
    constexpr double kDegree = std::numbers::pi / 180;
    out.notes.push_back(
        fmt::format("the smallest angle of the fabric's triangles is {:.1f} degrees, {:.1f} were asked for: rods are "
                    "closer to each "
                    "other there than their edges are long",
                    out.smallest_angle / kDegree, fabric.min_angle / kDegree));
  }
  note_plan(plan, out.samples, r_b, out.notes);
  return out;
}

Model with_plan_expanded(const Model& model, const ExpandedPlan& plan) {
  Model whole = model;
  whole.rods.insert(whole.rods.end(), plan.rods.begin(), plan.rods.end());
  whole.membranes.push_back(plan.membrane);
  whole.joints.insert(whole.joints.end(), plan.joints.begin(), plan.joints.end());
  return whole;
}

}  // namespace lissom
