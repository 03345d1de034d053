#include "lissom/core/sparse_pattern.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "bench/rod_matrices.h"

namespace lissom {
namespace {

void expect_well_formed(const SparsePattern& p) {
  ASSERT_EQ(p.column_start().front(), 0);
  ASSERT_EQ(p.column_start().back(), p.nonzeros());
  for (int j = 0; j < p.size(); ++j) {
    const auto column = p.row().subspan(p.column_start()[j], p.column_start()[j + 1] - p.column_start()[j]);
    ASSERT_FALSE(column.empty());
    EXPECT_EQ(column[0], j) << "diagonal comes first";
    EXPECT_TRUE(std::is_sorted(column.begin(), column.end()));
    EXPECT_EQ(std::adjacent_find(column.begin(), column.end()), column.end());
    EXPECT_EQ(p.diagonal_slot(j), p.slot(j, j));
  }
}

TEST(SparsePattern, DefaultAndEmptyHaveNoUnknowns) {
  EXPECT_EQ(SparsePattern().size(), 0);
  const SparsePattern none(0, {}, {});
  EXPECT_EQ(none.size(), 0);
  EXPECT_EQ(none.nonzeros(), 0);
}

TEST(SparsePattern, DiagonalIsPresentWithoutGroups) {
  const SparsePattern p(3, {}, {});
  EXPECT_EQ(p.nonzeros(), 3);
  expect_well_formed(p);
  EXPECT_EQ(p.slot(0, 2), -1);
}

TEST(SparsePattern, UnionOfUnsortedGroupsWithRepeatsAndSkippedIndices) {
  const std::vector<int> indices{4, 0, -1, 2, 2, 0, 5, 5, 1};
  const std::vector<int> offsets{0, 4, 7, 7, 9};  // {4,0,2} {2,0,5} {} {5,1}
  const SparsePattern p(6, indices, offsets);
  expect_well_formed(p);
  const std::set<std::pair<int, int>> expected{{4, 0}, {2, 0}, {4, 2}, {5, 2}, {5, 0}, {5, 1}};
  EXPECT_EQ(p.nonzeros(), 6 + static_cast<int>(expected.size()));
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < i; ++j) {
      const bool present = expected.contains({i, j});
      EXPECT_EQ(p.slot(i, j) >= 0, present) << i << ' ' << j;
      EXPECT_EQ(p.slot(i, j), p.slot(j, i));
      if (present) {
        EXPECT_EQ(p.row()[p.slot(i, j)], i);
      }
    }
  }
}

TEST(SparsePattern, MatchesSetsOnAHoneycomb) {
  const rod_matrices::Blocks b = rod_matrices::honeycomb(5, 6, 3);
  const SparsePattern p = b.pattern();
  expect_well_formed(p);
  std::set<std::pair<int, int>> expected;
  for (int i = 0; i < b.size; ++i) expected.emplace(i, i);
  for (std::size_t g = 0; g + 1 < b.offsets.size(); ++g) {
    for (int s = b.offsets[g]; s < b.offsets[g + 1]; ++s) {
      for (int t = b.offsets[g]; t < b.offsets[g + 1]; ++t) {
        expected.emplace(std::max(b.indices[s], b.indices[t]), std::min(b.indices[s], b.indices[t]));
      }
    }
  }
  EXPECT_EQ(p.nonzeros(), static_cast<int>(expected.size()));
  for (const auto& [i, j] : expected) ASSERT_GE(p.slot(i, j), 0);
}

TEST(Multiply, AgreesWithTheDenseProduct) {
  const rod_matrices::Blocks b = rod_matrices::honeycomb(2, 3, 3);
  const SparsePattern p = b.pattern();
  const std::vector<double> v = rod_matrices::values(b, p, true);
  MatX dense = MatX::Zero(b.size, b.size);
  for (int i = 0; i < b.size; ++i) {
    for (int j = 0; j < b.size; ++j) {
      if (p.slot(i, j) >= 0) dense(i, j) = v[p.slot(i, j)];
    }
  }
  const VecX x = VecX::LinSpaced(b.size, -1, 2);
  VecX y;
  multiply(p, v, x, y);
  EXPECT_LT((y - dense * x).norm(), 1e-13 * y.norm());
}

}  // namespace
}  // namespace lissom
