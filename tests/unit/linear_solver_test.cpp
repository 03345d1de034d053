#include "lissom/core/linear_solver.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <thread>

#include "bench/rod_matrices.h"
#include "tests/count_allocations.h"

namespace lissom {
namespace {

using rod_matrices::Blocks;

constexpr Ordering kOrderings[] = {Ordering::kAmd, Ordering::kMetis, Ordering::kBest};

std::vector<int> keep_all(int n) {
  std::vector<int> kept(n);
  std::iota(kept.begin(), kept.end(), 0);
  return kept;
}

/// Leaves out every index i with i % period == 0.
std::vector<int> keep_some(int n, int period) {
  std::vector<int> kept(n, -1);
  int next = 0;
  for (int i = 0; i < n; ++i) {
    if (i % period != 0) kept[i] = next++;
  }
  return kept;
}

int count_kept(const std::vector<int>& kept) {
  return static_cast<int>(std::count_if(kept.begin(), kept.end(), [](int k) { return k >= 0; }));
}

Eigen::SparseMatrix<double> reference(const SparsePattern& p, const std::vector<double>& v,
                                      const std::vector<int>& kept, double shift = 0,
                                      const std::vector<double>& metric = {}) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < p.size(); ++j) {
    for (int s = p.column_start()[j]; s < p.column_start()[j + 1]; ++s) {
      const int i = p.row()[s];
      if (kept[i] < 0 || kept[j] < 0) continue;
      entries.emplace_back(kept[i], kept[j], v[s]);
      if (i != j) entries.emplace_back(kept[j], kept[i], v[s]);
    }
  }
  const int n = count_kept(kept);
  for (int i = 0; i < n && shift != 0; ++i) entries.emplace_back(i, i, shift * metric[i]);
  Eigen::SparseMatrix<double> a(n, n);
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

VecX random_vector(int n, std::uint64_t seed) {
  rod_matrices::Random random(seed);
  VecX v(n);
  for (double& x : v) x = random.next();
  return v;
}

/// |A x - b| in units of rounding of the terms.
double backward_error(const Eigen::SparseMatrix<double>& a, const VecX& x, const VecX& b) {
  double norm = 0;
  for (int j = 0; j < a.outerSize(); ++j) {
    double sum = 0;
    for (Eigen::SparseMatrix<double>::InnerIterator it(a, j); it; ++it) sum += std::abs(it.value());
    norm = std::max(norm, sum);
  }
  return (a * x - b).lpNorm<Eigen::Infinity>() / (norm * x.lpNorm<Eigen::Infinity>() + b.lpNorm<Eigen::Infinity>());
}

TEST(LinearSolver, SolvesPositiveDefiniteMatricesLikeEigen) {
  int checked = 0;
  for (const Blocks& b : {rod_matrices::chain(1000), rod_matrices::honeycomb(6, 7, 4), rod_matrices::membrane(9, 11),
                          rod_matrices::honeycomb(22, 22, 4)}) {
    const SparsePattern p = b.pattern();
    const std::vector<double> v = rod_matrices::values(b, p);
    for (const std::vector<int>& kept : {keep_all(b.size), keep_some(b.size, 5)}) {
      const int n = count_kept(kept);
      const Eigen::SparseMatrix<double> a = reference(p, v, kept);
      const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> oracle(a);
      const VecX rhs = random_vector(n, 3);
      const VecX expected = oracle.solve(rhs);
      for (const Ordering ordering : kOrderings) {
        LinearSolver solver(p, kept, {.ordering = ordering});
        ASSERT_EQ(solver.unknowns(), n);
        const FactorReport report = solver.factorize(v);
        ASSERT_TRUE(report.complete && report.positive_definite);
        EXPECT_EQ(report.negative_pivots, 0);
        EXPECT_EQ(report.failed_at, -1);
        VecX x;
        solver.solve(rhs, x);
        EXPECT_LT(backward_error(a, x, rhs), 1e-15);
        EXPECT_LT((x - expected).norm(), 1e-10 * expected.norm());
        VecX in_place = rhs;
        solver.solve(in_place, in_place);
        EXPECT_TRUE(in_place == x) << "x may be b";
        ++checked;
      }
    }
  }
  EXPECT_EQ(checked, 4 * 2 * 3);
}

TEST(LinearSolver, InertiaOfIndefiniteMatricesEqualsTheSignsOfEigenvalues) {
  for (const Blocks& b : {rod_matrices::chain(60), rod_matrices::honeycomb(3, 4, 3), rod_matrices::membrane(7, 9)}) {
    const SparsePattern p = b.pattern();
    const std::vector<double> v = rod_matrices::values(b, p, true);
    for (const std::vector<int>& kept : {keep_all(b.size), keep_some(b.size, 7)}) {
      const Eigen::SparseMatrix<double> a = reference(p, v, kept);
      const Eigen::SelfAdjointEigenSolver<MatX> dense(MatX(a), Eigen::EigenvaluesOnly);
      const int negative = static_cast<int>((dense.eigenvalues().array() < 0).count());
      ASSERT_GT(negative, 0);
      for (const Ordering ordering : kOrderings) {
        LinearSolver solver(p, kept, {.ordering = ordering});
        const FactorReport report = solver.factorize(v);
        ASSERT_TRUE(report.complete);
        EXPECT_FALSE(report.positive_definite);
        EXPECT_EQ(report.negative_pivots, negative);
        ASSERT_GE(report.failed_at, 0);
        EXPECT_GE(kept[report.failed_at], 0) << "an index of the full matrix that is kept";
        const VecX rhs = random_vector(solver.unknowns(), 5);
        VecX x;
        solver.solve(rhs, x);
        EXPECT_LT(backward_error(a, x, rhs), 1e-11);

        const FactorReport stopped = solver.factorize(v, 0, {}, Indefinite::kStop);
        EXPECT_FALSE(stopped.complete || stopped.positive_definite);
        EXPECT_EQ(stopped.negative_pivots, -1);
        EXPECT_EQ(stopped.failed_at, report.failed_at) << "the same first bad pivot";
      }
    }
  }
}

TEST(LinearSolver, ShiftOnAMetricMakesTheMatrixDefinite) {
  const Blocks b = rod_matrices::honeycomb(3, 3, 3);
  const SparsePattern p = b.pattern();
  const std::vector<double> v = rod_matrices::values(b, p, true);
  const std::vector<int> kept = keep_some(b.size, 4);
  const int n = count_kept(kept);
  std::vector<double> metric(n);
  for (int i = 0; i < n; ++i) metric[i] = 0.5 + i % 3;
  for (const double shift : {0.7, 3.0, 40.0}) {
    const Eigen::SparseMatrix<double> a = reference(p, v, kept, shift, metric);
    const Eigen::SelfAdjointEigenSolver<MatX> dense(MatX(a), Eigen::EigenvaluesOnly);
    const int negative = static_cast<int>((dense.eigenvalues().array() < 0).count());
    LinearSolver solver(p, kept);
    EXPECT_EQ(solver.factorize(v, shift, metric, Indefinite::kStop).complete, negative == 0);
    const FactorReport report = solver.factorize(v, shift, metric);
    EXPECT_EQ(report.negative_pivots, negative);
    const VecX rhs = random_vector(n, 9);
    VecX x;
    solver.solve(rhs, x);
    EXPECT_LT(backward_error(a, x, rhs), 1e-12);
  }
}

TEST(LinearSolver, RefactorizesAfterFailures) {
  const Blocks b = rod_matrices::honeycomb(4, 4, 3);
  const SparsePattern p = b.pattern();
  const std::vector<double> good = rod_matrices::values(b, p);
  const std::vector<double> indefinite_values = rod_matrices::values(b, p, true);
  const std::vector<double> zero(good.size(), 0.0);
  const std::vector<int> kept = keep_all(b.size);
  const VecX rhs = random_vector(b.size, 2);
  LinearSolver solver(p, kept);
  VecX first;
  ASSERT_TRUE(solver.factorize(good).complete);
  solver.solve(rhs, first);
  for (const Indefinite indefinite : {Indefinite::kFactorise, Indefinite::kStop}) {
    for (const std::vector<double>* bad : {&indefinite_values, &zero}) {
      EXPECT_EQ(solver.factorize(*bad, 0, {}, indefinite).complete,
                bad == &indefinite_values && indefinite == Indefinite::kFactorise);
      ASSERT_TRUE(solver.factorize(good).complete);
      VecX again;
      solver.solve(rhs, again);
      EXPECT_TRUE(first == again) << "nothing of the failure is left";
    }
  }
}

TEST(LinearSolver, SingularMatricesAreIncompleteAndNamed) {
  for (const double bad : {0.0, -0.0}) {
    const std::vector<int> indices{0, 1};
    const std::vector<int> offsets{0, 2};
    const SparsePattern p(4, indices, offsets);  // [1 1; 1 1] and two diagonal entries
    std::vector<double> v(p.nonzeros(), 1.0);
    LinearSolver solver(p, keep_all(4));
    FactorReport report = solver.factorize(v);
    EXPECT_FALSE(report.complete || report.positive_definite);
    EXPECT_TRUE(report.failed_at == 0 || report.failed_at == 1);
    v[p.slot(0, 1)] = 0.5;
    EXPECT_TRUE(solver.factorize(v).complete);
    v[p.slot(2, 2)] = bad;
    report = solver.factorize(v);
    EXPECT_FALSE(report.complete);
    EXPECT_EQ(report.failed_at, 2);
  }
}

TEST(LinearSolver, NumbersThatAreNotFiniteEndInAReport) {
  const Blocks b = rod_matrices::honeycomb(4, 4, 3);
  const SparsePattern p = b.pattern();
  const std::vector<double> good = rod_matrices::values(b, p);
  std::vector<int> kept = keep_some(b.size, 9);
  const std::vector<double> metric(count_kept(kept), 1.0);
  const double inf = std::numeric_limits<double>::infinity();
  LinearSolver solver(p, kept);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), inf, -inf}) {
    for (const int at : {p.slot(100, 100), p.column_start()[40] + 1}) {
      std::vector<double> v = good;
      v[at] = bad;
      const FactorReport report = solver.factorize(v);
      EXPECT_FALSE(report.complete || report.positive_definite);
      EXPECT_GE(report.failed_at, 0);
    }
    EXPECT_FALSE(solver.factorize(good, bad, metric).complete);
    std::vector<double> v = good;
    v[p.slot(0, 0)] = bad;  // left out
    EXPECT_TRUE(solver.factorize(v).complete);
  }
  std::vector<double> huge = good;
  for (double& x : huge) x *= 1e300;
  EXPECT_TRUE(solver.factorize(good).complete);
  const FactorReport report = solver.factorize(huge);  // overflows on the way or not; never a silent NaN
  if (report.complete) {
    VecX x;
    solver.solve(VecX::Ones(solver.unknowns()), x);
    EXPECT_TRUE(x.allFinite());
  }
}

TEST(LinearSolver, OneUnknownAndNone) {
  const SparsePattern p(3, {}, {});
  const std::vector<double> v{2.0, -4.0, 8.0};
  LinearSolver one(p, std::vector<int>{-1, -1, 0});
  ASSERT_TRUE(one.factorize(v).positive_definite);
  VecX x;
  one.solve(VecX::Constant(1, 4.0), x);
  EXPECT_DOUBLE_EQ(x[0], 0.5);

  LinearSolver none(p, std::vector<int>{-1, -1, -1});
  EXPECT_EQ(none.unknowns(), 0);
  const FactorReport report = none.factorize(v);
  EXPECT_TRUE(report.complete && report.positive_definite);
  none.solve(VecX(), x);
  EXPECT_EQ(x.size(), 0);
  MatX many;
  none.solve_many(MatX(0, 3), many);
  EXPECT_EQ(many.cols(), 3);
  LinearSolver negative(p, std::vector<int>{-1, 0, -1});
  const FactorReport below_zero = negative.factorize(v);
  EXPECT_TRUE(below_zero.complete);
  EXPECT_EQ(below_zero.negative_pivots, 1);
  EXPECT_EQ(below_zero.failed_at, 1);
}

TEST(LinearSolver, ResultDoesNotDependOnTheNumbering) {
  const Blocks b = rod_matrices::honeycomb(4, 5, 3);
  const SparsePattern p = b.pattern();
  const std::vector<double> v = rod_matrices::values(b, p, true);
  const VecX rhs = random_vector(b.size, 4);
  LinearSolver solver(p, keep_all(b.size));
  const int negative = solver.factorize(v).negative_pivots;
  VecX x;
  solver.solve(rhs, x);
  rod_matrices::Random random(11);
  for (int trial = 0; trial < 10; ++trial) {
    std::vector<int> to = keep_all(b.size);
    for (int i = b.size - 1; i > 0; --i) {
      const int other = static_cast<int>((random.next() + 1) / 2 * i);
      std::swap(to[i], to[other]);
    }
    Blocks shuffled = b;
    for (int& i : shuffled.indices) i = to[i];
    const SparsePattern q = shuffled.pattern();
    std::vector<double> w(q.nonzeros());
    VecX right(b.size);
    for (int j = 0; j < b.size; ++j) {
      right[to[j]] = rhs[j];
      for (int s = p.column_start()[j]; s < p.column_start()[j + 1]; ++s) w[q.slot(to[p.row()[s]], to[j])] = v[s];
    }
    LinearSolver other(q, keep_all(b.size));
    EXPECT_EQ(other.factorize(w).negative_pivots, negative);
    VecX y;
    other.solve(right, y);
    double difference = 0;
    for (int j = 0; j < b.size; ++j) difference = std::max(difference, std::abs(y[to[j]] - x[j]));
    EXPECT_LT(difference, 1e-9 * x.lpNorm<Eigen::Infinity>());
  }
}

TEST(LinearSolver, ManyRightHandSidesEqualSingleOnes) {
  const Blocks b = rod_matrices::honeycomb(5, 5, 3);
  const SparsePattern p = b.pattern();
  const std::vector<double> v = rod_matrices::values(b, p);
  LinearSolver solver(p, keep_all(b.size));
  ASSERT_TRUE(solver.factorize(v).complete);
  for (const int columns : {0, 1, 3, 32, 71}) {
    MatX rhs(b.size, columns);
    for (int c = 0; c < columns; ++c) rhs.col(c) = random_vector(b.size, 20 + c);
    MatX x;
    solver.solve_many(rhs, x);
    ASSERT_EQ(x.cols(), columns);
    for (int c = 0; c < columns; ++c) {
      VecX single;
      solver.solve(rhs.col(c), single);
      EXPECT_LT((x.col(c) - single).norm(), 1e-12 * single.norm());
    }
    MatX in_place = rhs;
    solver.solve_many(in_place, in_place);
    EXPECT_TRUE(in_place == x);
  }
}

TEST(LinearSolver, SolversInSeveralThreadsAgreeToTheLastBit) {
  const Blocks b = rod_matrices::honeycomb(10, 10, 4);
  const SparsePattern p = b.pattern();
  const std::vector<double> v = rod_matrices::values(b, p);
  const VecX rhs = random_vector(b.size, 6);
  for (const LinearSolverOptions options : {LinearSolverOptions{}, LinearSolverOptions{.ordering = Ordering::kMetis}}) {
    std::vector<VecX> x(4);
    std::vector<std::thread> threads;
    for (VecX& result : x) {
      threads.emplace_back([&, out = &result] {
        LinearSolver solver(p, keep_all(b.size), options);
        for (int repeat = 0; repeat < 5; ++repeat) {
          if (solver.factorize(v).complete) solver.solve(rhs, *out);
        }
      });
    }
    for (std::thread& t : threads) t.join();
    ASSERT_EQ(x[0].size(), b.size);
    for (const VecX& other : x) EXPECT_TRUE(other == x[0]);
  }
}

TEST(LinearSolver, MovesLeaveAWorkingSolver) {
  const Blocks b = rod_matrices::chain(20);
  const SparsePattern p = b.pattern();
  const std::vector<double> v = rod_matrices::values(b, p);
  LinearSolver first(p, keep_all(b.size));
  ASSERT_TRUE(first.factorize(v).complete);
  LinearSolver second = std::move(first);
  VecX x;
  second.solve(VecX::Ones(b.size), x);
  first = std::move(second);
  ASSERT_TRUE(first.factorize(v).complete);
  VecX y;
  first.solve(VecX::Ones(b.size), y);
  EXPECT_TRUE(x == y);
}

TEST(LinearSolver, StatisticsNameWhatWasChosen) {
  const auto statistics = [](const Blocks& b, LinearSolverOptions options) {
    const SparsePattern p = b.pattern();
    return LinearSolver(p, keep_all(b.size), options).statistics();
  };
  const Blocks rods = rod_matrices::chain(300);
  EXPECT_EQ(statistics(rods, {}).ordering, Ordering::kAmd);
  const Blocks sheet = rod_matrices::membrane(120, 120);
  const double amd = statistics(sheet, {.ordering = Ordering::kAmd}).factor_flops;
  const double metis = statistics(sheet, {.ordering = Ordering::kMetis}).factor_flops;
  EXPECT_LT(metis, amd);
  EXPECT_EQ(statistics(sheet, {}).factor_flops, metis);
  EXPECT_EQ(statistics(sheet, {}).ordering, Ordering::kMetis);
  EXPECT_GE(statistics(sheet, {}).factor_nonzeros, sheet.pattern().nonzeros());
}

#ifdef LISSOM_COUNTS_ALLOCATIONS
TEST(LinearSolver, NothingIsAllocatedAfterTheFirstFactorizationAndSolve) {
  for (const Blocks& b : {rod_matrices::chain(1000), rod_matrices::honeycomb(15, 15, 4)}) {
    const SparsePattern p = b.pattern();
    const std::vector<double> v = rod_matrices::values(b, p);
    const std::vector<double> indefinite = rod_matrices::values(b, p, true);
    const std::vector<int> kept = keep_some(b.size, 50);
    const std::vector<double> metric(count_kept(kept), 1.0);
    LinearSolver solver(p, kept);
    const VecX rhs = random_vector(solver.unknowns(), 1);
    VecX x;
    const MatX many = rhs.replicate(1, 47);
    MatX solutions;
    const auto use = [&] {
      const bool ok = solver.factorize(v).complete;
      solver.solve(rhs, x);
      solver.solve_many(many, solutions);
      return ok;
    };
    const long at_first = allocations.load();
    ASSERT_TRUE(use());
    const long before = allocations.load();
    ASSERT_GT(before, at_first) << "the counter counts";
    bool ok = true;
    for (int repeat = 0; repeat < 5; ++repeat) ok = use() && ok;
    ok = solver.factorize(indefinite).complete && ok;
    ok = solver.factorize(v, 0.5, metric).complete && ok;
    EXPECT_EQ(allocations.load() - before, 0) << b.size;
    EXPECT_TRUE(ok);
  }
}
#endif

}  // namespace
}  // namespace lissom
