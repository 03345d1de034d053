#include "lissom/core/sparse_pattern.h"

#include <algorithm>
#include <limits>

#include "lissom/core/assert.h"

namespace lissom {

SparsePattern::SparsePattern(int n, std::span<const int> indices, std::span<const int> offsets) {
  LISSOM_ASSERT(n >= 0);
  const int groups = offsets.empty() ? 0 : static_cast<int>(offsets.size()) - 1;

  // Groups that each index belongs to, in compressed form.
  std::vector<int> member_start(static_cast<std::size_t>(n) + 1, 0);
  for (int g = 0; g < groups; ++g) {
    for (int k = offsets[g]; k < offsets[g + 1]; ++k) {
      LISSOM_ASSERT(indices[k] < n);
      if (indices[k] >= 0) ++member_start[indices[k] + 1];
    }
  }
  for (int j = 0; j < n; ++j) member_start[j + 1] += member_start[j];
  std::vector<int> member(member_start[n]);
  {
    std::vector<int> fill(member_start.begin(), member_start.end() - 1);
    for (int g = 0; g < groups; ++g) {
      for (int k = offsets[g]; k < offsets[g + 1]; ++k) {
        if (indices[k] >= 0) member[fill[indices[k]]++] = g;
      }
    }
  }

  column_start_.assign(static_cast<std::size_t>(n) + 1, 0);
  row_.reserve(static_cast<std::size_t>(n) + member.size());
  std::vector<int> seen_in(n, -1);  // last column that has taken this row
  for (int j = 0; j < n; ++j) {
    row_.push_back(j);
    seen_in[j] = j;
    for (int m = member_start[j]; m < member_start[j + 1]; ++m) {
      for (int k = offsets[member[m]]; k < offsets[member[m] + 1]; ++k) {
        const int i = indices[k];
        if (i > j && seen_in[i] != j) {
          seen_in[i] = j;
          row_.push_back(i);
        }
      }
    }
    std::sort(row_.begin() + column_start_[j], row_.end());
    LISSOM_ASSERT(row_.size() < static_cast<std::size_t>(std::numeric_limits<int>::max()));
    column_start_[j + 1] = static_cast<int>(row_.size());
  }
  row_.shrink_to_fit();
}

int SparsePattern::slot(int i, int j) const {
  if (i < j) std::swap(i, j);
  const auto begin = row_.begin() + column_start_[j];
  const auto end = row_.begin() + column_start_[j + 1];
  const auto place = std::lower_bound(begin, end, i);
  return place != end && *place == i ? static_cast<int>(place - row_.begin()) : -1;
}

void multiply(const SparsePattern& pattern, std::span<const double> values, const VecX& x, VecX& y) {
  const int n = pattern.size();
  LISSOM_ASSERT(x.size() == n && &x != &y && values.size() == static_cast<std::size_t>(pattern.nonzeros()));
  const std::span<const int> start = pattern.column_start();
  const std::span<const int> row = pattern.row();
  y.setZero(n);
  for (int j = 0; j < n; ++j) {
    const double xj = x[j];
    double sum = values[start[j]] * xj;
    for (int p = start[j] + 1; p < start[j + 1]; ++p) {
      sum += values[p] * x[row[p]];
      y[row[p]] += values[p] * xj;
    }
    y[j] += sum;
  }
}

}  // namespace lissom
