#include "lissom/design/free_factor.h"

#include <algorithm>
#include <limits>

namespace lissom {

namespace {

constexpr double kLeastDamping = 1e-10, kDampingGrowth = 10;  // of the largest diagonal entry
constexpr int kFewest = 8;  // held parameters are eliminated as long as they are fewer than one of so many

}  // namespace

bool FreeFactor::eliminate(const std::vector<int>& free) {
  if (!any_ || !std::includes(factored_.begin(), factored_.end(), free.begin(), free.end())) return false;
  const int n = static_cast<int>(factored_.size()), held = n - static_cast<int>(free.size());
  if (held * kFewest > n) return false;
  held_.clear();
  for (int i = 0, next = 0; i < n; ++i) {
    if (next < static_cast<int>(free.size()) && free[next] == factored_[i]) {
      ++next;
    } else {
      held_.push_back(i);
    }
  }
  held_images_ = MatX::Zero(n, held);
  if (held == 0) return true;
  for (int k = 0; k < held; ++k) held_images_(held_[k], k) = 1;
  llt_.matrixL().solveInPlace(held_images_);
  held_llt_.compute(held_images_.transpose() * held_images_);
  return held_llt_.info() == Eigen::Success;
}

void FreeFactor::prepare(const MatX& b, const std::vector<int>& free, double largest) {
  if (eliminate(free)) return;
  any_ = true;
  factored_ = free;
  held_.clear();
  const int n = static_cast<int>(free.size());
  // A pivot at the level of rounding is noise: what it would give as a step is noise, and as large as it is small.
  const double least_pivot = 4 * n * std::numeric_limits<double>::epsilon() * largest;
  part_.resize(n, n);
  for (;;) {
    for (int j = 0; j < n; ++j) {
      for (int i = j; i < n; ++i) part_(i, j) = b(free[i], free[j]);
      part_(j, j) += damping_;
    }
    llt_.compute(part_);  // reads the lower triangle
    ++factorizations_;
    if (llt_.info() == Eigen::Success && (n == 0 || llt_.matrixLLT().diagonal().cwiseAbs2().minCoeff() > least_pivot)) {
      return;
    }
    damping_ = std::max(kDampingGrowth * damping_, kLeastDamping * largest);
  }
}

VecX FreeFactor::solve(const VecX& right) const {
  const int n = static_cast<int>(factored_.size());
  VecX part(n);
  for (int i = 0; i < n; ++i) part[i] = right[factored_[i]];
  for (const int i : held_) part[i] = 0;
  llt_.matrixL().solveInPlace(part);
  if (!held_.empty()) part -= held_images_ * held_llt_.solve(held_images_.transpose() * part);
  llt_.matrixU().solveInPlace(part);
  for (const int i : held_) part[i] = 0;
  VecX x = VecX::Zero(right.size());
  for (int i = 0; i < n; ++i) x[factored_[i]] = part[i];
  return x;
}

}  // namespace lissom
