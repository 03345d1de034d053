#pragma once
/// What every Newton-type method on a static problem shares: assembly, factor, residual, buffers. One per solve.

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/core/linear_solver.h"
#include "lissom/equilibrium/static_problem.h"

namespace lissom {

class NewtonWorkspace {
 public:
  NewtonWorkspace(const StaticProblem& problem, const Context& context);

  const StaticProblem& problem() const { return problem_; }
  const System& system() const { return *problem_.system; }
  const Context& context() const { return context_; }

  /// Shows every state that a solve has arrived at, on the thread that solves. `watch` must be quick; empty: nobody looks.
  using Watch = std::function<void(const State& state, double residual)>;
  void set_watch(Watch watch) { watch_ = std::move(watch); }
  void show(const State& state, double residual) const {
    if (watch_) watch_(state, residual);
  }

  LinearSolver& factor() { return factor_; }
  /// For evaluations of other potentials between those of this one: nothing is kept in them.
  AssemblyBuffers& buffers() { return buffers_; }
  int factorizations() const { return factorizations_; }

  double energy(const State& state);
  /// Gradient and Hessian at a state, kept until the next call.
  void assemble(const State& state);
  /// Gradient only; leaves the Hessian of the last assembly.
  void gradient(const State& state, VecX& local);

  const VecX& local_gradient() const { return gradient_; }  ///< all unknowns, local axes
  const VecX& free_gradient() const { return free_gradient_; }
  const std::vector<double>& hessian() const { return hessian_; }
  /// Diagonal with the mean |H_ii| of each class of unknowns: the metric of shifts, per free unknown.
  const VecX& metric() const { return metric_; }
  /// Its entry for one class.
  double class_metric(DofClass c) const { return class_mean_[static_cast<size_t>(c)]; }

  /// Factorises the last Hessian + shift * metric.
  FactorReport factorize(double shift, Indefinite indefinite = Indefinite::kFactorise);
  /// Whether the last factor was that of a positive definite Hessian without shift, of this or an earlier state.
  bool has_plain_factor() const { return plain_factor_; }
  /// The same with another diagonal, one entry per free unknown.
  FactorReport factorize_with(double shift, std::span<const double> diagonal,
                              Indefinite indefinite = Indefinite::kFactorise);

  /// y = H x for free unknowns.
  void multiply_free(const VecX& x, VecX& y);

  /// Largest force, or moment over L0, on a free unknown of a gradient over the free ones, N.
  double residual(const VecX& free_gradient) const;
  double residual() const { return residual(free_gradient_); }

  /// d of the free unknowns as an increment of all, in global axes.
  void to_increment(const VecX& free, VecX& increment) const;

 private:
  const StaticProblem& problem_;
  const Context& context_;
  Watch watch_;
  LinearSolver factor_;
  AssemblyBuffers buffers_;
  std::vector<double> hessian_;
  VecX gradient_, free_gradient_, metric_, local_x_, local_y_;
  std::vector<int> diagonal_;        // per free unknown: its place among the values
  std::array<int, 3> class_size_{};  // free positions, rolls, joint rotations
  std::array<double, 3> class_mean_{1, 1, 1};
  int factorizations_ = 0;
  bool plain_factor_ = false;
};

}  // namespace lissom
