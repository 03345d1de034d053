#include "lissom/equilibrium/membrane_follow.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace lissom {

namespace {

/// Weights below this share of an equilateral triangle's would let a vertex overtake its neighbours.
constexpr double kLeastWeight = 0.05;

/// Half the cotangent of the corner at `c` in the triangle a, b, c.
double half_cotangent(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = a - c, v = b - c;
  return 0.5 * u.dot(v) / u.cross(v).norm();
}

}  // namespace

MembraneFollow::MembraneFollow(const StaticProblem& problem, const std::vector<bool>& can_move)
    : problem_(problem), can_move_(can_move) {
  const Structure& structure = problem.system->structure;
  std::vector<bool> on_rod(structure.nodes.size(), false), on_membrane(structure.nodes.size(), false);
  for (const StructureEdge& edge : structure.edges) on_rod[edge.node0] = on_rod[edge.node1] = true;
  std::map<std::pair<int, int>, double> weight;
  for (const StructureTriangle& triangle : structure.triangles) {
    for (int i = 0; i < 3; ++i) {
      const int a = triangle.node[i], b = triangle.node[(i + 1) % 3], c = triangle.node[(i + 2) % 3];
      on_membrane[a] = true;
      weight[{std::min(a, b), std::max(a, b)}] +=
          half_cotangent(structure.nodes[a], structure.nodes[b], structure.nodes[c]);
    }
  }
  number_.assign(structure.nodes.size(), -1);
  for (size_t i = 0; i < number_.size(); ++i) {
    if (on_membrane[i] && !on_rod[i]) number_[i] = following_++;
  }
  if (following_ == 0) return;
  std::vector<int> groups, offsets{0};
  for (const auto& [ends, w] : weight) {
    sides_.push_back({ends.first, ends.second, std::max(w, kLeastWeight)});
    for (const int node : {ends.first, ends.second}) groups.push_back(node);
    offsets.push_back(static_cast<int>(groups.size()));
  }
  const SparsePattern pattern(static_cast<int>(structure.nodes.size()), groups, offsets);
  std::vector<double> values(pattern.nonzeros(), 0);
  for (const Side& side : sides_) {
    values[pattern.diagonal_slot(side.a)] += side.weight;
    values[pattern.diagonal_slot(side.b)] += side.weight;
    values[pattern.slot(side.a, side.b)] -= side.weight;
  }
  solver_.emplace(pattern, number_);
  // A membrane without any rod has no edge to follow: it stays.
  if (!solver_->factorize(values).positive_definite) solver_.reset();
  b_.resize(following_, 3);
}

void MembraneFollow::spread(VecX& displacement) {
  if (!solver_) return;
  b_.setZero();
  for (const Side& side : sides_) {
    const auto pull = [&](int from, int to) {
      if (number_[to] >= 0 && number_[from] < 0) {
        b_.row(number_[to]) += side.weight * displacement.segment<3>(3 * from).transpose();
      }
    };
    pull(side.a, side.b);
    pull(side.b, side.a);
  }
  solver_->solve_many(b_, b_);
  for (size_t i = 0; i < number_.size(); ++i) {
    if (number_[i] >= 0) displacement.segment<3>(3 * static_cast<int>(i)) = b_.row(number_[i]).transpose();
  }
  problem_.potential.to_local(displacement);
  for (size_t i = 0; i < number_.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      double& u = displacement[3 * static_cast<int>(i) + k];
      if (!can_move_[3 * i + k]) u = 0;
    }
  }
  problem_.potential.to_global(displacement);
}

}  // namespace lissom
