/// `LinearSolver` by orderings of CHOLMOD (Davis, Hager et al.; AMD and METIS behind one interface) and the multifrontal
/// factorisation of this folder.
#include "lissom/core/linear_solver.h"

#include <cholmod.h>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "lissom/core/assert.h"
#include "lissom/core/multifrontal.h"

namespace lissom {

namespace {

/// Operations per unknown with AMD below which METIS is not asked: it takes 2 to 5 us per unknown, four times as long as
/// AMD, and gains a tenth of a factorisation at most on rod networks (8,000 operations per unknown at 430k unknowns: 105
/// ms against 117) and on regular membranes (15,000 at 19k unknowns: 11.7 ms against 12.8). What it is for are irregular
/// membranes, where AMD can need four times its operations.
constexpr double kMetisWorthFlopsPerUnknown = 20000;

/// An order of elimination, and what it costs.
struct Ordered {
  std::vector<int> order;  ///< unknown eliminated k-th
  multifrontal::AssemblyTree tree;
  LinearSolver::Statistics statistics;
};

class CholmodCommon {
 public:
  CholmodCommon() {
    cholmod_start(&common_);
    common_.print = 0;
    common_.try_catch = 1;
    common_.nmethods = 1;
    common_.supernodal = CHOLMOD_SIMPLICIAL;
    common_.postorder = 1;
  }
  ~CholmodCommon() { cholmod_finish(&common_); }
  CholmodCommon(const CholmodCommon&) = delete;
  CholmodCommon& operator=(const CholmodCommon&) = delete;
  cholmod_common& get() { return common_; }

 private:
  cholmod_common common_{};
};

/// Fails only when there is no memory.
std::optional<Ordered> ordered_by(Ordering ordering, multifrontal::Triangle& lower) {
  CholmodCommon owner;
  cholmod_common& common = owner.get();
  common.method[0].ordering = ordering == Ordering::kMetis ? CHOLMOD_METIS : CHOLMOD_AMD;
  cholmod_sparse a{};
  a.nrow = a.ncol = static_cast<std::size_t>(lower.size());
  a.nzmax = lower.row.size();
  a.p = lower.start.data();
  a.i = lower.row.data();
  a.stype = -1;
  a.itype = CHOLMOD_INT;
  a.xtype = CHOLMOD_PATTERN;
  a.dtype = CHOLMOD_DOUBLE;
  a.sorted = 1;
  a.packed = 1;
  cholmod_factor* symbolic = nullptr;
  if (ordering == Ordering::kMetis) {
    static std::mutex metis_is_not_reentrant;  // it seeds and reads rand() of the whole process
    const std::lock_guard lock(metis_is_not_reentrant);
    symbolic = cholmod_analyze(&a, &common);
  } else {
    symbolic = cholmod_analyze(&a, &common);
  }
  if (symbolic == nullptr) return std::nullopt;
  Ordered result;
  const int* order = static_cast<const int*>(symbolic->Perm);
  const int* counts = static_cast<const int*>(symbolic->ColCount);
  result.order.assign(order, order + lower.size());
  result.tree = multifrontal::assembly_tree(multifrontal::permuted_upper(lower, result.order),
                                            {counts, static_cast<std::size_t>(lower.size())});
  result.statistics = {
      .factor_flops = common.fl, .factor_nonzeros = static_cast<std::int64_t>(common.lnz), .ordering = ordering};
  cholmod_free_factor(&symbolic, &common);
  return result;
}

/// The order with which the factorisation is expected to take least.
Ordered best_order(multifrontal::Triangle& lower, Ordering wanted) {
  std::optional<Ordered> best;
  if (wanted != Ordering::kMetis) best = ordered_by(Ordering::kAmd, lower);
  const bool metis_may_pay = best && best->statistics.factor_flops > kMetisWorthFlopsPerUnknown * lower.size();
  if (wanted == Ordering::kMetis || (wanted == Ordering::kBest && metis_may_pay)) {
    std::optional<Ordered> metis = ordered_by(Ordering::kMetis, lower);
    if (!best || (metis && metis->tree.time < best->tree.time)) best = std::move(metis);
  }
  LISSOM_ASSERT(best.has_value());
  return *std::move(best);
}

}  // namespace

struct LinearSolver::Impl {
  std::vector<int> full_index;                 ///< of each unknown, in the full matrix
  std::optional<multifrontal::Factor> factor;  ///< absent without unknowns
  bool complete = false;
  Statistics statistics;

  int unknowns() const { return static_cast<int>(full_index.size()); }
};

LinearSolver::LinearSolver(const SparsePattern& pattern, std::span<const int> kept, const LinearSolverOptions& options)
    : impl_(std::make_unique<Impl>()) {
  LISSOM_ASSERT(kept.size() == static_cast<std::size_t>(pattern.size()));
  for (int i = 0; i < pattern.size(); ++i) {
    if (kept[i] < 0) continue;
    LISSOM_ASSERT(kept[i] == impl_->unknowns());
    impl_->full_index.push_back(i);
  }
  if (impl_->unknowns() == 0) return;
  multifrontal::Triangle lower = multifrontal::kept_part(pattern, kept);
  const Ordered ordered = best_order(lower, options.ordering);
  impl_->statistics = ordered.statistics;
  impl_->factor.emplace(multifrontal::make_plan(lower, ordered.order, ordered.tree), options.threads);
}
LinearSolver::~LinearSolver() = default;
LinearSolver::LinearSolver(LinearSolver&&) noexcept = default;
LinearSolver& LinearSolver::operator=(LinearSolver&&) noexcept = default;

int LinearSolver::unknowns() const { return impl_->unknowns(); }

const LinearSolver::Statistics& LinearSolver::statistics() const { return impl_->statistics; }

FactorReport LinearSolver::factorize(std::span<const double> values, double shift, std::span<const double> metric,
                                     Indefinite indefinite) {
  Impl& s = *impl_;
  LISSOM_ASSERT(shift == 0 || metric.size() == static_cast<std::size_t>(s.unknowns()));
  multifrontal::PivotCount count;
  if (s.factor) {
    count = s.factor->factorize(
        values, shift, metric,
        indefinite == Indefinite::kStop ? multifrontal::OnNegative::kStop : multifrontal::OnNegative::kContinue);
  }
  FactorReport report;
  report.complete = s.complete = !count.broken;
  report.positive_definite = report.complete && count.negative == 0;
  if (report.complete) report.negative_pivots = count.negative;
  if (count.first_bad >= 0) report.failed_at = s.full_index[s.factor->plan().order[count.first_bad]];
  return report;
}

void LinearSolver::solve(const VecX& b, VecX& x) const {
  LISSOM_ASSERT(impl_->unknowns() == 0 || impl_->complete);
  LISSOM_ASSERT(b.size() == impl_->unknowns());
  x.resize(b.size());
  if (impl_->factor) impl_->factor->solve(b.data(), x.data());
}

void LinearSolver::solve_many(const MatX& b, MatX& x) const {
  LISSOM_ASSERT(impl_->unknowns() == 0 || impl_->complete);
  LISSOM_ASSERT(b.rows() == impl_->unknowns());
  x.resize(b.rows(), b.cols());
  if (impl_->factor) impl_->factor->solve_many(b.data(), x.data(), static_cast<int>(b.cols()));
}

}  // namespace lissom
