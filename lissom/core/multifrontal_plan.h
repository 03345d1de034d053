#pragma once
/// All that a multifrontal factorisation of one pattern needs to know beforehand: where every number goes.
///
/// Duff and Reid, The multifrontal solution of indefinite sparse symmetric linear equations, 1983; Liu, The multifrontal
/// method for sparse matrix solution, 1992. The panel of a front (multifrontal_kernels.h) is its part of the factor and
/// is assembled where it stays. Update matrices have fixed places in one buffer, planned so that those which are alive
/// together do not overlap; the planning takes the place of a stack and of its copying.

#include <cstdint>
#include <span>
#include <vector>

#include "lissom/core/multifrontal_matrix.h"
#include "lissom/core/multifrontal_tree.h"

namespace lissom::multifrontal {

struct Front {
  int first = 0;    ///< pivot
  int pivots = 0;   ///< rows eliminated in it
  int updates = 0;  ///< rows of its update matrix
  int shared = 0;   ///< rows of the update matrix that are pivots of the parent
  int parent = -1;
  std::int64_t panel = 0;   ///< place in the factor
  std::int64_t update = 0;  ///< place among the update matrices
  int rows = 0;             ///< of the update matrix: place in Plan::row and Plan::place
  int runs = 0;             ///< place in Plan::run, up to that of the next front
  int entries = 0;          ///< of the matrix: place in Plan::entry, up to that of the next front
  int children = 0;         ///< place in Plan::child, up to that of the next front

  int stride() const;
};

struct Plan {
  int unknowns = 0;
  std::vector<int> order;     ///< unknown eliminated k-th
  std::vector<Front> fronts;  ///< children before parents; one more at the end, which closes the ranges
  std::vector<int> child;     ///< fronts
  std::vector<int> row;       ///< pivots that the rows of update matrices stand for, ascending
  std::vector<int> place;     ///< rows of the parent's panel that they are added to

  /// Neighbouring rows of an update matrix that are neighbours in the parent too.
  struct Run {
    int begin = 0, end = 0;  ///< in the update matrix
    bool last = false;       ///< of its update matrix
  };
  std::vector<Run> run;

  /// Entry of the matrix: where it comes from, and its place in the panel of its front.
  struct Entry {
    int source = 0, place = 0;
  };
  std::vector<Entry> entry;

  /// Fronts that belong to whole subtrees: threads can take parts at once. What is above them follows, `top`. The cut
  /// depends on nothing but the tree.
  struct Part {
    int begin = 0, end = 0;    ///< fronts
    std::int64_t scratch = 0;  ///< place of its own, for when it is not alone
  };
  std::vector<Part> parts;
  std::vector<int> top;

  std::int64_t factor_size = 0;   ///< doubles
  std::int64_t updates_size = 0;  ///< doubles
  std::int64_t scratch_size = 0;  ///< doubles, for all parts at once
  int most_rows = 0;              ///< padded, of the largest front
};

/// `lower` in any order; `order` as found by the ordering, to which `tree` belongs.
Plan make_plan(const Triangle& lower, std::span<const int> order, const AssemblyTree& tree);

}  // namespace lissom::multifrontal
