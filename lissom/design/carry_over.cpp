#include "lissom/design/carry_over.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "lissom/geometry/hermite_curve.h"
#include "lissom/geometry/triangle_finder.h"

namespace lissom {

namespace {

/// Structure nodes of the fabric's vertices; the first are the nodes of PlanSamples.
const std::vector<int>& fabric_nodes(const PlanStage& stage) { return stage.system.structure.membranes.back().nodes; }

std::vector<Vec2> flat_points(const PlanStage& stage) {
  std::vector<Vec2> points;
  for (const Vec3& p : stage.expanded.mesh().points) points.emplace_back(p.head<2>());
  return points;
}

std::vector<std::string> names_of(const Plan& plan, const PlanRod& rod) {
  std::vector<std::string> names;
  for (const int i : rod.points) names.push_back(plan.points[static_cast<std::size_t>(i)].name);
  return names;
}

/// The rod of `from` that this rod of `to` was, or -1.
int same_rod(const PlanStage& from, const PlanStage& to, std::size_t rod) {
  const PlanRod& wanted = to.plan.rods[rod];
  for (std::size_t r = 0; r < from.plan.rods.size(); ++r) {
    const PlanRod& old = from.plan.rods[r];
    if (old.name != wanted.name || old.closed != wanted.closed) continue;
    return names_of(from.plan, old) == names_of(to.plan, wanted) ? static_cast<int>(r) : -1;
  }
  return -1;
}

/// Edges of the structure between neighbouring vertices of the fabric, either way round.
std::map<std::pair<int, int>, int> edges_by_nodes(const System& system) {
  std::map<std::pair<int, int>, int> edges;
  for (int e = 0; e < system.edge_count(); ++e) {
    const StructureEdge& edge = system.structure.edges[e];
    edges.emplace(std::minmax(edge.node0, edge.node1), e);
  }
  return edges;
}

/// The old shape, to be asked by places of the plan.
struct Carrier {
  Carrier(const PlanStage& f, const State& s, const PlanStage& t)
      : from(f),
        to(t),
        state(s),
        old_flat(flat_points(f)),
        finder(old_flat, f.expanded.mesh().triangles),
        old_edges(edges_by_nodes(f.system)) {}

  const PlanStage &from, &to;
  const State& state;
  std::vector<Vec2> old_flat;
  TriangleFinder finder;
  std::map<std::pair<int, int>, int> old_edges;

  Vec3 old_position(int vertex) const { return state.position(fabric_nodes(from)[vertex]); }

  Vec3 on_fabric(const Vec2& p) const {
    const TriangleFinder::Place place = finder.find(p);
    Vec3 x = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      x += place.weight[static_cast<Eigen::Index>(i)] * old_position(from.expanded.mesh().triangles[place.triangle][i]);
    }
    return x;
  }

  Vec3 fabric_normal(const Vec2& p) const {
    const auto& t = from.expanded.mesh().triangles[finder.find(p).triangle];
    return (old_position(t[1]) - old_position(t[0])).cross(old_position(t[2]) - old_position(t[0])).normalized();
  }

  /// The old edge between two vertices, or -1.
  int old_edge(int a, int b) const {
    const std::vector<int>& nodes = fabric_nodes(from);
    const auto found = old_edges.find(std::minmax(nodes[a], nodes[b]));
    return found == old_edges.end() ? -1 : found->second;
  }
};

/// Number of old edges before each piece of a rod, and the whole at the end.
std::vector<int> piece_starts(const std::vector<int>& pieces) {
  std::vector<int> starts{0};
  for (const int edges : pieces) starts.push_back(starts.back() + edges);
  return starts;
}

/// New positions of all nodes, normals and axial strains of all edges of the new system.
struct Carried {
  VecX positions;
  std::vector<Vec3> normals;  ///< by edge, zero where nothing is known yet
  std::vector<double> strains;
};

/// A rod that was there before: nodes on the cubic through its old nodes.
void carry_rod(const Carrier& c, std::size_t rod, std::size_t old_rod, Carried& out,
               const std::map<std::pair<int, int>, int>& new_edges) {
  const std::vector<int>& old_nodes = c.from.expanded.samples.rods[old_rod];
  const std::vector<int>& new_nodes = c.to.expanded.samples.rods[rod];
  const std::vector<int> old_starts = piece_starts(c.from.expanded.samples.pieces[old_rod]);
  const std::vector<int>& old_pieces = c.from.expanded.samples.pieces[old_rod];
  const std::vector<int>& new_pieces = c.to.expanded.samples.pieces[rod];
  const bool closed = c.to.plan.rods[rod].closed;
  std::vector<Vec3> points;
  for (const int vertex : old_nodes) points.push_back(c.old_position(vertex));
  const HermiteCurve<Vec3> curve(points, closed);
  const std::vector<int>& node_of = fabric_nodes(c.to);
  std::size_t node = 0;
  for (std::size_t piece = 0; piece < new_pieces.size(); ++piece) {
    const double ratio = double(old_pieces[piece]) / new_pieces[piece];
    const auto old_edge_at = [&](double u) {
      return old_starts[piece] + std::min(static_cast<int>(u), old_pieces[piece] - 1);
    };
    for (int step = 0; step < new_pieces[piece]; ++step, ++node) {
      const double u = ratio * step, middle = ratio * (step + 0.5);
      if (step > 0) {
        const int edge = old_edge_at(u);
        out.positions.segment<3>(3 * node_of[new_nodes[node]]) = curve.point(edge, old_starts[piece] + u - edge);
      }
      const int edge = old_edge_at(middle);
      const int was = c.old_edge(old_nodes[static_cast<std::size_t>(edge)],
                                 old_nodes[(static_cast<std::size_t>(edge) + 1) % old_nodes.size()]);
      const auto found =
          new_edges.find(std::minmax(node_of[new_nodes[node]], node_of[new_nodes[(node + 1) % new_nodes.size()]]));
      if (was < 0 || found == new_edges.end()) continue;
      const EdgeState& before = c.state.edges[was];
      out.normals[found->second] = before.material().n;
      out.strains[found->second] = before.length / c.from.system.rest.edges[was].length - 1;
    }
  }
}

/// The rotation with which the frames at a joint fit its edges best.
Mat3 joint_rotation(const System& system, int joint, const Carried& carried) {
  Mat3 turn = Mat3::Zero();
  for (int k = system.first_connection[joint]; k < system.first_connection[joint + 1]; ++k) {
    const Connection& connection = system.connections[k];
    const StructureEdge& edge = system.structure.edges[connection.edge];
    const Vec3 e = carried.positions.segment<3>(3 * edge.node1) - carried.positions.segment<3>(3 * edge.node0);
    const Frame now = frame_from_normal(e, carried.normals[static_cast<std::size_t>(connection.edge)]);
    turn += now.t * connection.rest.t.transpose() + now.b * connection.rest.b.transpose() +
            now.n * connection.rest.n.transpose();
  }
  return nearest_rotation(turn);
}

}  // namespace

CarriedShape carried_over(const PlanStage& from, const State& state, const PlanStage& to) {
  const Carrier c(from, state, to);
  const System& system = to.system;
  const std::vector<int>& node_of = fabric_nodes(to);
  Carried carried;
  carried.positions.resize(3 * system.layout.nodes());
  // What lies off the fabric stays as drawn.
  for (int i = 0; i < system.layout.nodes(); ++i) carried.positions.segment<3>(3 * i) = system.structure.nodes[i];
  carried.normals.assign(static_cast<std::size_t>(system.edge_count()), Vec3::Zero());
  carried.strains.assign(static_cast<std::size_t>(system.edge_count()), 0.0);
  const std::vector<Vec2> flat = flat_points(to);
  for (std::size_t v = 0; v < flat.size(); ++v) carried.positions.segment<3>(3 * node_of[v]) = c.on_fabric(flat[v]);
  std::map<std::string, std::size_t> old_points;
  for (std::size_t i = 0; i < from.plan.points.size(); ++i) old_points.emplace(from.plan.points[i].name, i);
  for (std::size_t i = 0; i < to.plan.points.size(); ++i) {
    const auto old = old_points.find(to.plan.points[i].name);
    if (old == old_points.end()) continue;
    carried.positions.segment<3>(3 * node_of[i]) = c.old_position(static_cast<int>(old->second));
  }
  const std::map<std::pair<int, int>, int> new_edges = edges_by_nodes(system);
  for (std::size_t r = 0; r < to.plan.rods.size(); ++r) {
    const int old = same_rod(from, to, r);
    if (old >= 0) carry_rod(c, r, static_cast<std::size_t>(old), carried, new_edges);
  }

  for (int e = 0; e < system.edge_count(); ++e) {
    if (!carried.normals[static_cast<std::size_t>(e)].isZero()) continue;
    const StructureEdge& edge = system.structure.edges[e];
    const Vec3 middle = (system.structure.nodes[edge.node0] + system.structure.nodes[edge.node1]) / 2;
    carried.normals[static_cast<std::size_t>(e)] = c.fabric_normal(middle.head<2>());
  }
  std::vector<Mat3> rotations;
  for (int j = 0; j < system.joint_count(); ++j) rotations.push_back(joint_rotation(system, j, carried));
  for (std::size_t i = 0; i < to.plan.points.size(); ++i) {
    const auto old = old_points.find(to.plan.points[i].name);
    const int joint = system.joint_of_node[node_of[i]];
    if (old == old_points.end() || joint < 0) continue;
    const int before = from.system.joint_of_node[fabric_nodes(from)[old->second]];
    if (before >= 0)
      rotations[static_cast<std::size_t>(joint)] = state.joint_rotation[static_cast<std::size_t>(before)];
  }
  return {state_of_shape(system, carried.positions, carried.normals, rotations, state.load_factor),
          std::move(carried.strains)};
}

}  // namespace lissom
