#include <Eigen/Eigenvalues>
#include <cmath>
#include <deque>

#include "lissom/model/discretize_parts.h"

namespace lissom {

namespace {

constexpr double kUndecided = 1e-3;  // difference of the two smallest eigenvalues, of 1 per rod

/// Rods with axes from joints as the edges of a graph between their end nodes.
struct EndGraph {
  struct Link {
    int node, rod;
    bool forward;
  };
  std::vector<std::vector<Link>> links;  ///< by node
};

/// A normal carried along a rod without twist, from its start to its end or back.
Vec3 carried_along(const RodShape& rod, Vec3 normal, bool forward) {
  const size_t n = rod.edge_tangents.size();
  for (size_t k = 1; k < n; ++k) {
    const size_t from = forward ? k - 1 : n - k, to = forward ? k : n - k - 1;
    normal = parallel_transport(rod.edge_tangents[from], rod.edge_tangents[to], normal);
  }
  return normal;
}

/// Eigenvector of the smallest eigenvalue of the sum of t t^T; zero where tangents do not span a plane.
Vec3 plane_normal(const Mat3& sum, int count) {
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(sum / count);
  if (eigen.eigenvalues()(1) - eigen.eigenvalues()(0) < kUndecided) return Vec3::Zero();
  return eigen.eigenvectors().col(0);
}

EndGraph end_graph(const Draft& draft) {
  EndGraph graph;
  graph.links.resize(draft.structure.nodes.size());
  for (size_t r = 0; r < draft.drawn.size(); ++r) {
    if (draft.model.rods[r].axes.kind != MaterialAxes::Kind::kJoints || draft.drawn[r].closed) continue;
    const int first = draft.structure.rods[r].nodes.front(), last = draft.structure.rods[r].nodes.back();
    graph.links[static_cast<size_t>(first)].push_back({last, static_cast<int>(r), true});
    graph.links[static_cast<size_t>(last)].push_back({first, static_cast<int>(r), false});
  }
  return graph;
}

/// Normals up to their sign, from all rod edges at the end nodes.
std::vector<Vec3> unsigned_normals(const Draft& draft, const EndGraph& graph) {
  std::vector<Mat3> sums(graph.links.size(), Mat3::Zero());
  std::vector<int> counts(graph.links.size(), 0);
  for (size_t r = 0; r < draft.drawn.size(); ++r) {
    const StructureRod& rod = draft.structure.rods[r];
    for (size_t i = 0; i < rod.edges.size(); ++i) {
      const StructureEdge& edge = draft.structure.edges[static_cast<size_t>(rod.edges[i])];
      const Vec3& t = draft.drawn[r].edge_tangents[i];
      for (int node : {edge.node0, edge.node1}) {
        const auto n = static_cast<size_t>(node);
        if (graph.links[n].empty()) continue;
        sums[n] += t * t.transpose();
        ++counts[n];
      }
    }
  }
  std::vector<Vec3> normals(graph.links.size(), Vec3::Zero());
  for (size_t n = 0; n < normals.size(); ++n) {
    if (counts[n] > 1) normals[n] = plane_normal(sums[n], counts[n]);
  }
  return normals;
}

/// The normal that the user names for the rods at a node decides the first sign; across it, the larger coordinate.
Vec3 oriented(const Vec3& normal, const Vec3& wish) {
  const double dot = normal.dot(wish);
  if (std::abs(dot) > 1e-6 * wish.norm()) return dot > 0 ? normal : Vec3(-normal);
  int largest = 0;
  normal.cwiseAbs().maxCoeff(&largest);
  return normal(largest) > 0 ? normal : Vec3(-normal);
}

/// Walks each connected part breadth-first from its first decided node; signs follow the carried normal. Undecided nodes
/// pass on what they receive. A part without any decided node starts from the direction that the rods name.
void propagate(const Draft& draft, const EndGraph& graph, size_t seed, const std::vector<char>& decided,
               std::vector<Vec3>& normals, std::vector<char>& done) {
  std::deque<size_t> queue{seed};
  done[seed] = 1;
  while (!queue.empty()) {
    const size_t node = queue.front();
    queue.pop_front();
    for (const EndGraph::Link& link : graph.links[node]) {
      const auto next = static_cast<size_t>(link.node);
      if (done[next]) continue;
      const Vec3 received = carried_along(draft.drawn[static_cast<size_t>(link.rod)], normals[node], link.forward);
      if (!decided[next]) {
        normals[next] = received;
      } else if (received.dot(normals[next]) < 0) {
        normals[next] = -normals[next];
      }
      done[next] = 1;
      queue.push_back(next);
    }
  }
}

/// Undecided nodes take the mean of what their decided neighbours carry to them.
void average_undecided(const Draft& draft, const EndGraph& graph, const std::vector<char>& decided,
                       std::vector<Vec3>& normals) {
  const std::vector<Vec3> before = normals;
  for (size_t node = 0; node < normals.size(); ++node) {
    if (decided[node]) continue;
    Vec3 sum = Vec3::Zero();
    for (const EndGraph::Link& link : graph.links[node]) {
      const auto other = static_cast<size_t>(link.node);
      if (!decided[other]) continue;
      sum += carried_along(draft.drawn[static_cast<size_t>(link.rod)], before[other], !link.forward);
    }
    if (sum.norm() > 1e-6) normals[node] = sum.normalized();
  }
}

}  // namespace

void set_joint_normals(Draft& draft) {
  draft.joint_normals.assign(draft.structure.nodes.size(), Vec3::Zero());
  bool any = false;
  for (const Rod& rod : draft.model.rods) any = any || rod.axes.kind == MaterialAxes::Kind::kJoints;
  if (!any) return;
  const EndGraph graph = end_graph(draft);
  std::vector<Vec3> normals = unsigned_normals(draft, graph);
  std::vector<char> decided(normals.size()), done(normals.size(), 0);
  for (size_t n = 0; n < normals.size(); ++n) decided[n] = normals[n] != Vec3::Zero();
  for (const bool want_decided : {true, false}) {
    for (size_t n = 0; n < normals.size(); ++n) {
      if (done[n] || graph.links[n].empty() || decided[n] != want_decided) continue;
      const auto rod = static_cast<size_t>(graph.links[n].front().rod);
      const Vec3& wish = draft.model.rods[rod].axes.normal;
      normals[n] =
          want_decided ? oriented(normals[n], wish) : frame_from_normal(draft.drawn[rod].edge_tangents[0], wish).n;
      propagate(draft, graph, n, decided, normals, done);
    }
  }
  average_undecided(draft, graph, decided, normals);
  draft.joint_normals = std::move(normals);
}

}  // namespace lissom
