#include "lissom/core/eigen_solver.h"

#include <Eigen/Eigenvalues>
#include <chrono>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

#include "bench/rod_matrices.h"

namespace lissom {
namespace {

constexpr double kPi = std::numbers::pi;

struct Pencil {
  SparsePattern pattern;
  std::vector<double> values;
  std::vector<double> metric;
};

std::vector<int> keep_all(int n) {
  std::vector<int> kept(n);
  std::iota(kept.begin(), kept.end(), 0);
  return kept;
}

/// `copies` interleaved beams: squared second difference on n points with simple supports, so that the eigenvalues are
/// (2 - 2 cos(k pi / (n + 1)))^2, each `copies` times.
Pencil beams(int n, int copies) {
  rod_matrices::Blocks b;
  b.size = n * copies;
  for (int c = 0; c < copies; ++c) {
    for (int i = 0; i < n; ++i) {
      for (int k = std::max(i - 1, 0); k <= std::min(i + 1, n - 1); ++k) b.indices.push_back(k * copies + c);
      b.offsets.push_back(static_cast<int>(b.indices.size()));
    }
  }
  Pencil p{b.pattern(), {}, std::vector<double>(b.size, 1.0)};
  p.values.assign(p.pattern.nonzeros(), 0.0);
  for (int c = 0; c < copies; ++c) {
    for (int i = 0; i < n; ++i) {  // row i of the second difference, squared
      for (int s = -1; s <= 1; ++s) {
        for (int t = -1; t <= s; ++t) {
          const int a = i + s;
          const int d = i + t;
          if (a < 0 || d < 0 || a >= n || d >= n) continue;
          p.values[p.pattern.slot(a * copies + c, d * copies + c)] += (s == 0 ? -2.0 : 1.0) * (t == 0 ? -2.0 : 1.0);
        }
      }
    }
  }
  return p;
}

double beam_value(int n, int k) {
  const double s = std::sin(k * kPi / (2 * (n + 1)));
  return 16 * s * s * s * s;
}

EigenPairs solve(const Pencil& p, double shift, int count) {
  LinearSolver solver(p.pattern, keep_all(p.pattern.size()));
  const FactorReport report = solver.factorize(p.values, shift, p.metric);
  EXPECT_TRUE(report.positive_definite);
  return lowest_eigenpairs(solver, shift, p.metric, count);
}

/// Residual of each pair against the size of its terms, and M-orthonormality of all.
void expect_pairs(const Pencil& p, const EigenPairs& e, double tolerance) {
  const Eigen::Map<const VecX> m(p.metric.data(), p.pattern.size());
  double scale = 0;
  for (const double v : p.values) scale = std::max(scale, std::abs(v));
  VecX ku;
  for (Eigen::Index i = 0; i < e.values.size(); ++i) {
    const VecX u = e.vectors.col(i);
    multiply(p.pattern, p.values, u, ku);
    EXPECT_LT((ku - e.values[i] * m.cwiseProduct(u)).norm(), tolerance * scale * u.norm()) << "pair " << i;
    if (i > 0) {
      EXPECT_LE(e.values[i - 1], e.values[i]);
    }
  }
  const MatX gram = e.vectors.transpose() * m.asDiagonal() * e.vectors;
  EXPECT_LT((gram - MatX::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff(), 1e-10);
}

VecX dense_values(const Pencil& p) {
  const int n = p.pattern.size();
  MatX k = MatX::Zero(n, n);
  for (int j = 0; j < n; ++j) {
    for (int s = p.pattern.column_start()[j]; s < p.pattern.column_start()[j + 1]; ++s) {
      k(p.pattern.row()[s], j) = k(j, p.pattern.row()[s]) = p.values[s];
    }
  }
  const VecX scale = Eigen::Map<const VecX>(p.metric.data(), n).cwiseSqrt().cwiseInverse();
  return Eigen::SelfAdjointEigenSolver<MatX>(scale.asDiagonal() * k * scale.asDiagonal(), Eigen::EigenvaluesOnly)
      .eigenvalues();
}

TEST(LowestEigenpairs, FindsEveryCopyOfMultipleEigenvalues) {
  int checked = 0;
  for (const int copies : {1, 2, 3, 7}) {
    for (const int count : {1, 2, 5, 12}) {
      const Pencil p = beams(150, copies);
      const EigenPairs e = solve(p, 0, count);
      ASSERT_TRUE(e.converged);
      ASSERT_EQ(e.values.size(), count);
      for (int i = 0; i < count; ++i) {
        const double expected = beam_value(150, i / copies + 1);
        EXPECT_NEAR(e.values[i], expected, 1e-8 * expected) << copies << " copies, value " << i;
        ++checked;
      }
      expect_pairs(p, e, 1e-9);
    }
  }
  EXPECT_EQ(checked, 4 * 20);
}

TEST(LowestEigenpairs, ShiftLeavesTheValuesWhereTheyAre) {
  const Pencil p = beams(60, 2);
  for (const double shift : {1e-6, 1e-3, 1.0}) {
    const EigenPairs e = solve(p, shift, 6);
    ASSERT_TRUE(e.converged) << shift;
    for (int i = 0; i < 6; ++i) {
      const double expected = beam_value(60, i / 2 + 1);
      EXPECT_NEAR(e.values[i], expected, 1e-8 * expected + 1e-14 * shift);
    }
  }
}

TEST(LowestEigenpairs, RigidMotionsAndManyFreeSpinsAreZeros) {
  // 30 separate chains of springs: 30 zero eigenvalues, more than asked for, behind a tiny shift.
  const int n = 20;
  const int chains = 30;
  std::vector<int> indices;
  std::vector<int> offsets{0};
  for (int c = 0; c < chains; ++c) {
    for (int i = 0; i + 1 < n; ++i) {
      indices.insert(indices.end(), {c * n + i, c * n + i + 1});
      offsets.push_back(static_cast<int>(indices.size()));
    }
  }
  Pencil p{SparsePattern(n * chains, indices, offsets), {}, std::vector<double>(n * chains, 1.0)};
  p.values.assign(p.pattern.nonzeros(), 0.0);
  for (std::size_t g = 0; g + 1 < offsets.size(); ++g) {
    const int i = indices[offsets[g]];
    p.values[p.pattern.slot(i, i)] += 1;
    p.values[p.pattern.slot(i + 1, i + 1)] += 1;
    p.values[p.pattern.slot(i, i + 1)] -= 1;
  }
  const EigenPairs some = solve(p, 1e-5, 10);
  ASSERT_TRUE(some.converged);
  EXPECT_LT(some.values.cwiseAbs().maxCoeff(), 1e-12);
  const EigenPairs all = solve(p, 1e-5, 34);
  ASSERT_TRUE(all.converged);
  EXPECT_LT(all.values.head(30).cwiseAbs().maxCoeff(), 1e-12);
  const double first = 2 - 2 * std::cos(kPi / n);
  for (int i = 30; i < 34; ++i) EXPECT_NEAR(all.values[i], first, 1e-8 * first);
  expect_pairs(p, all, 1e-9);
}

TEST(LowestEigenpairs, NegativeValuesOfAnIndefiniteMatrixMatchTheDenseSolver) {
  for (const rod_matrices::Blocks& b : {rod_matrices::chain(60), rod_matrices::honeycomb(4, 5, 3)}) {
    Pencil p{b.pattern(), {}, {}};
    p.values = rod_matrices::values(b, p.pattern, true);
    for (int i = 0; i < b.size; ++i) p.metric.push_back(0.5 + i % 4);
    const VecX expected = dense_values(p);
    ASSERT_LT(expected[5], 0);
    for (const double margin : {0.01, 1.0, 30.0}) {
      const EigenPairs e = solve(p, margin - expected[0], 8);
      ASSERT_TRUE(e.converged);
      for (int i = 0; i < 8; ++i) EXPECT_NEAR(e.values[i], expected[i], 1e-8 * std::abs(expected[i])) << i;
      expect_pairs(p, e, 1e-9);
    }
  }
}

TEST(LowestEigenpairs, MasslessUnknownsFollowTheOthers) {
  for (const int period : {2, 3, 10}) {
    const rod_matrices::Blocks b = rod_matrices::honeycomb(3, 4, 3);
    Pencil p{b.pattern(), {}, {}};
    p.values = rod_matrices::values(b, p.pattern);
    std::vector<int> massive;
    for (int i = 0; i < b.size; ++i) {
      const bool has_mass = i % period == 0;
      p.metric.push_back(has_mass ? 1.0 + i % 3 : 0.0);
      if (has_mass) massive.push_back(i);
    }
    // Oracle: 1 / mu are the eigenvalues of sqrt(M) K^-1 sqrt(M).
    MatX k = MatX::Zero(b.size, b.size);
    for (int j = 0; j < b.size; ++j) {
      for (int s = p.pattern.column_start()[j]; s < p.pattern.column_start()[j + 1]; ++s) {
        k(p.pattern.row()[s], j) = k(j, p.pattern.row()[s]) = p.values[s];
      }
    }
    const VecX root = Eigen::Map<const VecX>(p.metric.data(), b.size).cwiseSqrt();
    const MatX flexibility = root.asDiagonal() * k.inverse() * root.asDiagonal();
    const VecX nu = Eigen::SelfAdjointEigenSolver<MatX>(flexibility).eigenvalues().reverse();

    const EigenPairs e = solve(p, 0, 9);
    ASSERT_TRUE(e.converged);
    for (int i = 0; i < 9; ++i) EXPECT_NEAR(e.values[i] * nu[i], 1, 1e-8);
    expect_pairs(p, e, 1e-9);

    // As many pairs as there are masses, never more.
    const EigenPairs all = solve(p, 0, b.size);
    EXPECT_TRUE(all.converged);
    ASSERT_EQ(all.values.size(), static_cast<Eigen::Index>(massive.size()));
    for (Eigen::Index i = 0; i < all.values.size(); ++i) EXPECT_NEAR(all.values[i] * nu[i], 1, 1e-7);
  }
}

TEST(LowestEigenpairs, SmallestProblems) {
  Pencil one{SparsePattern(1, {}, {}), {6.0}, {2.0}};
  const EigenPairs e = solve(one, 1, 3);
  ASSERT_TRUE(e.converged);
  ASSERT_EQ(e.values.size(), 1);
  EXPECT_NEAR(e.values[0], 3, 1e-14);
  EXPECT_NEAR(std::abs(e.vectors(0, 0)), std::sqrt(0.5), 1e-14);
  one.metric[0] = 0;
  EXPECT_EQ(solve(one, 0, 1).values.size(), 0);
  const Pencil none{SparsePattern(0, {}, {}), {}, {}};
  EXPECT_TRUE(solve(none, 0, 2).converged);
  EXPECT_EQ(solve(beams(5, 1), 0, 0).values.size(), 0);
}

TEST(LowestEigenpairs, SameInputSameBits) {
  const Pencil p = beams(100, 2);
  const EigenPairs a = solve(p, 0, 4);
  const EigenPairs b = solve(p, 0, 4);
  EXPECT_TRUE(a.values == b.values);
  EXPECT_TRUE(a.vectors == b.vectors);
}

TEST(LowestEigenpairs, StaysCheap) {
  const auto begin = std::chrono::steady_clock::now();
  const EigenPairs modes = solve(beams(2000, 2), 0, 40);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  ASSERT_TRUE(modes.converged);
  RecordProperty("seconds_40_modes", std::to_string(seconds));
  EXPECT_LE(modes.solves, 8 * 44);
  for (int i = 0; i < 40; ++i) {
    const double expected = beam_value(2000, i / 2 + 1);
    EXPECT_NEAR(modes.values[i], expected, 1e-4 * expected) << "rounding of K divided by mu: 1e-16 * 16 / 6e-12";
  }
  const EigenPairs few = solve(beams(7500, 2), 1e-12, 4);
  ASSERT_TRUE(few.converged);
  EXPECT_LE(few.solves, 9 * 8);
}

}  // namespace
}  // namespace lissom
