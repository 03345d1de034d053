#include "lissom/equilibrium/length_fit.h"

#include <algorithm>
#include <cmath>

namespace lissom {

namespace {

constexpr double kStiff = 1e5;        // kappa: strain counts this much more than the place
constexpr double kAnchor = 3e-3;      // pull of every node to its place in the trial, times 1 / l
constexpr double kMostStrain = 0.02;  // by which a step may change the strain of an edge
constexpr int kSteps = 8;
constexpr double kAlmost = 3e-4;  // of an edge length: the next step, the square of this, would be rounding to a rod

}  // namespace

LengthFit::LengthFit(const StaticProblem& problem, const std::vector<bool>& can_move, ThreadPool* threads)
    : problem_(problem), follow_(problem, can_move) {
  const System& system = *problem.system;
  const int positions = 3 * system.layout.nodes();
  std::vector<int> groups, offsets{0};
  std::vector<bool> on_rod(system.layout.nodes(), false);
  for (const StructureEdge& edge : system.structure.edges) {
    for (const int node : {edge.node0, edge.node1}) {
      on_rod[node] = true;
      for (int i = 0; i < 3; ++i) groups.push_back(3 * node + i);
    }
    offsets.push_back(static_cast<int>(groups.size()));
  }
  const SparsePattern pattern(positions, groups, offsets);
  for (const StructureEdge& edge : system.structure.edges) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        if (j <= i) {
          slots_.push_back(pattern.slot(3 * edge.node0 + i, 3 * edge.node0 + j));
          slots_.push_back(pattern.slot(3 * edge.node1 + i, 3 * edge.node1 + j));
        }
        slots_.push_back(pattern.slot(3 * edge.node1 + i, 3 * edge.node0 + j));
      }
    }
  }
  axes_.assign(system.layout.nodes(), Mat3::Identity());
  turned_.assign(system.layout.nodes(), false);
  for (const LocalAxes& local : problem.potential.local_axes()) {
    if (local.first_dof >= positions) continue;
    axes_[local.first_dof / 3] = local.axes;
    turned_[local.first_dof / 3] = true;
  }
  kept_.assign(positions, -1);
  int unknowns = 0;
  for (int i = 0; i < positions; ++i) {
    if (on_rod[i / 3] && can_move[i]) kept_[i] = unknowns++;
  }
  b_.resize(unknowns);
  metric_.assign(unknowns, 1 / system.rest.mean_edge_length);
  values_.resize(pattern.nonzeros());
  trial_.resize(system.structure.edges.size());
  edge_.resize(system.structure.edges.size());
  target_.resize(system.structure.edges.size());
  if (unknowns > 0) solver_.emplace(pattern, kept_, LinearSolverOptions{.threads = threads});
}

bool LengthFit::mend(const State& state, double a, const VecX& d, std::span<const double> arrival, VecX& increment) {
  if (!solver_) return true;
  const System& system = *problem_.system;
  const auto edge_of = [&](const VecX& q, int e) -> Vec3 {
    const StructureEdge& edge = system.structure.edges[e];
    return q.segment<3>(3 * edge.node1) - q.segment<3>(3 * edge.node0);
  };
  for (int e = 0; e < system.edge_count(); ++e) {
    const EdgeState& now = state.edges[e];
    const double rest = system.rest.edges[e].length, strain = now.length / rest - 1;
    target_[e] = arrival.empty() ? strain + std::clamp(a * now.t.dot(edge_of(d, e)) / rest, -kMostStrain, kMostStrain)
                                 : strain + a * (arrival[e] - strain);
    trial_[e] = now.length * now.t + edge_of(increment, e);
  }
  mended_.setZero(increment.size());  // on top of the trial, global axes
  const double pull = kAnchor / system.rest.mean_edge_length;
  for (int step = 0; step < kSteps; ++step) {
    std::fill(values_.begin(), values_.end(), 0.0);
    force_ = -pull * mended_;
    const int* slot = slots_.data();
    for (int e = 0; e < system.edge_count(); ++e) {
      const StructureEdge& edge = system.structure.edges[e];
      const double rest = system.rest.edges[e].length;
      const Vec3 change = edge_of(mended_, e), now = trial_[e] + change;
      const double length = now.norm();
      if (!(length > 0.1 * rest)) return false;
      const Vec3 t = now / length;
      const Vec3 f = change / rest + kStiff * (length / rest - 1 - target_[e]) * t;
      force_.segment<3>(3 * edge.node1) -= f;
      force_.segment<3>(3 * edge.node0) += f;
      const Mat3 k = (Mat3::Identity() + kStiff * t * t.transpose()) / rest;
      Mat3 k00 = k, k11 = k, k10 = -k;
      if (turned_[edge.node0] || turned_[edge.node1]) {
        const Mat3 &a0 = axes_[edge.node0], &a1 = axes_[edge.node1];
        k00 = a0.transpose() * k * a0;
        k11 = a1.transpose() * k * a1;
        k10 = -(a1.transpose() * k * a0);
      }
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          if (j <= i) {
            values_[*slot++] += k00(i, j);
            values_[*slot++] += k11(i, j);
          }
          values_[*slot++] += k10(i, j);
        }
      }
    }
    if (!solver_->factorize(values_, kAnchor, metric_).positive_definite) return false;
    problem_.potential.to_local(force_);
    for (size_t i = 0; i < kept_.size(); ++i) {
      if (kept_[i] >= 0) b_[kept_[i]] = force_[static_cast<int>(i)];
    }
    solver_->solve(b_, b_);
    work_.setZero(increment.size());
    for (size_t i = 0; i < kept_.size(); ++i) {
      if (kept_[i] >= 0) work_[static_cast<int>(i)] = b_[kept_[i]];
    }
    problem_.potential.to_global(work_);
    mended_ += work_;
    if (b_.cwiseAbs().maxCoeff() < kAlmost * system.rest.mean_edge_length) break;
  }
  follow_.spread(mended_);
  increment += mended_;
  return increment.allFinite();
}

}  // namespace lissom
