#pragma once
/// Sums of small blocks of a long buffer into a matrix or a vector: what GatherLists does entry by entry, for the parts of
/// stencil blocks that belong to three consecutive unknowns (places, joint rotations). One list entry stands for up to
/// nine numbers, which takes a quarter of the time of reading a place for each.

#include <array>
#include <cstddef>
#include <vector>

#include "lissom/core/parallel.h"

namespace lissom {

/// Where a block stands in the buffer: rows of three entries, at `first` and at the distances given behind it. Four entries
/// are read of each, so the buffer has to go on for one more.
struct BlockSource {
  int first = 0;
  std::array<int, 2> row = {0, 0};
};

/// Sources of one block are added in a fixed order: the same bytes at any number of threads.
class BlockLists {
 public:
  /// Which of the nine entries count, and where they go.
  enum class Part {
    kFull,        ///< all
    kTransposed,  ///< all, rows and columns exchanged
    kLower,       ///< of a diagonal block, on and below the diagonal
    kRow          ///< the first row alone, of a vector
  };
  /// Targets of a block: the first of three (two, one for the lower part) consecutive entries, per column.
  using Columns = std::array<int, 3>;

  void add(Part part, const Columns& target, const BlockSource& source);
  /// Sorts what was added; to be called once, before sums.
  void arrange();

  /// Adds to the targets.
  void sum(const double* buffer, double* target, ThreadPool* threads) const;

 private:
  struct Entry {
    Columns target;
    BlockSource source;
  };
  struct Block {
    Columns target;
    int end;  // of its sources, behind those of the block before
  };
  static constexpr int kParts = 4;

  std::array<std::vector<Entry>, kParts> added_;
  std::array<std::vector<Block>, kParts> blocks_;
  std::array<std::vector<BlockSource>, kParts> sources_;
};

}  // namespace lissom
