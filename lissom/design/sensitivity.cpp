#include "lissom/design/sensitivity.h"

#include <utility>

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

}  // namespace

Result<Sensitivity> Sensitivity::make(const Model& model, const Pose& pose, const StaticProblem& problem,
                                      const State& equilibrium, const LinearSolver& factor,
                                      const SparseMatrix& inputs) {
  if (Status s = check_supports(pose); !s) return s.error();
  const System& system = *problem.system;
  LISSOM_ASSERT(factor.unknowns() == problem.supports.unknowns());
  Sensitivity result;
  result.problem_ = &problem;
  result.factor_ = &factor;
  const int unknowns = system.layout.size(), m = static_cast<int>(inputs.cols());
  const SparseMatrix by_rest = gradient_by_rest(problem.potential, equilibrium, RestNumbers(system.structure).size());
  const SparseMatrix by_inputs = by_rest * rest_jacobian(model, system);
  result.by_parameters_ = by_inputs * inputs;

  MatX forces = result.by_parameters_;
  const SparseMatrix places = problem.supports.held_by_places(system);
  if (places.nonZeros() > 0) {
    result.held_ = places * inputs.topRows(3 * system.layout.nodes());
    VecX gradient, column, product;
    std::vector<double> hessian;
    AssemblyBuffers buffers;
    problem.potential.hessian(equilibrium, gradient, hessian, buffers);
    for (int j = 0; j < m; ++j) {
      column = result.held_.col(j);
      multiply(problem.potential.pattern(), hessian, column, product);
      forces.col(j) += product;
    }
  }
  result.right_.resize(problem.supports.unknowns(), m);
  for (int i = 0; i < unknowns; ++i) {
    const int free = problem.supports.kept()[i];
    if (free >= 0) result.right_.row(free) = -forces.row(i);
  }
  return result;
}

VecX Sensitivity::forward(const VecX& v) const {
  VecX free = right_ * v, local;
  factor_->solve(free, free);
  problem_->supports.expand(free, local);
  if (held_.cols() > 0) local += held_ * v;
  problem_->potential.to_global(local);
  return local;
}

VecX Sensitivity::adjoint(const VecX& w) const {
  VecX local = w, free;
  problem_->potential.to_local(local);
  problem_->supports.restrict(local, free);
  factor_->solve(free, free);
  VecX result = right_.transpose() * free;
  if (held_.cols() > 0) result += held_.transpose() * local;
  return result;
}

MatX Sensitivity::dense() const {
  MatX free, all(problem_->system->layout.size(), parameters());
  factor_->solve_many(right_, free);
  VecX column, local;
  for (int j = 0; j < parameters(); ++j) {
    column = free.col(j);
    problem_->supports.expand(column, local);
    if (held_.cols() > 0) local += held_.col(j);
    problem_->potential.to_global(local);
    all.col(j) = local;
  }
  return all;
}

}  // namespace lissom
