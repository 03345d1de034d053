#include "lissom/design/sensitivity.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "lissom/core/assert.h"
#include "lissom/core/sparse_pattern.h"
#include "lissom/geometry/frame.h"
#include "lissom/mechanics/gradient_by_rest.h"
#include "lissom/mechanics/load_numbers.h"
#include "lissom/mechanics/loads.h"
#include "lissom/mechanics/rest_jacobian.h"

namespace lissom {

namespace {

/// Whether the places that a pose holds follow those of the drawing and nothing else.
Status check_supports(const Pose& pose) {
  for (const Support& support : pose.supports) {
    const bool moved =
        support.shrink != 0 || support.move_inwards || support.turn_angle != 0 || !support.deform.isIdentity(0);
    if (!moved) continue;
    return Error{ErrorCode::kUnsupported, "pose \"" + pose.name + "\"",
                 "a support moves by an amount that depends on the drawing; its sensitivity is not known",
                 "move supports by fixed amounts"};
  }
  return {};
}

int columns_of(const DesignJacobian& jacobian, const PoseJacobian& own) {
  Eigen::Index m = 0;
  for (const SparseMatrix* part : {&jacobian.inputs, &jacobian.numbers, &own.loads, &own.held}) {
    LISSOM_ASSERT(m == 0 || part->cols() == 0 || part->cols() == m);
    m = std::max(m, part->cols());
  }
  return static_cast<int>(m);
}

void append(const SparseMatrix& part, Eigen::Index first, std::vector<Eigen::Triplet<double>>& entries) {
  for (int c = 0; c < part.outerSize(); ++c) {
    for (SparseMatrix::InnerIterator it(part, c); it; ++it) {
      entries.emplace_back(static_cast<int>(first + it.row()), static_cast<int>(it.col()), it.value());
    }
  }
}

/// The Hessian as a sparse matrix, columns of held unknowns alone.
SparseMatrix held_columns(const StaticProblem& problem, const std::vector<double>& hessian) {
  const SparsePattern& pattern = problem.potential.pattern();
  const std::span<const int> kept = problem.supports.kept();
  std::vector<Eigen::Triplet<double>> entries;
  for (int column = 0; column < pattern.size(); ++column) {
    for (int slot = pattern.column_start()[column]; slot < pattern.column_start()[column + 1]; ++slot) {
      const int row = pattern.row()[slot];
      if (kept[column] < 0) entries.emplace_back(row, column, hessian[slot]);
      if (row != column && kept[row] < 0) entries.emplace_back(column, row, hessian[slot]);
    }
  }
  SparseMatrix matrix(pattern.size(), pattern.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

Result<Sensitivity> Sensitivity::make(const Model& model, const Pose& pose, const StaticProblem& problem,
                                      const State& equilibrium, const LinearSolver& factor,
                                      const SparseMatrix& inputs) {
  DesignJacobian jacobian;
  jacobian.inputs = inputs;
  return make(model, pose, problem, equilibrium, factor, jacobian, {});
}

Result<Sensitivity> Sensitivity::make(const Model& model, int pose, const StaticProblem& problem,
                                      const State& equilibrium, const LinearSolver& factor,
                                      const DesignJacobian& jacobian) {
  const auto p = static_cast<std::size_t>(pose);
  return make(model, model.poses[p], problem, equilibrium, factor, jacobian,
              jacobian.poses.empty() ? PoseJacobian{} : jacobian.poses[p]);
}

Result<Sensitivity> Sensitivity::make(const Model& model, const Pose& pose, const StaticProblem& problem,
                                      const State& equilibrium, const LinearSolver& factor,
                                      const DesignJacobian& jacobian, const PoseJacobian& own) {
  const System& system = *problem.system;
  LISSOM_ASSERT(factor.unknowns() == problem.supports.unknowns());
  const int unknowns = system.layout.size(), places = 3 * system.layout.nodes(), m = columns_of(jacobian, own);
  SparseMatrix drawn(places, m);
  if (jacobian.inputs.cols() > 0) drawn = jacobian.inputs.topRows(places);
  if (drawn.nonZeros() > 0) {
    if (Status s = check_supports(pose); !s) return s.error();
  }
  Sensitivity result;
  result.problem_ = &problem;
  result.factor_ = &factor;
  result.set_moments(pose, equilibrium);
  const RestNumbers rest(system.structure);
  const LoadNumbers loads(pose, system.structure);
  std::vector<Eigen::Triplet<double>> entries;
  if (jacobian.inputs.cols() > 0) append(rest_jacobian(model, system) * jacobian.inputs, 0, entries);
  append(jacobian.numbers, 0, entries);
  append(own.loads, rest.size(), entries);
  if (loads.has_drawn_targets()) append(drawn, rest.size() + loads.size() - places, entries);
  result.numbers_.resize(rest.size() + loads.size(), m);
  result.numbers_.setFromTriplets(entries.begin(), entries.end());
  result.by_numbers_ = gradient_by_rest(problem.potential, equilibrium, rest.size() + loads.size());
  result.forces_ = result.by_numbers_ * result.numbers_;

  VecX gradient;
  AssemblyBuffers buffers;
  problem.potential.hessian(equilibrium, gradient, result.hessian_, buffers);
  SparseMatrix held(unknowns, m);
  if (drawn.nonZeros() > 0) held = problem.supports.held_by_places(system) * drawn;
  if (own.held.cols() > 0) held += equilibrium.load_factor * own.held;
  if (held.nonZeros() > 0) {
    result.forces_ += held_columns(problem, result.hessian_) * held;
    result.held_ = std::move(held);
  }
  return result;
}

void Sensitivity::set_moments(const Pose& pose, const State& equilibrium) {
  if (pose.moments.empty()) return;
  // Moments on each unknown: they are linear in the unknowns, so that their gradient is what they are.
  const System& system = *problem_->system;
  VecX moment = VecX::Zero(system.layout.size());
  for (const auto& term : problem_->potential.terms()) {
    if (term->name() != JointMoment::kName) continue;
    const int dofs = term->dofs();
    std::vector<double> blocks(static_cast<std::size_t>(term->groups()) * kLanes * dofs);
    term->derivatives(equilibrium, 0, term->groups(), blocks.data(), nullptr);
    for (int k = 0; k < term->stencils() * dofs; ++k) moment[term->indices()[k]] -= blocks[static_cast<std::size_t>(k)];
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < system.joint_count(); ++j) {
    const int r = system.layout.rotation(j);
    if (r < 0 || moment.segment<3>(r).isZero(0)) continue;
    // The gradient of all else is the moment. Turned by u it changes by H u + u x moment / 2 [Baker, Campbell, Hausdorff].
    Mat3 block = -0.5 * skew(moment.segment<3>(r));
    for (const LocalAxes& local : problem_->supports.local_axes()) {
      if (local.first_dof == r) block = local.axes.transpose() * block * local.axes;
    }
    std::array<int, 3> column{-1, -1, -1};
    for (int i = 0; i < 3; ++i) {
      const int free = problem_->supports.kept()[r + i];
      if (free < 0) continue;
      column[i] = static_cast<int>(turned_.size());
      turned_.push_back(free);
    }
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        if (column[a] >= 0 && column[b] >= 0) entries.emplace_back(column[a], column[b], block(a, b));
      }
    }
  }
  const auto count = static_cast<Eigen::Index>(turned_.size());
  skew_ = MatX::Zero(count, count);
  for (const auto& entry : entries) skew_(entry.row(), entry.col()) = entry.value();
  MatX units = MatX::Zero(problem_->supports.unknowns(), count);
  for (int k = 0; k < count; ++k) units(turned_[static_cast<std::size_t>(k)], k) = 1;
  if (count > 0) factor_->solve_many(units, reach_);
}

void Sensitivity::solve(VecX& x, Side side) const {
  factor_->solve(x, x);
  if (turned_.empty()) return;
  // Woodbury: N has few rows, and its transpose is its negative.
  const MatX n = side == Side::kForward ? skew_ : MatX(-skew_);
  const auto count = static_cast<Eigen::Index>(turned_.size());
  MatX small(count, count);
  VecX here(count);
  for (int k = 0; k < count; ++k) {
    small.row(k) = reach_.row(turned_[static_cast<std::size_t>(k)]);
    here[k] = x[turned_[static_cast<std::size_t>(k)]];
  }
  const VecX turn = (MatX::Identity(count, count) + small * n).partialPivLu().solve(here);
  x -= reach_ * (n * turn);
}

VecX Sensitivity::back_solve(const VecX& w, Side side) const {
  VecX free, local;
  problem_->supports.restrict(w, free);
  solve(free, side);
  problem_->supports.expand(free, local);
  return local;
}

VecX Sensitivity::hessian_times(const VecX& w) const {
  VecX y;
  multiply(problem_->potential.pattern(), hessian_, w, y);
  return y;
}

VecX Sensitivity::forward(const VecX& v) const {
  VecX local = back_solve(-(forces_ * v), Side::kForward);
  if (held_.cols() > 0) local += held_ * v;
  problem_->potential.to_global(local);
  return local;
}

VecX Sensitivity::adjoint(const VecX& w) const {
  VecX local = w;
  problem_->potential.to_local(local);
  VecX result = -(forces_.transpose() * back_solve(local, Side::kTransposed));
  if (held_.cols() > 0) result += held_.transpose() * local;
  return result;
}

MatX Sensitivity::dense() const {
  MatX right = MatX::Zero(problem_->supports.unknowns(), parameters()), free;
  const std::span<const int> kept = problem_->supports.kept();
  for (int j = 0; j < forces_.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator it(forces_, j); it; ++it) {
      if (kept[it.row()] >= 0) right(kept[it.row()], j) = -it.value();
    }
  }
  if (turned_.empty()) factor_->solve_many(right, free);
  MatX all(problem_->system->layout.size(), parameters());
  VecX column, local;
  for (int j = 0; j < parameters(); ++j) {
    if (turned_.empty()) {
      column = free.col(j);
    } else {
      column = right.col(j);
      solve(column, Side::kForward);
    }
    problem_->supports.expand(column, local);
    if (held_.cols() > 0) local += held_.col(j);
    problem_->potential.to_global(local);
    all.col(j) = local;
  }
  return all;
}

}  // namespace lissom
