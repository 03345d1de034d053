#pragma once
/// Fixed sparsity of a symmetric matrix: built once, then only its values change.

#include <span>
#include <utility>
#include <vector>

#include "lissom/core/types.h"

namespace lissom {

/// Lower triangle with full diagonal, compressed by columns, rows ascending; the diagonal entry comes first in its
/// column.
class SparsePattern {
 public:
  SparsePattern() = default;

  /// Pattern of the sum of dense symmetric blocks, one per group of indices in [0, n). The diagonal is always present.
  /// `offsets` has one entry more than there are groups; group g holds indices[offsets[g] .. offsets[g+1]).
  /// Negative indices are skipped.
  SparsePattern(int n, std::span<const int> indices, std::span<const int> offsets);

  int size() const { return static_cast<int>(column_start_.size()) - 1; }
  int nonzeros() const { return static_cast<int>(row_.size()); }
  std::span<const int> column_start() const { return column_start_; }
  std::span<const int> row() const { return row_; }

  /// Place of entry (i, j), in either order, among the values; -1 when it is not in the pattern.
  int slot(int i, int j) const;
  int diagonal_slot(int i) const { return column_start_[i]; }

 private:
  std::vector<int> column_start_{0};
  std::vector<int> row_;
};

/// y = A x for the symmetric matrix with this pattern and these values. y must not be x.
void multiply(const SparsePattern& pattern, std::span<const double> values, const VecX& x, VecX& y);

}  // namespace lissom
