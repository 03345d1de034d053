#pragma once
/// The assembly tree: which unknowns are eliminated together, and in what order.
///
/// Columns of the factor with the same pattern make one front (supernodes); fronts are then joined with their parents
/// where the zeros that this adds cost less time than one front more (relaxed supernodes; after Ashcraft and Grimes,
/// The influence of relaxed supernode partitions on the multifrontal method, 1989, with a model of time in place of
/// their count of zeros).

#include <span>
#include <vector>

#include "lissom/core/multifrontal_matrix.h"

namespace lissom::multifrontal {

struct AssemblyTree {
  std::vector<int> order;        ///< column eliminated k-th
  std::vector<int> first_pivot;  ///< of each front, and the number of columns at the end
  std::vector<int> updates;      ///< rows of each front that are not eliminated in it
  std::vector<int> parent;       ///< of each front, greater than the front; -1 at roots
  double time = 0;               ///< s, estimate for a factorisation by one thread

  int fronts() const { return static_cast<int>(parent.size()); }
};

/// For a matrix in its order of elimination, a postorder of its elimination tree at best, so that supernodes stand
/// together. `column_counts` are those of its factor, diagonal included.
AssemblyTree assembly_tree(const Triangle& upper, std::span<const int> column_counts);

/// s, for assembling a front, eliminating its pivots, and adding its update to the parent.
double front_time(double pivots, double updates);

}  // namespace lissom::multifrontal
