#include "lissom/design/objective_stability_margin.h"

#include <cmath>
#include <limits>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/equilibrium/newton_workspace.h"
#include "lissom/equilibrium/stability.h"
#include "lissom/mechanics/rest_numbers.h"
#include "lissom/mechanics/third_derivative.h"

namespace lissom {

namespace {

constexpr double kMoving =
    1e-4;  // share of positions in a mode, below which nothing moves [as examine_stability has it]

/// The softest mode in which something moves; stiffness infinite where there is none.
Mode softest(const PoseShape& shape) {
  const Context context;
  NewtonWorkspace workspace(shape.problem, context);
  workspace.assemble(shape.state);
  const Stability stability = examine_stability(workspace, 1);
  const std::span<const int> kept = shape.problem.supports.kept();
  for (std::size_t k = 0; k < stability.modes.size(); ++k) {
    double moving = 0;
    for (int i = 0; i < 3 * shape.design.system.layout.nodes(); ++i) {
      if (kept[i] < 0) continue;
      const double entry = stability.free_shapes(kept[i], static_cast<int>(k));
      moving += shape.problem.mode_metric[kept[i]] * entry * entry;
    }
    if (moving >= kMoving) return stability.modes[k];
  }
  return {std::numeric_limits<double>::infinity(), VecX::Zero(shape.design.system.layout.size())};
}

class StabilityMargin final : public Objective {
 public:
  std::string_view name() const override { return "stability margin"; }
  std::string_view unit() const override { return "N/m"; }
  int size() const override { return 1; }
  double scale(const PoseShape& shape) const override { return shape.problem.scales.stiffness; }

  void values(const PoseShape& shape, VecX& c) const override { c = VecX::Constant(1, softest(shape).stiffness); }

  void jacobian(const PoseShape& shape, SparseRows& by_q, SparseRows& by_numbers) const override {
    const Mode mode = softest(shape);
    const VecX same = VecX::Zero(RestNumbers(shape.design.system.structure).size());
    VecX q, numbers = same;
    // The third derivative along phi twice serves both: it is symmetric.
    third_derivative(shape.problem.potential, shape.state, mode.shape, mode.shape, same, q, numbers);
    if (std::isfinite(mode.stiffness)) {
      add_turning_rolls(shape, mode, q);
      add_metric(shape, mode, numbers);
    }
    by_q = MatX(q.transpose()).sparseView();
    by_numbers = MatX(numbers.transpose()).sparseView();
  }

  bool has_curvature() const override { return false; }
  void curvature(const PoseShape&, const VecX&, const VecX&, const VecX&, VecX&, VecX&) const override {
    LISSOM_ASSERT(has_curvature());
  }

 private:
  /// Rolls are counted from frames that are carried along. About a moved state, those of that state differ from those of the
  /// old one by (t x d) . e / (2 l^2), with d the motion of the edge and e its increment [mathematics 1.8], and so does the
  /// metric of a mode.
  static void add_turning_rolls(const PoseShape& shape, const Mode& mode, VecX& by_q) {
    const System& system = shape.design.system;
    const std::span<const int> kept = shape.problem.supports.kept();
    for (int e = 0; e < system.edge_count(); ++e) {
      const int roll = system.layout.roll(e);
      if (kept[roll] < 0) continue;
      const StructureEdge& edge = system.structure.edges[e];
      const EdgeState& now = shape.state.edges[e];
      const Vec3 own = mode.shape.segment<3>(3 * edge.node1) - mode.shape.segment<3>(3 * edge.node0);
      const double weight =
          mode.stiffness * shape.problem.mode_metric[kept[roll]] * mode.shape[roll] / (now.length * now.length);
      const Vec3 change = weight * own.cross(now.t);
      by_q.segment<3>(3 * edge.node1) += change;
      by_q.segment<3>(3 * edge.node0) -= change;
    }
  }

  /// -stiffness phi' dM phi, with the shares of make_mode_metric.
  static void add_metric(const PoseShape& shape, const Mode& mode, VecX& by_numbers) {
    const System& system = shape.design.system;
    const RestNumbers numbers(system.structure);
    double length = 0, area = 0;
    for (const EdgeRest& edge : system.rest.edges) length += edge.length;
    for (const TriangleRest& triangle : system.rest.triangles) area += triangle.area;
    const auto square = [&](int node) { return mode.shape.segment<3>(3 * node).squaredNorm(); };
    VecX of_edge(system.edge_count()), of_triangle(static_cast<int>(system.rest.triangles.size()));
    const double per_length = length > 0 ? (area > 0 ? 0.5 : 1.0) / length : 0;
    const double per_area = area > 0 ? (length > 0 ? 0.5 : 1.0) / area : 0;
    double rods = 0, membranes = 0;  // shares in phi' M phi
    for (int e = 0; e < system.edge_count(); ++e) {
      const StructureEdge& edge = system.structure.edges[e];
      const double roll = mode.shape[system.layout.roll(e)];
      of_edge[e] =
          per_length * ((square(edge.node0) + square(edge.node1)) / 2 + system.rest.edges[e].gyration2 * roll * roll);
      rods += of_edge[e] * system.rest.edges[e].length;
    }
    for (int t = 0; t < of_triangle.size(); ++t) {
      const auto& node = system.structure.triangles[t].node;
      of_triangle[t] = per_area * (square(node[0]) + square(node[1]) + square(node[2])) / 3;
      membranes += of_triangle[t] * system.rest.triangles[t].area;
    }
    for (int e = 0; e < of_edge.size(); ++e) {
      by_numbers[numbers.edge(e, kEdgeLength)] -= mode.stiffness * (of_edge[e] - rods / length);
    }
    for (int t = 0; t < of_triangle.size(); ++t) {
      by_numbers[numbers.triangle(t, kTriangleArea)] -= mode.stiffness * (of_triangle[t] - membranes / area);
    }
  }
};

}  // namespace

std::shared_ptr<const Objective> make_stability_margin() { return std::make_shared<StabilityMargin>(); }

}  // namespace lissom
