#include "lissom/design/sensitivity.h"

#include <utility>

#include "lissom/core/assert.h"
#include "lissom/core/sparse_pattern.h"
#include "lissom/mechanics/gradient_by_rest.h"
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

/// One matrix above the other; `below` may have no columns.
SparseMatrix stacked(const SparseMatrix& above, const SparseMatrix& below) {
  if (below.cols() == 0) return above;
  std::vector<Eigen::Triplet<double>> entries;
  for (const SparseMatrix* part : {&above, &below}) {
    const Eigen::Index first = part == &below ? above.rows() : 0;
    for (int c = 0; c < part->outerSize(); ++c) {
      for (SparseMatrix::InnerIterator it(*part, c); it; ++it) {
        entries.emplace_back(static_cast<int>(first + it.row()), static_cast<int>(it.col()), it.value());
      }
    }
  }
  SparseMatrix all(above.rows() + below.rows(), above.cols());
  all.setFromTriplets(entries.begin(), entries.end());
  return all;
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
  if (Status s = check_supports(pose); !s) return s.error();
  const System& system = *problem.system;
  LISSOM_ASSERT(factor.unknowns() == problem.supports.unknowns());
  Sensitivity result;
  result.problem_ = &problem;
  result.factor_ = &factor;
  const int m = static_cast<int>(jacobian.inputs.cols());
  SparseMatrix numbers = rest_jacobian(model, system) * jacobian.inputs;
  if (jacobian.numbers.cols() > 0) numbers += jacobian.numbers;
  result.numbers_ = stacked(numbers, own.loads);
  result.by_numbers_ = gradient_by_rest(problem.potential, equilibrium, static_cast<int>(result.numbers_.rows()));
  result.forces_ = result.by_numbers_ * result.numbers_;

  VecX gradient;
  AssemblyBuffers buffers;
  problem.potential.hessian(equilibrium, gradient, result.hessian_, buffers);
  const SparseMatrix places = problem.supports.held_by_places(system);
  if (places.nonZeros() > 0) {
    result.held_ = places * SparseMatrix(jacobian.inputs.topRows(3 * system.layout.nodes()));
  }
  if (own.held.cols() > 0) {
    if (result.held_.cols() == 0) result.held_.resize(system.layout.size(), m);
    result.held_ += equilibrium.load_factor * own.held;
  }
  if (result.held_.cols() > 0) result.forces_ += held_columns(problem, result.hessian_) * result.held_;
  return result;
}

VecX Sensitivity::back_solve(const VecX& w) const {
  VecX free, local;
  problem_->supports.restrict(w, free);
  factor_->solve(free, free);
  problem_->supports.expand(free, local);
  return local;
}

VecX Sensitivity::hessian_times(const VecX& w) const {
  VecX y;
  multiply(problem_->potential.pattern(), hessian_, w, y);
  return y;
}

VecX Sensitivity::forward(const VecX& v) const {
  VecX local = back_solve(-(forces_ * v));
  if (held_.cols() > 0) local += held_ * v;
  problem_->potential.to_global(local);
  return local;
}

VecX Sensitivity::adjoint(const VecX& w) const {
  VecX local = w;
  problem_->potential.to_local(local);
  VecX result = -(forces_.transpose() * back_solve(local));
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
  factor_->solve_many(right, free);
  MatX all(problem_->system->layout.size(), parameters());
  VecX local;
  for (int j = 0; j < parameters(); ++j) {
    problem_->supports.expand(free.col(j), local);
    if (held_.cols() > 0) local += held_.col(j);
    problem_->potential.to_global(local);
    all.col(j) = local;
  }
  return all;
}

}  // namespace lissom
