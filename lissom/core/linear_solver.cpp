/// CHOLMOD (Davis, Hager et al.; supernodal module GPL-2+) behind `LinearSolver`.
///
/// The matrix is permuted here once, pattern first, and CHOLMOD is told that its order is natural: the simplicial code
/// then reads the upper and the supernodal code the lower triangle as it stands, and a factorisation copies nothing but
/// the values. The permutation includes the postorder of the elimination tree, which supernodes need.
#include "lissom/core/linear_solver.h"

#include <algorithm>
#include <array>
#include <cholmod.h>
#include <cmath>
#include <limits>
#include <mutex>
#include <omp.h>
#include <utility>

#include "lissom/core/assert.h"

extern "C" {
int openblas_get_num_threads(void);
void openblas_set_num_threads(int count);
}

namespace lissom {

namespace {

/// Operations per unknown with AMD below which METIS is not asked: it takes 3 to 10 us per unknown, and gains nothing
/// on rod networks (8,000 operations per unknown at 430k unknowns: 375 ms against 357 for a factorisation) nor on small
/// membranes.
constexpr double kMetisWorthFlopsPerUnknown = 10000;
/// Operations per nonzero of the factor from which dense blocks beat indexed loops: at 36 (rod networks of 12k
/// unknowns) LDL' needs 0.7 of the time of LL', at 63 (a membrane full of rods, 10k) 1.2 to 1.6, at 73 (a membrane of 2.7k)
/// 1.4, at 110 (8k) 2 to 3 (bench/linear_solver_bench).
constexpr double kWideFlopsPerNonzero = 55;
/// Numbers of right-hand sides that are solved together, widest first. Each has workspaces of its own, because CHOLMOD
/// allocates them anew whenever their shape changes.
constexpr std::array<int, 4> kBlockColumns{32, 8, 4, 1};

/// Keeps CHOLMOD's own OpenMP loops on the calling thread while it lives: they start four threads for loops of
/// microseconds otherwise, whatever the environment asks for. The setting belongs to the calling thread alone.
class OneThread {
 public:
  OneThread() : levels_(omp_get_max_active_levels()) { omp_set_max_active_levels(0); }
  ~OneThread() { omp_set_max_active_levels(levels_); }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int levels_;
};

/// A triangle of a symmetric matrix by columns, rows ascending.
struct Triangle {
  std::vector<int> start;
  std::vector<int> row;
  std::vector<int> source;  ///< slot in the full pattern that each entry comes from

  cholmod_sparse view(int stype, double* values) {
    cholmod_sparse a{};
    a.nrow = a.ncol = start.size() - 1;
    a.nzmax = row.size();
    a.p = start.data();
    a.i = row.data();
    a.x = values;
    a.stype = stype;
    a.itype = CHOLMOD_INT;
    a.xtype = values == nullptr ? CHOLMOD_PATTERN : CHOLMOD_REAL;
    a.dtype = CHOLMOD_DOUBLE;
    a.sorted = 1;
    a.packed = 1;
    return a;
  }
};

/// Lower triangle of the kept rows and columns.
Triangle kept_part(const SparsePattern& pattern, std::span<const int> kept, int unknowns) {
  Triangle t;
  t.start.reserve(static_cast<std::size_t>(unknowns) + 1);
  t.start.push_back(0);
  for (int j = 0; j < pattern.size(); ++j) {
    if (kept[j] < 0) continue;
    for (int p = pattern.column_start()[j]; p < pattern.column_start()[j + 1]; ++p) {
      const int i = kept[pattern.row()[p]];
      if (i < 0) continue;
      t.row.push_back(i);
      t.source.push_back(p);
    }
    t.start.push_back(static_cast<int>(t.row.size()));
  }
  return t;
}

/// The transposed triangle; also sorts: the rows of the result ascend whatever the order in `t`.
Triangle transposed(const Triangle& t) {
  const int n = static_cast<int>(t.start.size()) - 1;
  Triangle r;
  r.start.assign(static_cast<std::size_t>(n) + 1, 0);
  r.row.resize(t.row.size());
  r.source.resize(t.row.size());
  for (const int i : t.row) ++r.start[i + 1];
  for (int i = 0; i < n; ++i) r.start[i + 1] += r.start[i];
  std::vector<int> fill(r.start.begin(), r.start.end() - 1);
  for (int j = 0; j < n; ++j) {
    for (int p = t.start[j]; p < t.start[j + 1]; ++p) {
      const int q = fill[t.row[p]]++;
      r.row[q] = j;
      r.source[q] = t.source[p];
    }
  }
  return r;
}

/// The same matrix in the order `place[old] = new`, as an upper triangle with sorted rows.
Triangle permuted_upper(const Triangle& t, const std::vector<int>& place) {
  const int n = static_cast<int>(t.start.size()) - 1;
  Triangle lower;  // rows unsorted
  lower.start.assign(static_cast<std::size_t>(n) + 1, 0);
  lower.row.resize(t.row.size());
  lower.source.resize(t.row.size());
  for (int j = 0; j < n; ++j) {
    for (int p = t.start[j]; p < t.start[j + 1]; ++p) ++lower.start[std::min(place[j], place[t.row[p]]) + 1];
  }
  for (int j = 0; j < n; ++j) lower.start[j + 1] += lower.start[j];
  std::vector<int> fill(lower.start.begin(), lower.start.end() - 1);
  for (int j = 0; j < n; ++j) {
    for (int p = t.start[j]; p < t.start[j + 1]; ++p) {
      const auto [column, row] = std::minmax(place[j], place[t.row[p]]);
      const int q = fill[column]++;
      lower.row[q] = row;
      lower.source[q] = t.source[p];
    }
  }
  return transposed(lower);
}

}  // namespace

struct LinearSolver::Impl {
  int unknowns = 0;
  std::vector<int> full_index;      ///< of each unknown, in the full matrix
  std::vector<int> order;           ///< unknown eliminated k-th
  std::vector<int> diagonal_entry;  ///< among the permuted values, of the k-th pivot
  Triangle matrix;                  ///< permuted; upper for LDL', lower for LL'
  std::vector<double> values;
  cholmod_sparse view{};
  cholmod_factor* factor = nullptr;
  bool complete = false;
  Statistics statistics;
  // Written by solves.
  cholmod_common common{};
  struct Workspace {
    cholmod_dense* y = nullptr;
    cholmod_dense* e = nullptr;
  };
  std::array<Workspace, kBlockColumns.size()> workspaces;

  Impl() {
    cholmod_start(&common);
    common.print = 0;
    common.try_catch = 1;
    common.nmethods = 1;
    common.quick_return_if_not_posdef = 1;
    common.final_asis = 1;
    common.final_ll = 0;
    if (openblas_get_num_threads() != 1) openblas_set_num_threads(1);
  }
  ~Impl() {
    cholmod_free_factor(&factor, &common);
    for (Workspace& w : workspaces) {
      cholmod_free_dense(&w.y, &common);
      cholmod_free_dense(&w.e, &common);
    }
    cholmod_finish(&common);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  /// Orders the rows and columns of `lower` by one method; fills `order` and `statistics` if it beats what they hold.
  void try_ordering(Triangle& lower, Ordering ordering) {
    common.method[0].ordering = ordering == Ordering::kMetis ? CHOLMOD_METIS : CHOLMOD_AMD;
    common.supernodal = CHOLMOD_SIMPLICIAL;
    common.postorder = 1;
    cholmod_sparse a = lower.view(-1, nullptr);
    cholmod_factor* symbolic = nullptr;
    if (ordering == Ordering::kMetis) {
      static std::mutex metis_is_not_reentrant;  // it seeds and reads rand() of the whole process
      const std::lock_guard lock(metis_is_not_reentrant);
      symbolic = cholmod_analyze(&a, &common);
    } else {
      symbolic = cholmod_analyze(&a, &common);
    }
    if (symbolic == nullptr) return;
    if (order.empty() || common.fl < statistics.factor_flops) {
      const int* perm = static_cast<const int*>(symbolic->Perm);
      order.assign(perm, perm + unknowns);
      statistics.factor_flops = common.fl;
      statistics.factor_nonzeros = static_cast<std::int64_t>(common.lnz);
      statistics.ordering = ordering;
    }
    cholmod_free_factor(&symbolic, &common);
  }

  void analyze(const SparsePattern& pattern, std::span<const int> kept, const LinearSolverOptions& options) {
    for (int i = 0; i < pattern.size(); ++i) {
      if (kept[i] < 0) continue;
      LISSOM_ASSERT(kept[i] == unknowns);
      full_index.push_back(i);
      ++unknowns;
    }
    if (unknowns == 0) return;
    const OneThread one_thread;
    Triangle lower = kept_part(pattern, kept, unknowns);
    if (options.ordering != Ordering::kMetis) try_ordering(lower, Ordering::kAmd);
    const bool metis_may_pay = statistics.factor_flops > kMetisWorthFlopsPerUnknown * unknowns;
    if (options.ordering == Ordering::kMetis || (options.ordering == Ordering::kBest && metis_may_pay)) {
      try_ordering(lower, Ordering::kMetis);
    }
    LISSOM_ASSERT(!order.empty());

    statistics.kind = options.kind;
    if (options.kind == FactorKind::kBest) {
      const double width = statistics.factor_flops / static_cast<double>(statistics.factor_nonzeros);
      statistics.kind = width > kWideFlopsPerNonzero ? FactorKind::kCholesky : FactorKind::kLdl;
    }
    const bool simplicial = statistics.kind == FactorKind::kLdl;

    std::vector<int> place(unknowns);
    for (int k = 0; k < unknowns; ++k) place[order[k]] = k;
    matrix = permuted_upper(lower, place);
    if (!simplicial) matrix = transposed(matrix);
    values.assign(matrix.row.size(), 0.0);
    diagonal_entry.resize(unknowns);
    for (int k = 0; k < unknowns; ++k) {
      diagonal_entry[k] = simplicial ? matrix.start[k + 1] - 1 : matrix.start[k];
      LISSOM_ASSERT(matrix.row[diagonal_entry[k]] == k);
    }
    view = matrix.view(simplicial ? 1 : -1, values.data());

    common.method[0].ordering = CHOLMOD_NATURAL;
    common.postorder = 0;
    common.supernodal = simplicial ? CHOLMOD_SIMPLICIAL : CHOLMOD_SUPERNODAL;
    factor = cholmod_analyze(&view, &common);
    LISSOM_ASSERT(factor != nullptr && factor->ordering == CHOLMOD_NATURAL);
    std::copy(order.begin(), order.end(), static_cast<int*>(factor->Perm));  // for solves, which permute on the way
  }

  /// Copies K + shift * diag(metric) into the permuted values; returns the first pivot whose row or column holds
  /// something that is not finite, -1 if none does.
  int load(std::span<const double> full_values, double shift, std::span<const double> metric) {
    const auto finite = [](double v) { return std::abs(v) <= std::numeric_limits<double>::max(); };
    const std::size_t count = values.size();
    const int* source = matrix.source.data();
    bool all_finite = true;
    for (std::size_t p = 0; p < count; ++p) {
      values[p] = full_values[source[p]];
      all_finite &= finite(values[p]);
    }
    if (shift != 0) {
      for (int k = 0; k < unknowns; ++k) {
        double& v = values[diagonal_entry[k]];
        v += shift * metric[order[k]];
        all_finite &= finite(v);
      }
    }
    if (all_finite) return -1;
    int k = 0;
    while (std::all_of(values.begin() + matrix.start[k], values.begin() + matrix.start[k + 1], finite)) ++k;
    return k;
  }

  /// Reads the pivots of a finished LDL'.
  FactorReport inspect_ldl() const {
    FactorReport report;
    const int* start = static_cast<const int*>(factor->p);
    const double* x = static_cast<const double*>(factor->x);
    const int reached = static_cast<int>(std::min<std::size_t>(factor->minor, unknowns));
    int negative = 0;
    for (int k = 0; k < reached; ++k) {
      const double pivot = x[start[k]];
      if (pivot > 0 && pivot <= std::numeric_limits<double>::max()) continue;
      if (report.failed_at < 0) report.failed_at = full_index[order[k]];
      if (!(pivot < 0) || pivot < -std::numeric_limits<double>::max()) return report;
      ++negative;
    }
    if (reached < unknowns) {
      if (report.failed_at < 0) report.failed_at = full_index[order[reached]];
      return report;
    }
    report.complete = true;
    report.negative_pivots = negative;
    report.positive_definite = negative == 0;
    return report;
  }

  /// Reads the diagonal of a finished LL'.
  FactorReport inspect_cholesky() const {
    FactorReport report;
    const int* super = static_cast<const int*>(factor->super);
    const int* rows = static_cast<const int*>(factor->pi);
    const int* first = static_cast<const int*>(factor->px);
    const double* x = static_cast<const double*>(factor->x);
    if (factor->minor < static_cast<std::size_t>(unknowns)) {
      report.failed_at = full_index[order[factor->minor]];
      return report;
    }
    for (int s = 0; s < static_cast<int>(factor->nsuper); ++s) {
      const std::ptrdiff_t height = rows[s + 1] - rows[s];
      for (int k = super[s]; k < super[s + 1]; ++k) {
        const double d = x[first[s] + (k - super[s]) * (height + 1)];
        if (d > 0 && d <= std::numeric_limits<double>::max()) continue;
        report.failed_at = full_index[order[k]];
        return report;
      }
    }
    report.complete = true;
    report.positive_definite = true;
    report.negative_pivots = 0;
    return report;
  }

  /// Solves for kBlockColumns[width] right-hand sides stored one after the other. x may be b.
  void solve_block(const double* b, double* x, std::size_t width) {
    const auto describe = [&](double* data) {
      cholmod_dense d{};
      d.nrow = d.d = static_cast<std::size_t>(unknowns);
      d.ncol = static_cast<std::size_t>(kBlockColumns[width]);
      d.nzmax = d.nrow * d.ncol;
      d.x = data;
      d.xtype = CHOLMOD_REAL;
      d.dtype = CHOLMOD_DOUBLE;
      return d;
    };
    cholmod_dense right = describe(const_cast<double*>(b));  // only read
    cholmod_dense left = describe(x);                        // of the right shape, so CHOLMOD writes into it
    cholmod_dense* left_handle = &left;
    if (cholmod_dense* y = workspaces[width].y; y != nullptr && !factor->is_super) {
      // CHOLMOD narrows it to the columns in use and would not know it again: put back the shape it was allocated with.
      y->ncol = static_cast<std::size_t>(unknowns);
      y->nrow = y->d = y->nzmax / y->ncol;
    }
    const OneThread one_thread;
    factor->ordering = CHOLMOD_GIVEN;  // makes the solve apply factor->Perm
    const int ok = cholmod_solve2(CHOLMOD_A, factor, &right, nullptr, &left_handle, nullptr, &workspaces[width].y,
                                  &workspaces[width].e, &common);
    factor->ordering = CHOLMOD_NATURAL;
    LISSOM_ASSERT(ok && left_handle == &left);
  }
};

LinearSolver::LinearSolver(const SparsePattern& pattern, std::span<const int> kept, const LinearSolverOptions& options)
    : impl_(std::make_unique<Impl>()) {
  LISSOM_ASSERT(kept.size() == static_cast<std::size_t>(pattern.size()));
  impl_->analyze(pattern, kept, options);
}
LinearSolver::~LinearSolver() = default;
LinearSolver::LinearSolver(LinearSolver&&) noexcept = default;
LinearSolver& LinearSolver::operator=(LinearSolver&&) noexcept = default;

int LinearSolver::unknowns() const { return impl_->unknowns; }

const LinearSolver::Statistics& LinearSolver::statistics() const { return impl_->statistics; }

FactorReport LinearSolver::factorize(std::span<const double> values, double shift, std::span<const double> metric) {
  Impl& s = *impl_;
  LISSOM_ASSERT(shift == 0 || metric.size() == static_cast<std::size_t>(s.unknowns));
  FactorReport report;
  s.complete = false;
  if (s.unknowns == 0) {
    report = {.complete = true, .positive_definite = true, .negative_pivots = 0, .failed_at = -1};
  } else if (const int bad = s.load(values, shift, metric); bad >= 0) {
    report.failed_at = s.full_index[s.order[bad]];
  } else {
    const OneThread one_thread;
    double beta[2] = {0, 0};
    const int ok = cholmod_factorize_p(&s.view, beta, nullptr, 0, s.factor, &s.common);
    if (ok) report = s.statistics.kind == FactorKind::kLdl ? s.inspect_ldl() : s.inspect_cholesky();
  }
  s.complete = report.complete;
  return report;
}

void LinearSolver::solve(const VecX& b, VecX& x) const {
  LISSOM_ASSERT(impl_->unknowns == 0 || impl_->complete);
  LISSOM_ASSERT(b.size() == impl_->unknowns);
  x.resize(b.size());
  if (impl_->unknowns > 0) impl_->solve_block(b.data(), x.data(), kBlockColumns.size() - 1);
}

void LinearSolver::solve_many(const MatX& b, MatX& x) const {
  LISSOM_ASSERT(impl_->unknowns == 0 || impl_->complete);
  LISSOM_ASSERT(b.rows() == impl_->unknowns);
  x.resize(b.rows(), b.cols());
  if (impl_->unknowns == 0) return;
  Eigen::Index done = 0;
  for (std::size_t width = 0; width < kBlockColumns.size(); ++width) {
    for (; done + kBlockColumns[width] <= b.cols(); done += kBlockColumns[width]) {
      impl_->solve_block(b.col(done).data(), x.col(done).data(), width);
    }
  }
}

}  // namespace lissom
