#include "lissom/equilibrium/block_relaxation.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "lissom/mechanics/membrane_bend.h"

namespace lissom {

namespace {

constexpr double kLeastShift = 1e-6, kMostShift = 1e3, kShiftGrowth = 16, kShiftFall = 64;
constexpr double kMostTurn = 0.5;  // rad, of a roll or joint rotation in one step
constexpr double kEnergyNoise = 1e-13;
constexpr double kSlight = 1e-2;  // of the least stiffness of a rod's bend: what rods next to a fold do not notice
constexpr double kServes = 0.03;  // of the forces before a step: where no more are left its factor serves once more

/// Whether membranes fold so easily that their bending need not be in the matrix of the rods: it stays in their balance and in
/// the energies, and is the dearest block of all to find and to add.
bool folds_easily(const RestState& rest) {
  double fold = 0, rod = INFINITY;
  for (const HingeRest& hinge : rest.hinges) fold = std::max(fold, hinge.stiffness);
  for (const PairRest& pair : rest.pairs) rod = std::min(rod, std::min(pair.bend_1, pair.bend_2) / pair.length);
  return fold < kSlight * rod;
}

}  // namespace

BlockRelaxer::BlockRelaxer(NewtonWorkspace& workspace, const std::vector<bool>& takes_part,
                           const std::vector<bool>& can_move)
    : workspace_(workspace), folds_easily_(folds_easily(workspace.system().rest)) {
  const DofLayout& layout = workspace.system().layout;
  const Potential& whole = workspace.problem().potential;
  kept_.assign(layout.size(), -1);
  for (int i = 0; i < layout.size(); ++i) {
    if (can_move[i]) ++movable_;
    if (takes_part[i] && can_move[i]) {
      kept_[i] = unknowns_++;
      dof_.push_back(i);
      if (layout.dof_class(i) == DofClass::kPosition) ++positions_;
    }
  }
  if (!useful()) return;
  // Local axes mix three unknowns: what touches one of them touches all.
  touched_ = takes_part;
  for (const LocalAxes& axes : whole.local_axes()) {
    const bool any = takes_part[axes.first_dof] || takes_part[axes.first_dof + 1] || takes_part[axes.first_dof + 2];
    for (int i = 0; i < 3; ++i) touched_[axes.first_dof + i] = any;
  }
  potential_.emplace(whole.dofs(), touching_terms(),
                     std::vector<LocalAxes>(whole.local_axes().begin(), whole.local_axes().end()), touched_);
  factor_.emplace(potential_->pattern(), kept_, LinearSolverOptions{.threads = workspace.context().threads});
  g_.resize(unknowns_);
  metric_.resize(unknowns_);
}

std::vector<std::unique_ptr<EnergyTerm>> BlockRelaxer::touching_terms() const {
  std::vector<std::unique_ptr<EnergyTerm>> terms;
  for (const auto& term : workspace_.problem().potential.terms()) {
    std::unique_ptr<EnergyTerm> part =
        term->touching(touched_, !(folds_easily_ && term->name() == MembraneBend::kName));
    if (part->stencils() > 0) terms.push_back(std::move(part));
  }
  return terms;
}

void BlockRelaxer::renew_terms() {
  if (potential_) potential_->replace_terms(touching_terms());
}

bool BlockRelaxer::relax(State& state, int steps, double shift, double tolerance, Crumpled crumpled) {
  if (!useful()) return false;
  bool changed = false;
  double energy = 0;  // of the part at the state
  double added = 0;   // to the shift, where the matrix needed it
  double last = INFINITY;
  bool serves = false;  // the factor of the step before, once more
  for (int u = 0; u < unknowns_; ++u)
    metric_[u] = workspace_.class_metric(workspace_.system().layout.dof_class(dof_[u]));
  for (int k = 0; k < steps; ++k) {
    if (k > 0) {  // often the last step was enough, and a gradient tells
      potential_->gradient(state, gradient_, workspace_.buffers(), workspace_.context().threads);
      if (!(residual() > tolerance)) return changed;
      serves = residual() < kServes * last;
    }
    if (!serves) potential_->hessian(state, gradient_, hessian_, workspace_.buffers(), workspace_.context().threads);
    last = residual();
    if (!(last > tolerance)) return changed;
    for (int u = 0; u < unknowns_; ++u) g_[u] = gradient_[dof_[u]];
    if (!serves && !factorize(shift, added, crumpled)) return changed;
    d_ = -g_;
    factor_->solve(d_, d_);
    if (!d_.allFinite()) return changed;
    if (k == 0) energy = potential_->value(state, workspace_.buffers(), workspace_.context().threads);
    if (!descend(state, g_.dot(d_), energy)) return changed;
    changed = true;
  }
  return changed;
}

bool BlockRelaxer::factorize(double shift, double& added, Crumpled crumpled) {
  const std::span<const double> metric(metric_.data(), static_cast<size_t>(unknowns_));
  added = added > kLeastShift ? added / kShiftFall : 0;
  while (!factor_->factorize(hessian_, shift + added, metric, Indefinite::kStop).positive_definite) {
    if (crumpled == Crumpled::kLeave) return false;
    added = std::max(kShiftGrowth * added, kLeastShift);
    if (added > kMostShift) return false;
  }
  return true;
}

double BlockRelaxer::residual() const {
  double force = 0, moment = 0;
  for (int u = 0; u < positions_; ++u) force = std::max(force, std::abs(gradient_[dof_[u]]));
  for (int u = positions_; u < unknowns_; ++u) moment = std::max(moment, std::abs(gradient_[dof_[u]]));
  return std::max(force, moment / workspace_.system().rest.mean_edge_length);
}

bool BlockRelaxer::descend(State& state, double slope, double& energy) {
  const double turn = positions_ < unknowns_ ? d_.tail(unknowns_ - positions_).cwiseAbs().maxCoeff() : 0;
  double a = turn > kMostTurn ? kMostTurn / turn : 1;
  step_.setZero(static_cast<int>(kept_.size()));
  for (int u = 0; u < unknowns_; ++u) step_[dof_[u]] = d_[u];
  potential_->to_global(step_);
  for (int attempt = 0; attempt < 3; ++attempt, a *= 0.4) {
    increment_ = a * step_;
    if (!advance(workspace_.system(), state, increment_, moved_, workspace_.context().threads)) continue;
    const double after = potential_->value(moved_, workspace_.buffers(), workspace_.context().threads);
    if (after <= energy + 1e-4 * a * slope + kEnergyNoise * std::abs(energy)) {
      energy = after;
      std::swap(state, moved_);
      return true;
    }
  }
  return false;
}

std::vector<bool> frame_unknowns(const System& system) {
  std::vector<bool> part(system.layout.size(), false);
  for (int i = 3 * system.layout.nodes(); i < system.layout.size(); ++i) part[i] = true;
  return part;
}

std::vector<bool> rod_unknowns(const System& system) {
  std::vector<bool> part = frame_unknowns(system);
  for (const StructureEdge& edge : system.structure.edges) {
    for (const int node : {edge.node0, edge.node1}) {
      for (int i = 0; i < 3; ++i) part[3 * node + i] = true;
    }
  }
  return part;
}

}  // namespace lissom
