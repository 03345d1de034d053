#include "lissom/equilibrium/shift.h"

#include <algorithm>
#include <cmath>

namespace lissom {

namespace {

constexpr double kSmallest = 1e-9;
constexpr double kFirst = 1e-7;     // tried when nothing is known
constexpr double kGrowth = 10;      // after a failure
constexpr double kFall = 0.1;       // least share of the last shift that is tried next
constexpr double kAboveFailed = 3;  // of what was not enough at this step, at least so much is tried at the next
constexpr int kSubspace = 2;
constexpr int kSteps = 6;  // of subspace iteration: an estimate that is too low costs a factorisation that fails

}  // namespace

double ShiftPolicy::first_shift() const {
  if (worked_ == 0) return kFirst;
  return std::max(0.1 * worked_, std::min(10 * worked_, kFirst));
}

bool ShiftPolicy::factorize(NewtonWorkspace& workspace) {
  shift_ = next_;
  failed_ = 0;
  for (int attempt = 0; attempt < 40; ++attempt) {
    if (workspace.factorize(shift_, Indefinite::kStop).positive_definite) {
      if (shift_ > 0) worked_ = shift_;
      return true;
    }
    failed_ = shift_;
    // What was needed last is a better guess than any constant.
    shift_ = shift_ > 0 ? kGrowth * shift_ : first_shift();
  }
  return false;
}

void ShiftPolicy::learn(NewtonWorkspace& workspace) {
  negative_ = 0;
  if (rule_ == ShiftRule::kRemembered) {
    next_ = shift_ / kGrowth > kSmallest ? shift_ / kGrowth : 0;
    return;
  }
  if (shift_ == 0) {
    next_ = 0;
    return;
  }
  const double lowest = estimate_lowest(workspace);
  negative_ = std::min(lowest, 0.0);
  // With a shift far above what is needed the estimate cannot tell small eigenvalues apart: do not fall to 0 at once.
  next_ = std::max({lowest < 0 ? -1.3 * lowest : 0, kFall * shift_, kAboveFailed * failed_});
  if (next_ < kSmallest) next_ = 0;
}

double ShiftPolicy::estimate_lowest(NewtonWorkspace& workspace) {
  const VecX& metric = workspace.metric();
  const int n = static_cast<int>(metric.size());
  const int k = std::min(kSubspace, n);
  if (vectors_.rows() != n || vectors_.cols() != k) {
    // Deterministic start that has a part of everything.
    vectors_.resize(n, k);
    for (int j = 0; j < k; ++j) {
      for (int i = 0; i < n; ++i) vectors_(i, j) = std::sin(1.0 + 0.37 * i * (j + 1) + 0.11 * j) / std::sqrt(metric[i]);
    }
  }
  for (int step = 0; step < kSteps; ++step) {
    for (int j = 0; j < k; ++j) {
      work_ = metric.cwiseProduct(vectors_.col(j));
      workspace.factor().solve(work_, work_);
      for (int i = 0; i < j; ++i) {
        work_ -= vectors_.col(i) * vectors_.col(i).cwiseProduct(metric).dot(work_);
      }
      const double norm = std::sqrt(work_.cwiseProduct(metric).dot(work_));
      if (!(norm > 0) || !std::isfinite(norm)) {
        vectors_.resize(0, 0);
        return 0;
      }
      vectors_.col(j) = work_ / norm;
    }
  }
  Eigen::Matrix<double, kSubspace, kSubspace> small = Eigen::Matrix<double, kSubspace, kSubspace>::Identity() * 1e300;
  for (int j = 0; j < k; ++j) {
    work_ = vectors_.col(j);
    workspace.multiply_free(work_, image_);
    for (int i = 0; i < k; ++i) small(i, j) = vectors_.col(i).dot(image_);
  }
  if (k == 1) return small(0, 0);
  const double mean = 0.5 * (small(0, 0) + small(1, 1)), half = 0.5 * (small(0, 0) - small(1, 1));
  const double mixed = 0.5 * (small(0, 1) + small(1, 0));
  return mean - std::hypot(half, mixed);
}

}  // namespace lissom
