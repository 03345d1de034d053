#include "lissom/equilibrium/newton_workspace.h"

#include <array>
#include <cmath>

namespace lissom {

NewtonWorkspace::NewtonWorkspace(const StaticProblem& problem, const Context& context, FactorKind kind)
    : problem_(problem),
      context_(context),
      factor_(problem.potential.pattern(), problem.supports.kept(), {.kind = kind}) {
  const std::span<const int> kept = problem.supports.kept();
  class_of_.reserve(problem.supports.unknowns());
  for (int i = 0; i < static_cast<int>(kept.size()); ++i) {
    if (kept[i] >= 0) class_of_.push_back(static_cast<int>(system().layout.dof_class(i)));
  }
  metric_ = VecX::Ones(problem.supports.unknowns());
}

double NewtonWorkspace::energy(const State& state) {
  return problem_.potential.value(state, buffers_, context_.threads);
}

void NewtonWorkspace::assemble(const State& state) {
  problem_.potential.hessian(state, gradient_, hessian_, buffers_, context_.threads);
  problem_.supports.restrict(gradient_, free_gradient_);
  std::array<double, 3> sum{}, count{};
  const std::span<const int> kept = problem_.supports.kept();
  for (int i = 0; i < static_cast<int>(kept.size()); ++i) {
    if (kept[i] < 0) continue;
    const int c = class_of_[kept[i]];
    sum[c] += std::abs(hessian_[problem_.potential.pattern().diagonal_slot(i)]);
    count[c] += 1;
  }
  for (int i = 0; i < metric_.size(); ++i) {
    const int c = class_of_[i];
    metric_[i] = sum[c] > 0 ? sum[c] / count[c] : 1;
  }
}

void NewtonWorkspace::gradient(const State& state, VecX& local) {
  problem_.potential.gradient(state, local, buffers_, context_.threads);
}

FactorReport NewtonWorkspace::factorize(double shift) {
  return factorize_with(shift, std::span<const double>(metric_.data(), metric_.size()));
}

FactorReport NewtonWorkspace::factorize_with(double shift, std::span<const double> diagonal) {
  ++factorizations_;
  return factor_.factorize(hessian_, shift, diagonal);
}

void NewtonWorkspace::multiply_free(const VecX& x, VecX& y) {
  problem_.supports.expand(x, local_x_);
  multiply(problem_.potential.pattern(), hessian_, local_x_, local_y_);
  problem_.supports.restrict(local_y_, y);
}

double NewtonWorkspace::residual(const VecX& free_gradient) const {
  double force = 0, moment = 0;
  for (int i = 0; i < free_gradient.size(); ++i) {
    const double f = std::abs(free_gradient[i]);
    if (!(f <= 1e300)) return INFINITY;
    (class_of_[i] == 0 ? force : moment) = std::max(class_of_[i] == 0 ? force : moment, f);
  }
  return std::max(force, moment / system().rest.mean_edge_length);
}

void NewtonWorkspace::to_increment(const VecX& free, VecX& increment) const {
  problem_.supports.expand(free, increment);
  problem_.potential.to_global(increment);
}

}  // namespace lissom
