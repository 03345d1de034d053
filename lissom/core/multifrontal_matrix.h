#pragma once
/// Triangles of sparse symmetric matrices, as the analysis of the sparse solver passes them on.

#include <span>
#include <vector>

#include "lissom/core/sparse_pattern.h"

namespace lissom::multifrontal {

/// A triangle of a symmetric matrix by columns, the diagonal included.
struct Triangle {
  std::vector<int> start;
  std::vector<int> row;
  std::vector<int> source;  ///< slot in the full pattern that each entry comes from

  int size() const { return static_cast<int>(start.size()) - 1; }
};

/// Lower triangle of the rows and columns with kept[i] >= 0, their new numbers; rows ascending.
Triangle kept_part(const SparsePattern& pattern, std::span<const int> kept);

/// The same matrix with row and column `order[k]` in place k, as an upper triangle, rows ascending.
Triangle permuted_upper(const Triangle& t, std::span<const int> order);

/// The other triangle; rows ascend whatever their order in `t`.
Triangle transposed(const Triangle& t);

}  // namespace lissom::multifrontal
