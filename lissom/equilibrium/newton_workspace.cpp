#include "lissom/equilibrium/newton_workspace.h"

#include <algorithm>
#include <cmath>

namespace lissom {

NewtonWorkspace::NewtonWorkspace(const StaticProblem& problem, const Context& context)
    : problem_(problem),
      context_(context),
      factor_(problem.potential.pattern(), problem.supports.kept(), {.threads = context.threads}) {
  // Free unknowns keep the order of the layout, in which each class is one run.
  const std::span<const int> kept = problem.supports.kept();
  for (int i = 0; i < static_cast<int>(kept.size()); ++i) {
    if (kept[i] < 0) continue;
    diagonal_.push_back(problem.potential.pattern().diagonal_slot(i));
    ++class_size_[static_cast<int>(system().layout.dof_class(i))];
  }
  metric_ = VecX::Ones(problem.supports.unknowns());
}

double NewtonWorkspace::energy(const State& state) {
  return problem_.potential.value(state, buffers_, context_.threads);
}

void NewtonWorkspace::assemble(const State& state) {
  problem_.potential.hessian(state, gradient_, hessian_, buffers_, context_.threads);
  problem_.supports.restrict(gradient_, free_gradient_);
  int first = 0;
  for (size_t c = 0; c < class_size_.size(); ++c) {
    const int size = class_size_[c];
    double sum = 0;
    for (int i = first; i < first + size; ++i) sum += std::abs(hessian_[diagonal_[i]]);
    class_mean_[c] = sum > 0 ? sum / size : 1;
    metric_.segment(first, size).setConstant(class_mean_[c]);
    first += size;
  }
}

void NewtonWorkspace::gradient(const State& state, VecX& local) {
  problem_.potential.gradient(state, local, buffers_, context_.threads);
}

FactorReport NewtonWorkspace::factorize(double shift, Indefinite indefinite) {
  return factorize_with(shift, std::span<const double>(metric_.data(), metric_.size()), indefinite);
}

FactorReport NewtonWorkspace::factorize_with(double shift, std::span<const double> diagonal, Indefinite indefinite) {
  ++factorizations_;
  const FactorReport report = factor_.factorize(hessian_, shift, diagonal, indefinite);
  plain_factor_ = report.positive_definite && shift == 0;
  return report;
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
    double& largest = i < class_size_[0] ? force : moment;
    largest = std::max(largest, f);
  }
  return std::max(force, moment / system().rest.mean_edge_length);
}

void NewtonWorkspace::to_increment(const VecX& free, VecX& increment) const {
  problem_.supports.expand(free, increment);
  problem_.potential.to_global(increment);
}

}  // namespace lissom
