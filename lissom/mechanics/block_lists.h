#pragma once
/// Sums of small blocks of a long buffer into a matrix or a vector: what GatherLists does entry by entry, for the parts of
/// stencil blocks that belong to three consecutive unknowns (places, joint rotations). One list entry stands for up to
/// nine numbers, which takes a quarter of the time of reading a place for each.

#include <array>
#include <cstddef>
#include <vector>

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
  /// Sorts what was added; to be called once, before anything is summed.
  void arrange();

  /// The sums are cut into pieces that may run on any thread, each of which overwrites targets of its own.
  int pieces() const { return static_cast<int>(pieces_.size()); }
  void sum_piece(int piece, const double* buffer, double* target) const;
  /// Marks the targets that the pieces write.
  void mark_targets(std::vector<bool>& written) const;

 private:
  enum class Shape { kPair, kLower, kRow };
  static constexpr int kShapes = 3;
  struct Entry {
    Columns target;
    bool transposed;
    BlockSource source;
  };
  struct Block {
    Columns target;
    int plain_end, end;  // of its sources, behind those of the block before: as they stand, then transposed
  };
  struct Piece {
    Shape shape;
    int begin, end;  // blocks
  };
  struct List {
    std::vector<Entry> added;
    std::vector<Block> blocks;
    std::vector<BlockSource> sources;

    void arrange();
  };

  template <Shape S>
  static void sum_blocks(const List& list, int begin, int end, const double* buffer, double* target);

  std::array<List, kShapes> lists_;
  std::vector<Piece> pieces_;
};

}  // namespace lissom
