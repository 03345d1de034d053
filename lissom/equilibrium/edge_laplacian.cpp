#include "lissom/equilibrium/edge_laplacian.h"

namespace lissom {

EdgeLaplacian::EdgeLaplacian(const StaticProblem& problem) : problem_(problem) {
  const System& system = *problem.system;
  std::vector<int> groups, offsets{0};
  for (const StructureEdge& edge : system.structure.edges) {
    for (const int node : {edge.node0, edge.node1}) {
      for (int i = 0; i < 3; ++i) groups.push_back(3 * node + i);
    }
    offsets.push_back(static_cast<int>(groups.size()));
  }
  positions_ = 3 * system.layout.nodes();
  const SparsePattern pattern(positions_, groups, offsets);
  // Held unknowns are along local axes; turn the blocks there.
  std::vector<Mat3> axes(system.layout.nodes(), Mat3::Identity());
  for (const LocalAxes& local : problem.potential.local_axes()) {
    if (local.first_dof < positions_) axes[local.first_dof / 3] = local.axes;
  }
  values_.assign(pattern.nonzeros(), 0);
  for (int e = 0; e < system.edge_count(); ++e) {
    const StructureEdge& edge = system.structure.edges[e];
    const double w = 1 / system.rest.edges[e].length;
    weights_.push_back(w);
    const Mat3 mixed = -w * axes[edge.node1].transpose() * axes[edge.node0];
    for (int i = 0; i < 3; ++i) {
      values_[pattern.diagonal_slot(3 * edge.node0 + i)] += w;
      values_[pattern.diagonal_slot(3 * edge.node1 + i)] += w;
      for (int j = 0; j < 3; ++j) values_[pattern.slot(3 * edge.node1 + i, 3 * edge.node0 + j)] += mixed(i, j);
    }
  }
  // A touch of anchoring where supports leave the positions undetermined.
  for (int i = 0; i < positions_; ++i) values_[pattern.diagonal_slot(i)] *= 1 + 1e-9;
  kept_.assign(positions_, -1);
  int unknowns = 0;
  for (int i = 0; i < positions_; ++i) {
    if (problem.supports.kept()[i] < 0) continue;
    kept_[i] = unknowns++;
    metric_.push_back(system.rest.node_length[i / 3]);
  }
  b_.resize(unknowns);
  if (unknowns > 0) solver_.emplace(pattern, kept_);
}

bool EdgeLaplacian::factorize(double pull) {
  return solver_ && solver_->factorize(values_, pull, metric_).positive_definite;
}

void EdgeLaplacian::solve(const VecX& right_side, VecX& positions) {
  work_ = right_side;
  problem_.potential.to_local(work_);
  for (int i = 0; i < positions_; ++i) {
    if (kept_[i] >= 0) b_[kept_[i]] = work_[i];
  }
  solver_->solve(b_, b_);
  positions.setZero(right_side.size());
  for (int i = 0; i < positions_; ++i) {
    if (kept_[i] >= 0) positions[i] = b_[kept_[i]];
  }
  problem_.potential.to_global(positions);
}

}  // namespace lissom
