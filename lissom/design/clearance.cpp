#include "lissom/design/clearance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "lissom/mechanics/rest_numbers.h"

namespace lissom {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Where the segments a0 a1 and b0 b1 are nearest [Ericson 2005, 5.1.9], 0 to 1 along each.
std::array<double, 2> nearest_places(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  const Vec3 u = a1 - a0, v = b1 - b0, w = a0 - b0;
  const double a = u.squaredNorm(), b = u.dot(v), c = v.squaredNorm(), d = u.dot(w), e = v.dot(w);
  const double denominator = a * c - b * b;
  double s = denominator > 1e-12 * a * c ? std::clamp((b * e - c * d) / denominator, 0.0, 1.0) : 0.5;
  const double t = std::clamp((b * s + e) / c, 0.0, 1.0);
  s = std::clamp((b * t - d) / a, 0.0, 1.0);
  return {s, t};
}

/// Ways along the rods.
class Ways {
 public:
  explicit Ways(const Structure& structure) : structure_(structure), along_(structure.edges.size(), 0) {
    for (const StructureRod& rod : structure.rods) {
      double way = 0;
      for (const int e : rod.edges) {
        along_[at(e)] = way;
        way += length(e);
      }
      lengths_.push_back(way);
      if (rod.closed) continue;
      const auto [a, b] = std::minmax(rod.nodes.front(), rod.nodes.back());
      const auto [entry, fresh] = between_.emplace(std::pair(a, b), way);
      if (!fresh) entry->second = std::min(entry->second, way);
    }
  }

  bool meet(int r, int s) const {
    for (const int a : ends(r)) {
      for (const int b : ends(s)) {
        if (a == b) return true;
      }
    }
    return false;
  }

  /// m, from a place on an edge to one on an edge of another rod, over a single rod between; infinite where there is none.
  double way(const EdgePair& pair) const {
    const int r = structure_.edges[at(pair.edge0)].rod, s = structure_.edges[at(pair.edge1)].rod;
    const std::array<double, 2> from = to_ends(r, pair.edge0, pair.at0), to = to_ends(s, pair.edge1, pair.at1);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) {
        const auto [a, b] = std::minmax(ends(r)[i], ends(s)[j]);
        const auto found = between_.find({a, b});
        if (found != between_.end()) least = std::min(least, from[i] + found->second + to[j]);
      }
    }
    return least;
  }

 private:
  double length(int e) const {
    const StructureEdge& edge = structure_.edges[at(e)];
    return (structure_.nodes[at(edge.node1)] - structure_.nodes[at(edge.node0)]).norm();
  }
  std::array<int, 2> ends(int r) const {
    const StructureRod& rod = structure_.rods[at(r)];
    return {rod.nodes.front(), rod.nodes.back()};
  }
  std::array<double, 2> to_ends(int r, int e, double place) const {
    const double from = along_[at(e)] + place * length(e);
    return {from, lengths_[at(r)] - from};
  }

  const Structure& structure_;
  std::vector<double> along_, lengths_;            // m, to the start of each edge on its rod; of each rod
  std::map<std::pair<int, int>, double> between_;  // m, of the shortest rod between two nodes
};

/// Cells as wide as `within` and what is in them: partners are in the same or a neighbouring one.
class Neighbours {
 public:
  Neighbours(const std::vector<Vec3>& points, double width) : width_(width) {
    for (std::size_t i = 0; i < points.size(); ++i) cells_[cell(points[i])].push_back(static_cast<int>(i));
  }
  template <class Visit>
  void visit(const Vec3& x, const Visit& visit) const {
    const std::array<int, 3> own = cell(x);
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) {
        for (int k = -1; k <= 1; ++k) {
          const auto found = cells_.find({own[0] + i, own[1] + j, own[2] + k});
          if (found == cells_.end()) continue;
          for (const int other : found->second) visit(other);
        }
      }
    }
  }

 private:
  std::array<int, 3> cell(const Vec3& x) const {
    const Vec3 c = (x / width_).array().floor();
    return {static_cast<int>(c[0]), static_cast<int>(c[1]), static_cast<int>(c[2])};
  }

  double width_;
  std::map<std::array<int, 3>, std::vector<int>> cells_;
};

/// Where the parameters may bring edges from where they are drawn: how thin and thick they get and how far they move, m.
struct Reach {
  double least = std::numeric_limits<double>::infinity(), extent = 0, move = 0;
};

Reach reach_of(const Structure& structure, std::span<const Parameter> parameters) {
  Reach reach;
  for (const StructureEdge& edge : structure.edges) {
    reach.least = std::min({reach.least, edge.section.r_n, edge.section.r_b});
    reach.extent = std::max({reach.extent, edge.section.r_n, edge.section.r_b});
  }
  for (const Parameter& p : parameters) {
    if (p.kind == ParameterKind::kRadius) {
      reach.least = std::min(reach.least, p.lower);
      reach.extent = std::max(reach.extent, p.upper);
    }
    if (p.kind == ParameterKind::kDisplacement) reach.move = std::max({reach.move, p.upper, -p.lower});
  }
  return reach;
}

}  // namespace

std::vector<EdgePair> edges_side_by_side(const Structure& structure, double within, double least_extent) {
  const Ways ways(structure);
  std::vector<Vec3> middles;
  double longest = 0;
  for (const StructureEdge& edge : structure.edges) {
    const Vec3 &x0 = structure.nodes[at(edge.node0)], &x1 = structure.nodes[at(edge.node1)];
    middles.push_back(0.5 * (x0 + x1));
    longest = std::max(longest, (x1 - x0).norm());
  }
  const Neighbours near(middles, within + longest);
  std::vector<EdgePair> pairs;
  for (int e = 0; e < static_cast<int>(structure.edges.size()); ++e) {
    const StructureEdge& own = structure.edges[at(e)];
    std::map<int, EdgePair> nearest;  // by rod
    near.visit(middles[at(e)], [&](int f) {
      const StructureEdge& other = structure.edges[at(f)];
      if (other.rod == own.rod || ways.meet(own.rod, other.rod)) return;
      const std::array<const Vec3*, 4> x{&structure.nodes[at(own.node0)], &structure.nodes[at(own.node1)],
                                         &structure.nodes[at(other.node0)], &structure.nodes[at(other.node1)]};
      const std::array<double, 2> places = nearest_places(*x[0], *x[1], *x[2], *x[3]);
      const Vec3 across = *x[2] + places[1] * (*x[3] - *x[2]) - *x[0] - places[0] * (*x[1] - *x[0]);
      const double distance = across.norm();
      if (!(distance > 0) || distance > within) return;
      const EdgePair pair{e, f, places[0], places[1], across / distance, distance};
      if (ways.way(pair) <= kJointDetour * 2 * least_extent) return;
      const auto [entry, fresh] = nearest.emplace(other.rod, pair);
      if (!fresh && distance < entry->second.distance) entry->second = pair;
    });
    for (const auto& [rod, pair] : nearest) pairs.push_back(pair);
  }
  return pairs;
}

ParameterGoal make_clearance(const Design& base, const DesignSpace& space, double gap) {
  const Structure& structure = base.system.structure;
  const RestInputs inputs(structure);
  const Reach reach = reach_of(structure, space.parameters());
  // Rods that come nearer to each other by more than one of them may move are not watched.
  const double within = 2 * reach.extent + reach.move + gap;
  const std::vector<EdgePair> pairs = edges_side_by_side(structure, within, reach.least);
  std::vector<Eigen::Triplet<double>> entries;
  VecX drawn(static_cast<Eigen::Index>(pairs.size()));
  const VecX start = space.start();
  const Result<Design> first = space.at(start);
  const Structure& begun = first ? first.value().system.structure : structure;
  for (int row = 0; row < static_cast<int>(pairs.size()); ++row) {
    const EdgePair& pair = pairs[at(row)];
    Vec3 across = Vec3::Zero();
    double extents = 0;
    for (const int side : {0, 1}) {
      const int e = side == 0 ? pair.edge0 : pair.edge1;
      const StructureEdge& edge = begun.edges[at(e)];
      const double place = side == 0 ? pair.at0 : pair.at1, sign = side == 0 ? -1 : 1;
      for (const auto& [node, weight] : {std::pair(edge.node0, 1 - place), std::pair(edge.node1, place)}) {
        across += sign * weight * begun.nodes[at(node)];
        for (int k = 0; k < 3; ++k) {
          entries.emplace_back(row, 3 * node + k, sign * weight * pair.direction[k] / gap);
        }
      }
      const double n = std::abs(edge.drawn.n.dot(pair.direction)), b = std::abs(edge.drawn.b.dot(pair.direction));
      entries.emplace_back(row, inputs.extent_n(e), -n / gap);
      entries.emplace_back(row, inputs.extent_b(e), -b / gap);
      extents += n * edge.section.r_n + b * edge.section.r_b;
    }
    drawn[row] = (pair.direction.dot(across) - extents) / gap;
  }
  SparseMatrix by_inputs(static_cast<Eigen::Index>(pairs.size()), inputs.size());
  by_inputs.setFromTriplets(entries.begin(), entries.end());
  ParameterGoal wish;
  wish.name = "room between rods";
  wish.kind = GoalKind::kAtLeast;
  wish.rows = by_inputs * space.jacobian(first ? first.value() : base, start).inputs;
  wish.target = start;
  wish.level = VecX::Ones(drawn.size()) - drawn;
  return wish;
}

}  // namespace lissom
