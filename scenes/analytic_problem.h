#pragma once
/// Reduced problems in closed form, with their solutions, for tests and yardsticks of the methods of inverse design.

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "lissom/design/reduced_problem.h"

namespace lissom {

/// Functions f(x) with first derivatives and sum_i w_i f_i''.
struct SmoothFunctions {
  std::function<VecX(const VecX&)> value;
  std::function<MatX(const VecX&)> jacobian;
  std::function<MatX(const VecX&, const VecX&)> curvature;
};

/// How often what was asked for at different points.
struct AskedFor {
  int attempts = 0, gradients = 0, grams = 0, products = 0;
};

class AnalyticProblem final : public ReducedProblem {
 public:
  AnalyticProblem(SmoothFunctions r, VecX start, VecX lower, VecX upper)
      : r_(std::move(r)), x_(std::move(start)), lower_(std::move(lower)), upper_(std::move(upper)) {
    settle();
  }

  /// What becomes of attempts at `x` from `from`; all settle by default.
  std::function<Outcome(const VecX& from, const VecX& x)> fate;
  /// Changes the value that attempts report, to make them lie.
  std::function<double(const VecX& x, double value)> spoil;
  /// Called at every attempt.
  std::function<void()> on_attempt;
  AskedFor asked;

  void set_constraints(SmoothFunctions c, std::vector<bool> inequality) {
    c_ = std::move(c);
    inequality_ = std::move(inequality);
    set_multipliers(VecX::Zero(constraints()), 1);
  }
  /// As a session does that brings back a saved design.
  void put_at(const VecX& x) {
    x_ = x;
    settle();
  }

  int size() const override { return static_cast<int>(x_.size()); }
  const VecX& lower() const override { return lower_; }
  const VecX& upper() const override { return upper_; }
  const VecX& x() const override { return x_; }
  double value() const override { return 0.5 * residual_.squaredNorm(); }
  const VecX& residual() const override { return residual_; }

  const VecX& gradient() override {
    if (gradient_.size() == 0) {
      ++asked.gradients;
      gradient_ = jacobian().transpose() * residual_;
    }
    return gradient_;
  }
  const MatX& gram() override {
    if (gram_.size() == 0) {
      ++asked.grams;
      gram_ = jacobian().transpose() * jacobian();
    }
    return gram_;
  }
  VecX jacobian_times(const VecX& v) override { return jacobian() * v; }
  VecX jacobian_transposed_times(const VecX& w) override { return jacobian().transpose() * w; }
  VecX hessian_times(const VecX& v) override {
    ++asked.products;
    const int n = static_cast<int>(r_.value(x_).size()), k = constraints();
    VecX image = jacobian().transpose() * (jacobian() * v) + r_.curvature(x_, residual_.head(n)) * v;
    if (k > 0) image += std::sqrt(penalty_) * (c_.curvature(x_, residual_.tail(k)) * v);
    return image;
  }

  Attempt attempt(const VecX& x) override {
    ++asked.attempts;
    if (on_attempt) on_attempt();
    if (fate) {
      const Outcome outcome = fate(x_, x);
      if (outcome != Outcome::kSettled) return {outcome, 0, "as the test wants it"};
    }
    attempted_ = x;
    attempted_residual_ = residual_at(x);
    const double value = 0.5 * attempted_residual_.squaredNorm();
    return {Outcome::kSettled, spoil ? spoil(x, value) : value, {}};
  }
  const VecX& attempted_residual() const override { return attempted_residual_; }
  void accept() override {
    x_ = attempted_;
    settle();
  }

  int constraints() const override { return static_cast<int>(inequality_.size()); }
  VecX constraint_values() const override { return constraints() > 0 ? c_.value(x_) : VecX(); }
  bool is_inequality(int i) const override { return inequality_[i]; }
  void set_multipliers(const VecX& multipliers, double penalty) override {
    multipliers_ = multipliers;
    penalty_ = penalty;
    settle();
  }

  DesignEffort effort() const override { return {asked.attempts, asked.attempts, 0, asked.gradients}; }

  MatX jacobian() const {
    MatX j = r_.jacobian(x_);
    const int n = static_cast<int>(j.rows()), k = constraints();
    if (k == 0) return j;
    MatX all(n + k, size());
    all.topRows(n) = j;
    all.bottomRows(k) = std::sqrt(penalty_) * c_.jacobian(x_);
    for (int i = 0; i < k; ++i) {
      if (residual_[n + i] == 0 && inequality_[i]) all.row(n + i).setZero();
    }
    return all;
  }

 private:
  VecX residual_at(const VecX& x) const {
    const VecX r = r_.value(x);
    const int n = static_cast<int>(r.size()), k = constraints();
    if (k == 0) return r;
    VecX all(n + k);
    all.head(n) = r;
    all.tail(k) = std::sqrt(penalty_) * (c_.value(x) + multipliers_ / penalty_);
    for (int i = 0; i < k; ++i) {
      if (inequality_[i]) all[n + i] = std::max(all[n + i], 0.0);
    }
    return all;
  }
  void settle() {
    residual_ = residual_at(x_);
    gradient_.resize(0);
    gram_.resize(0, 0);
  }

  SmoothFunctions r_, c_;
  std::vector<bool> inequality_;
  VecX multipliers_;
  double penalty_ = 1;
  VecX x_, lower_, upper_, residual_, gradient_, attempted_, attempted_residual_;
  MatX gram_;
};

inline VecX boundless(int m, double sign) { return VecX::Constant(m, sign * std::numeric_limits<double>::infinity()); }

inline SmoothFunctions linear_functions(const MatX& a, const VecX& b) {
  return {[a, b](const VecX& x) -> VecX { return a * x - b; }, [a](const VecX&) { return a; },
          [](const VecX& x, const VecX&) -> MatX { return MatX::Zero(x.size(), x.size()); }};
}

}  // namespace lissom
