#pragma once
/// Sparse symmetric factorisation of one pattern, many times. The only place that knows how it is done.

#include <cstdint>
#include <memory>
#include <span>

#include "lissom/core/parallel.h"
#include "lissom/core/sparse_pattern.h"
#include "lissom/core/types.h"

namespace lissom {

enum class Ordering {
  kBest,
  kAmd,
  kMetis
};  ///< kBest: AMD, or METIS where AMD is dear and METIS promises a faster factorisation

struct LinearSolverOptions {
  Ordering ordering = Ordering::kBest;
  ThreadPool* threads = nullptr;  ///< for factorisations, of the solver's life time; null: on the calling thread
};

/// What becomes of a matrix that is not positive definite.
enum class Indefinite {
  kFactorise,  ///< to the end, for its inertia and for solves
  kStop        ///< at the first pivot < 0, which costs less than a factor
};

/// What a factorisation found out about the matrix.
struct FactorReport {
  bool complete = false;  ///< the factor exists and can be used to solve
  bool positive_definite = false;
  int negative_pivots = -1;  ///< number of negative eigenvalues; -1 when the factorisation stopped
  int failed_at = -1;        ///< first index (of the full matrix) at which it stopped or met a pivot <= 0; -1 if none
};

/// Analysed once for the rows and columns of `pattern` that are kept, then factorised as LDL' again and again. Nothing is
/// allocated after the first factorisation and the first solve of the greatest width.
///
/// The results are the same bytes for any number of threads. Different solvers may be used in different threads at once
/// (but not with one pool); one solver may not, not even its const members, which share work space.
class LinearSolver {
 public:
  /// `kept[i]` >= 0 numbers the unknowns; rows and columns with a negative entry are left out (fixed DoFs).
  /// The numbers are 0, 1, 2, ... in ascending order of i.
  LinearSolver(const SparsePattern& pattern, std::span<const int> kept, const LinearSolverOptions& options = {});
  ~LinearSolver();
  LinearSolver(LinearSolver&&) noexcept;
  LinearSolver& operator=(LinearSolver&&) noexcept;

  int unknowns() const;

  /// Factorises K + shift * diag(metric), K = the kept part of the matrix with these values (full pattern).
  /// `metric` has one entry per unknown; it may be empty when shift is 0. Numbers that are not finite, singular
  /// matrices and overflow end in an incomplete report. Same values, same bits.
  FactorReport factorize(std::span<const double> values, double shift = 0, std::span<const double> metric = {},
                         Indefinite indefinite = Indefinite::kFactorise);

  /// Solves with the last complete factor. b and x have one entry (row) per unknown; x may be b.
  void solve(const VecX& b, VecX& x) const;
  /// Takes blocks of columns, which costs less per column than `solve`.
  void solve_many(const MatX& b, MatX& x) const;

  struct Statistics {
    double factor_flops = 0;  ///< counted for the ordering in use
    std::int64_t factor_nonzeros = 0;
    Ordering ordering = Ordering::kAmd;
  };
  const Statistics& statistics() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lissom
