#pragma once
/// Sparse symmetric factorisation of one pattern, many times. The only place that knows which library does it.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "lissom/core/sparse_pattern.h"
#include "lissom/core/types.h"

namespace lissom {

enum class Ordering {
  kBest,
  kAmd,
  kMetis
};  ///< kBest: AMD, or METIS where AMD is dear and METIS counts fewer operations
enum class FactorKind {
  kBest,
  kLdl,
  kCholesky
};  ///< LDL' (simplicial, gives inertia); LL' (supernodal, stops at a bad pivot)

struct LinearSolverOptions {
  Ordering ordering = Ordering::kBest;
  FactorKind kind = FactorKind::kBest;  ///< kBest: LDL' for narrow matrices such as rod networks, LL' for wide ones
};

/// What a factorisation found out about the matrix.
struct FactorReport {
  bool complete = false;  ///< the factor exists and can be used to solve
  bool positive_definite = false;
  int negative_pivots = -1;  ///< number of negative eigenvalues; -1 when the kind of factor cannot tell
  int failed_at = -1;        ///< first index (of the full matrix) at which it stopped or met a pivot <= 0; -1 if none
};

/// Analysed once for the rows and columns of `pattern` that are kept, then factorised again and again. LDL' allocates
/// nothing after the first factorisation and the first solve of each width; LL' asks for small work blocks inside the
/// library.
///
/// Runs on the calling thread alone, whatever the environment says: the libraries' own threads cost more than they
/// bring at these sizes. To that end the first solver sets OpenBLAS, for the whole process, to one thread. Different
/// solvers may be used in different threads at once; one solver may not, not even its const members, which share work
/// space.
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
  FactorReport factorize(std::span<const double> values, double shift = 0, std::span<const double> metric = {});

  /// Solves with the last complete factor. b and x have one entry (row) per unknown; x may be b.
  void solve(const VecX& b, VecX& x) const;
  /// Takes blocks of 32 columns, which costs less per column than `solve`.
  void solve_many(const MatX& b, MatX& x) const;

  struct Statistics {
    double factor_flops = 0;  ///< counted for the ordering in use
    std::int64_t factor_nonzeros = 0;
    Ordering ordering = Ordering::kAmd;
    FactorKind kind = FactorKind::kLdl;
  };
  const Statistics& statistics() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lissom
