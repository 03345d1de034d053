#pragma once
/// Multifrontal LDL' of a sparse symmetric matrix with pivots of one row each, in the order of a plan.

#include <atomic>
#include <span>
#include <vector>

#include "lissom/core/multifrontal_kernels.h"
#include "lissom/core/multifrontal_plan.h"
#include "lissom/core/parallel.h"
#include "lissom/core/types.h"

namespace lissom::multifrontal {

class Factor {
 public:
  /// The pool, which may be null, has to live as long as the factor.
  Factor(Plan plan, ThreadPool* threads);

  const Plan& plan() const { return plan_; }

  /// Factorises the matrix with these values (of the full pattern) plus shift * metric on the diagonal. There is a
  /// factor unless the result says broken.
  PivotCount factorize(std::span<const double> values, double shift, std::span<const double> metric,
                       OnNegative on_negative);

  /// b and x have one entry per unknown, in the order of the matrix. x may be b.
  void solve(const double* b, double* x) const;
  /// The same for any number of columns that stand one after the other.
  void solve_many(const double* b, double* x, int columns) const;

 private:
  /// The matrix, and what a factorisation does with it.
  struct Task {
    std::span<const double> values;
    double shift;
    std::span<const double> metric;
    OnNegative on_negative;
  };
  void assemble(int f, const Task& task);
  void eliminate(int f, const Task& task, double* scratch, PivotCount& count);
  void eliminate_part(int p, const Task& task, double* scratch);
  void solve_block(const double* b, double* x, int columns) const;

  Plan plan_;
  ThreadPool* threads_;
  VecX factor_;      // panels
  VecX reciprocal_;  // of the pivots
  VecX updates_;
  VecX scratch_;
  std::vector<PivotCount> counts_;  // of the parts
  std::atomic<int> broken_part_{0};
  mutable VecX work_;  // right-hand sides in the order of elimination, row by row
  mutable VecX rows_;  // of one front
};

}  // namespace lissom::multifrontal
