/// The multifrontal factorisation on shapes of matrices that structures do not have, through `LinearSolver` and by parts.
#include "lissom/core/multifrontal.h"

#include <Eigen/Dense>
#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <set>

#include "bench/rod_matrices.h"
#include "lissom/core/linear_solver.h"
#include "tests/count_allocations.h"

namespace lissom {
namespace {

using rod_matrices::Random;

struct Sample {
  std::string name;
  SparsePattern pattern;
  std::vector<double> values;
  MatX dense;
};

/// A matrix with these entries off the diagonal and random values; `weight` scales a dominant diagonal of mixed signs.
Sample sample(const std::string& name, int n, const std::vector<std::pair<int, int>>& entries, double weight,
              bool indefinite) {
  std::vector<int> indices, offsets{0};
  for (const auto& [i, j] : entries) {
    indices.insert(indices.end(), {i, j});
    offsets.push_back(static_cast<int>(indices.size()));
  }
  Sample s{name, SparsePattern(n, indices, offsets), {}, MatX::Zero(n, n)};
  Random random(static_cast<std::uint64_t>(n) + 3);
  s.values.resize(s.pattern.nonzeros());
  VecX sum = VecX::Zero(n);
  for (int j = 0; j < n; ++j) {
    for (int p = s.pattern.column_start()[j] + 1; p < s.pattern.column_start()[j + 1]; ++p) {
      const int i = s.pattern.row()[p];
      s.values[p] = s.dense(i, j) = s.dense(j, i) = random.next();
      sum[i] += std::abs(s.values[p]);
      sum[j] += std::abs(s.values[p]);
    }
  }
  for (int i = 0; i < n; ++i) {
    const double sign = indefinite && random.next() < 0 ? -1 : 1;
    s.values[s.pattern.diagonal_slot(i)] = s.dense(i, i) =
        sign * (weight * sum[i] + 0.1 + 0.1 * std::abs(random.next()));
  }
  return s;
}

std::vector<std::pair<int, int>> random_entries(int n, int count, std::uint64_t seed) {
  Random random(seed);
  const auto index = [&] { return std::min(n - 1, static_cast<int>((random.next() + 1) / 2 * n)); };
  std::vector<std::pair<int, int>> entries;
  for (int k = 0; k < count; ++k) entries.emplace_back(index(), index());
  return entries;
}

std::vector<Sample> samples(bool indefinite) {
  // Below 1 the diagonal does not dominate, and the pivots of indefinite matrices do not show in it.
  const double weight = indefinite ? 0.6 : 1.01;
  std::vector<Sample> all;
  for (const int n : {1, 2, 3, 4, 5, 7, 8, 9, 13, 64, 65, 66, 67, 131, 200}) {
    std::vector<std::pair<int, int>> dense, arrow, reversed, chain;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < i; ++j) dense.emplace_back(i, j);
      if (i > 0) {
        arrow.emplace_back(i, 0);
        reversed.emplace_back(i - 1, n - 1);
        chain.emplace_back(i, i - 1);
      }
    }
    all.push_back(sample("diagonal", n, {}, weight, indefinite));
    all.push_back(sample("dense", n, dense, weight, indefinite));
    all.push_back(sample("arrow", n, arrow, weight, indefinite));
    all.push_back(sample("reversed arrow", n, reversed, weight, indefinite));
    all.push_back(sample("chain", n, chain, weight, indefinite));
    all.push_back(sample("sparse", n, random_entries(n, n / 3, 5), weight, indefinite));
    all.push_back(sample("random", n, random_entries(n, 3 * n, 6), weight, indefinite));
  }
  return all;
}

std::vector<int> keep_all(int n) {
  std::vector<int> kept(n);
  std::iota(kept.begin(), kept.end(), 0);
  return kept;
}

MatX random_matrix(int rows, int columns) {
  Random random(77);
  MatX m(rows, columns);
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i < rows; ++i) m(i, j) = random.next();
  }
  return m;
}

TEST(Multifrontal, SolvesDefiniteMatricesOfAllShapes) {
  int checked = 0;
  for (const Sample& s : samples(false)) {
    const int n = s.pattern.size();
    const MatX b = random_matrix(n, 5);
    const MatX expected = s.dense.llt().solve(b);
    for (const Ordering ordering : {Ordering::kAmd, Ordering::kMetis}) {
      LinearSolver solver(s.pattern, keep_all(n), {.ordering = ordering});
      ASSERT_TRUE(solver.factorize(s.values, 0, {}, Indefinite::kStop).positive_definite) << s.name << " " << n;
      VecX x;
      solver.solve(b.col(0), x);
      EXPECT_LT((x - expected.col(0)).norm(), 1e-11 * expected.col(0).norm()) << s.name << " " << n;
      MatX many;
      solver.solve_many(b, many);
      EXPECT_LT((many - expected).norm(), 1e-11 * expected.norm()) << s.name << " " << n;
      ++checked;
    }
  }
  EXPECT_EQ(checked, 15 * 7 * 2);
}

TEST(Multifrontal, CountsNegativeEigenvaluesOfAllShapes) {
  int indefinite = 0;
  for (const Sample& s : samples(true)) {
    const int n = s.pattern.size();
    const Eigen::SelfAdjointEigenSolver<MatX> eigen(s.dense, Eigen::EigenvaluesOnly);
    const int negative = static_cast<int>((eigen.eigenvalues().array() < 0).count());
    LinearSolver solver(s.pattern, keep_all(n));
    const FactorReport report = solver.factorize(s.values);
    ASSERT_TRUE(report.complete) << s.name << " " << n;
    EXPECT_EQ(report.negative_pivots, negative) << s.name << " " << n;
    EXPECT_EQ(report.positive_definite, negative == 0);
    EXPECT_EQ(report.failed_at >= 0, negative > 0);
    const MatX b = random_matrix(n, 1);
    VecX x;
    solver.solve(b, x);
    EXPECT_LT((s.dense * x - b).norm(), 1e-8 * (s.dense.norm() * x.norm() + b.norm())) << s.name << " " << n;
    const FactorReport stopped = solver.factorize(s.values, 0, {}, Indefinite::kStop);
    EXPECT_EQ(stopped.complete, negative == 0);
    EXPECT_EQ(stopped.negative_pivots, negative == 0 ? 0 : -1);
    EXPECT_EQ(stopped.failed_at, report.failed_at) << s.name << " " << n;
    indefinite += negative > 0 ? 1 : 0;
  }
  EXPECT_GT(indefinite, 70);
}

TEST(Multifrontal, ShiftsOnAMetricMoveEigenvalues) {
  const Sample s = sample("random", 131, random_entries(131, 393, 6), 0.6, true);
  const int n = s.pattern.size();
  const std::vector<double> metric = [&] {
    std::vector<double> m(n);
    for (int i = 0; i < n; ++i) m[i] = 0.5 + i % 4;
    return m;
  }();
  LinearSolver solver(s.pattern, keep_all(n));
  std::set<int> counts;
  for (const double shift : {-3.0, -0.4, 0.3, 1.1, 9.0}) {
    MatX shifted = s.dense;
    for (int i = 0; i < n; ++i) shifted(i, i) += shift * metric[i];
    const Eigen::SelfAdjointEigenSolver<MatX> eigen(shifted, Eigen::EigenvaluesOnly);
    const int negative = static_cast<int>((eigen.eigenvalues().array() < 0).count());
    EXPECT_EQ(solver.factorize(s.values, shift, metric).negative_pivots, negative);
    counts.insert(negative);
  }
  EXPECT_EQ(counts.size(), 5u);
}

TEST(Multifrontal, ZeroPivotsAndNumbersThatAreNotFiniteStopIt) {
  for (const Sample& s : samples(false)) {
    const int n = s.pattern.size();
    LinearSolver solver(s.pattern, keep_all(n));
    ASSERT_TRUE(solver.factorize(s.values).complete);
    VecX before, after;
    solver.solve(VecX::Ones(n), before);
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::denorm_min()}) {
      for (const int slot : {0, s.pattern.nonzeros() / 2, s.pattern.nonzeros() - 1}) {
        const bool diagonal = slot == s.pattern.diagonal_slot(s.pattern.row()[slot]);
        if (std::isfinite(bad) && !(diagonal && s.name == "diagonal")) continue;
        std::vector<double> v = s.values;
        v[slot] = bad;
        const FactorReport report = solver.factorize(v);
        EXPECT_FALSE(report.complete || report.positive_definite) << s.name << " " << n << " " << bad;
        EXPECT_GE(report.failed_at, 0);
        EXPECT_EQ(report.negative_pivots, -1);
      }
    }
    const std::vector<double> zeros(s.values.size(), 0.0);
    EXPECT_FALSE(solver.factorize(zeros).complete);
    ASSERT_TRUE(solver.factorize(s.values).complete);
    solver.solve(VecX::Ones(n), after);
    EXPECT_TRUE(before == after) << "nothing of the failures is left";
  }
}

TEST(Multifrontal, AnyNumberOfRightHandSides) {
  const rod_matrices::Blocks blocks = rod_matrices::membrane(12, 11);
  const SparsePattern p = blocks.pattern();
  const std::vector<double> v = rod_matrices::values(blocks, p, true);
  LinearSolver solver(p, keep_all(p.size()));
  ASSERT_TRUE(solver.factorize(v).complete);
  for (int columns = 0; columns <= 75; ++columns) {
    const MatX b = random_matrix(p.size(), columns);
    MatX x;
    solver.solve_many(b, x);
    ASSERT_EQ(x.cols(), columns);
    for (int c = 0; c < columns; ++c) {
      VecX single;
      solver.solve(b.col(c), single);
      ASSERT_LT((x.col(c) - single).norm(), 1e-10 * single.norm()) << c << " of " << columns;
    }
    MatX in_place = b;
    solver.solve_many(in_place, in_place);
    EXPECT_TRUE(in_place == x);
  }
}

TEST(Multifrontal, SameBitsForAnyNumberOfThreads) {
  ThreadPool two(2), eight(8);
  for (const bool indefinite : {false, true}) {
    for (const rod_matrices::Blocks& blocks : {rod_matrices::membrane(30, 30), rod_matrices::honeycomb(20, 20, 4)}) {
      const SparsePattern p = blocks.pattern();
      const std::vector<double> v = rod_matrices::values(blocks, p, indefinite);
      const VecX b = random_matrix(p.size(), 1);
      VecX expected;
      FactorReport first;
      for (ThreadPool* pool : {static_cast<ThreadPool*>(nullptr), &two, &eight}) {
        LinearSolver solver(p, keep_all(p.size()), {.threads = pool});
        for (int repeat = 0; repeat < 4; ++repeat) {
          const FactorReport stopped = solver.factorize(v, 0, {}, Indefinite::kStop);
          EXPECT_EQ(stopped.complete, !indefinite);
          const FactorReport report = solver.factorize(v);
          ASSERT_TRUE(report.complete);
          VecX x;
          solver.solve(b, x);
          if (expected.size() == 0) {
            expected = x;
            first = report;
          }
          EXPECT_TRUE(x == expected);
          EXPECT_EQ(report.negative_pivots, first.negative_pivots);
          EXPECT_EQ(report.failed_at, first.failed_at);
          EXPECT_EQ(stopped.failed_at, first.failed_at);
        }
      }
    }
  }
}

/// What the memory of update matrices has to obey, checked against the order in which they come and go.
TEST(Multifrontal, UpdateMatricesThatAreAliveDoNotOverlap) {
  const rod_matrices::Blocks blocks = rod_matrices::honeycomb(12, 12, 4);
  const SparsePattern p = blocks.pattern();
  const multifrontal::Triangle lower = multifrontal::kept_part(p, keep_all(p.size()));
  // In the order of the unknowns themselves, with the columns of the factor as their children hand them on.
  std::vector<int> order = keep_all(p.size()), counts(p.size());
  std::vector<std::vector<int>> columns(p.size());
  for (int j = 0; j < p.size(); ++j) {
    std::vector<int>& column = columns[j];
    for (int s = lower.start[j]; s < lower.start[j + 1]; ++s) column.push_back(lower.row[s]);
    std::sort(column.begin(), column.end());
    column.erase(std::unique(column.begin(), column.end()), column.end());
    counts[j] = static_cast<int>(column.size());
    if (column.size() > 1) columns[column[1]].insert(columns[column[1]].end(), column.begin() + 1, column.end());
  }
  const multifrontal::AssemblyTree tree =
      multifrontal::assembly_tree(multifrontal::permuted_upper(lower, order), counts);
  const multifrontal::Plan plan = multifrontal::make_plan(lower, order, tree);
  ASSERT_GT(tree.fronts(), 20);
  EXPECT_EQ(tree.first_pivot.back(), p.size());
  const auto size = [&](int f) {
    const std::int64_t rows = multifrontal::padded(plan.fronts[f].updates);
    return rows * rows;
  };
  int pairs = 0;
  for (int f = 0; f < tree.fronts(); ++f) {
    EXPECT_LE(plan.fronts[f].update + size(f), plan.updates_size);
    for (int g = f + 1; g < tree.fronts() && (tree.parent[f] < 0 || g <= tree.parent[f]); ++g) {
      if (size(f) == 0 || size(g) == 0) continue;
      const bool apart = plan.fronts[f].update + size(f) <= plan.fronts[g].update ||
                         plan.fronts[g].update + size(g) <= plan.fronts[f].update;
      EXPECT_TRUE(apart) << f << " " << g;
      ++pairs;
    }
  }
  EXPECT_GT(pairs, 20);
}

#ifdef LISSOM_COUNTS_ALLOCATIONS
TEST(Multifrontal, NothingIsAllocatedAfterTheFirstRun) {
  ThreadPool two(2);
  const rod_matrices::Blocks blocks = rod_matrices::membrane(30, 30);
  const SparsePattern p = blocks.pattern();
  const std::vector<double> v = rod_matrices::values(blocks, p), indefinite = rod_matrices::values(blocks, p, true);
  const std::vector<double> metric(p.size(), 1.0);
  for (ThreadPool* pool : {static_cast<ThreadPool*>(nullptr), &two}) {
    LinearSolver solver(p, keep_all(p.size()), {.threads = pool});
    const VecX b = random_matrix(p.size(), 1);
    const MatX many = random_matrix(p.size(), 47);
    VecX x;
    MatX solutions;
    const auto use = [&] {
      solver.factorize(indefinite, 0, {}, Indefinite::kStop);
      const bool ok = solver.factorize(indefinite, 0.5, metric).complete && solver.factorize(v).complete;
      solver.solve(b, x);
      solver.solve_many(many, solutions);
      return ok;
    };
    const long at_first = allocations.load();
    ASSERT_TRUE(use());
    const long before = allocations.load();
    ASSERT_GT(before, at_first) << "the counter counts";
    EXPECT_TRUE(use() && use());
    EXPECT_EQ(allocations.load(), before);
  }
}
#endif

}  // namespace
}  // namespace lissom
