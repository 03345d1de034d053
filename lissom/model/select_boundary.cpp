#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "lissom/model/select_parts.h"

namespace lissom {

namespace {

/// Edges of the network without dead branches, and the drawn nodes in the best-fit plane.
struct PlaneGraph {
  std::vector<Vec2> place;
  std::vector<std::vector<int>> neighbours;
};

std::vector<Vec2> projected(const Structure& s) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : s.nodes) middle += p;
  middle /= double(s.nodes.size());
  Mat3 moments = Mat3::Zero();
  for (const Vec3& p : s.nodes) moments += (p - middle) * (p - middle).transpose();
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(moments);
  std::vector<Vec2> place;
  place.reserve(s.nodes.size());
  for (const Vec3& p : s.nodes) {
    place.emplace_back(eigen.eigenvectors().col(2).dot(p - middle), eigen.eigenvectors().col(1).dot(p - middle));
  }
  return place;
}

PlaneGraph pruned_graph(const Structure& s) {
  PlaneGraph graph{projected(s), {}};
  graph.neighbours.resize(s.nodes.size());
  for (const StructureEdge& edge : s.edges) {
    graph.neighbours[static_cast<size_t>(edge.node0)].push_back(edge.node1);
    graph.neighbours[static_cast<size_t>(edge.node1)].push_back(edge.node0);
  }
  std::vector<int> dead;
  for (size_t i = 0; i < graph.neighbours.size(); ++i) {
    auto& list = graph.neighbours[i];
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    if (list.size() == 1) dead.push_back(static_cast<int>(i));
  }
  while (!dead.empty()) {
    const int node = dead.back();
    dead.pop_back();
    auto& list = graph.neighbours[static_cast<size_t>(node)];
    if (list.size() != 1) continue;
    auto& other = graph.neighbours[static_cast<size_t>(list[0])];
    other.erase(std::find(other.begin(), other.end(), node));
    if (other.size() == 1) dead.push_back(list[0]);
    list.clear();
  }
  return graph;
}

/// The neighbour first met when turning counter-clockwise from the direction `back` at a node.
int next_around(const PlaneGraph& graph, int node, const Vec2& back, int came_from) {
  int best = -1;
  double least = 0;
  for (int other : graph.neighbours[static_cast<size_t>(node)]) {
    const Vec2 d = graph.place[static_cast<size_t>(other)] - graph.place[static_cast<size_t>(node)];
    double angle = std::atan2(back.x() * d.y() - back.y() * d.x(), back.dot(d));
    if (angle <= 0 || other == came_from) angle += 2 * std::numbers::pi;
    if (best < 0 || angle < least) {
      best = other;
      least = angle;
    }
  }
  return best;
}

/// Marks the outer face of the part that holds `start`, its leftmost node (lowest of equals).
void walk_outside(const PlaneGraph& graph, int start, size_t most_steps, std::vector<char>& on_loop) {
  const int first = next_around(graph, start, Vec2(-1, 0), -1);
  int from = start, to = first;
  for (size_t step = 0; step < most_steps; ++step) {
    on_loop[static_cast<size_t>(from)] = 1;
    const Vec2 back = graph.place[static_cast<size_t>(from)] - graph.place[static_cast<size_t>(to)];
    const int next = next_around(graph, to, back, from);
    from = std::exchange(to, next);
    if (from == start && to == first) return;
  }
}

}  // namespace

std::vector<int> count_passages(const Structure& s) {
  std::vector<int> passages(s.nodes.size(), 0);
  for (const StructureRod& rod : s.rods) {
    for (int node : rod.nodes) ++passages[static_cast<size_t>(node)];
  }
  return passages;
}

std::vector<int> boundary_nodes(const Structure& s) {
  const PlaneGraph graph = pruned_graph(s);
  const auto parts = static_cast<size_t>(s.components);
  std::vector<int> leftmost(parts, -1);
  for (size_t i = 0; i < s.nodes.size(); ++i) {
    if (graph.neighbours[i].empty()) continue;
    int& best = leftmost[static_cast<size_t>(s.component[i])];
    if (best < 0) best = static_cast<int>(i);
    const Vec2 &p = graph.place[i], &q = graph.place[static_cast<size_t>(best)];
    if (p.x() < q.x() || (p.x() == q.x() && p.y() < q.y())) best = static_cast<int>(i);
  }
  std::vector<char> on_loop(s.nodes.size(), 0);
  for (int start : leftmost) {
    if (start >= 0) walk_outside(graph, start, 2 * s.edges.size() + 2, on_loop);
  }
  const std::vector<int> passages = count_passages(s);
  std::vector<char> corner(s.nodes.size(), 0), free_end(s.nodes.size(), 0), has_corner(parts, 0);
  for (const StructureRod& rod : s.rods) {
    if (rod.closed) continue;
    for (int node : {rod.nodes.front(), rod.nodes.back()}) {
      corner[static_cast<size_t>(node)] = 1;
      free_end[static_cast<size_t>(node)] = passages[static_cast<size_t>(node)] == 1;
    }
  }
  for (size_t i = 0; i < s.nodes.size(); ++i) {
    corner[i] = corner[i] || passages[i] > 1;
    if (on_loop[i] && corner[i]) has_corner[static_cast<size_t>(s.component[i])] = 1;
  }
  std::vector<int> nodes;
  for (size_t i = 0; i < s.nodes.size(); ++i) {
    const auto part = static_cast<size_t>(s.component[i]);
    const bool loop = leftmost[part] >= 0;
    const bool taken = loop ? on_loop[i] && (corner[i] || !has_corner[part]) : free_end[i] != 0;
    if (taken) nodes.push_back(static_cast<int>(i));
  }
  return nodes;
}

}  // namespace lissom
