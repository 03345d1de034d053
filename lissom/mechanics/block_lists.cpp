#include "lissom/mechanics/block_lists.h"

#include <algorithm>
#include <cstring>
#include <tuple>

namespace lissom {

namespace {

constexpr int kGrain = 1024;

typedef double Row __attribute__((vector_size(4 * sizeof(double))));

[[gnu::always_inline]] inline Row load(const double* p) {
  Row row;
  std::memcpy(&row, p, sizeof row);
  return row;
}

struct Rows {
  double entry[3][4];
};

template <int Count>
Rows sum_rows(const double* buffer, const BlockSource* begin, const BlockSource* end) {
  Row row[3] = {};
  for (const BlockSource* s = begin; s != end; ++s) {
    const double* first = buffer + s->first;
    row[0] += load(first);
    if constexpr (Count == 3) {
      row[1] += load(first + s->row[0]);
      row[2] += load(first + s->row[1]);
    }
  }
  Rows rows;
  for (int r = 0; r < Count; ++r) std::memcpy(rows.entry[r], &row[r], sizeof row[r]);
  return rows;
}

}  // namespace

void BlockLists::add(Part part, const Columns& target, const BlockSource& source) {
  const Shape shape = part == Part::kLower ? Shape::kLower : part == Part::kRow ? Shape::kRow : Shape::kPair;
  lists_[static_cast<int>(shape)].added.push_back({target, part == Part::kTransposed, source});
}

void BlockLists::List::arrange() {
  // Equal targets together, in the order in which they were added.
  std::stable_sort(added.begin(), added.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.target[0], a.transposed) < std::tie(b.target[0], b.transposed);
  });
  sources.reserve(added.size());
  for (std::size_t i = 0; i < added.size(); ++i) {
    if (i == 0 || added[i].target[0] != added[i - 1].target[0]) {
      blocks.push_back({added[i].target, static_cast<int>(i), static_cast<int>(i)});
    }
    sources.push_back(added[i].source);
    ++blocks.back().end;
    if (!added[i].transposed) ++blocks.back().plain_end;
  }
  added = {};
}

void BlockLists::arrange() {
  for (int k = 0; k < kShapes; ++k) {
    lists_[k].arrange();
    const int blocks = static_cast<int>(lists_[k].blocks.size());
    for (int begin = 0; begin < blocks; begin += kGrain) {
      pieces_.push_back({static_cast<Shape>(k), begin, std::min(blocks, begin + kGrain)});
    }
  }
}

template <BlockLists::Shape S>
void BlockLists::sum_blocks(const List& list, int begin, int end, const double* buffer, double* target) {
  const BlockSource* next = list.sources.data() + (begin > 0 ? list.blocks[begin - 1].end : 0);
  for (int i = begin; i < end; ++i) {
    const Block& block = list.blocks[i];
    const BlockSource* plain_end = list.sources.data() + block.plain_end;
    const BlockSource* last = list.sources.data() + block.end;
    const Rows sum = sum_rows < S == Shape::kRow ? 1 : 3 > (buffer, next, plain_end);
    if constexpr (S == Shape::kRow) {
      for (int r = 0; r < 3; ++r) target[block.target[0] + r] = sum.entry[0][r];
    } else if constexpr (S == Shape::kLower) {
      for (int c = 0; c < 3; ++c) {
        for (int r = c; r < 3; ++r) target[block.target[c] + r - c] = sum.entry[r][c];
      }
    } else {
      const Rows turned = sum_rows<3>(buffer, plain_end, last);
      for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) target[block.target[c] + r] = sum.entry[r][c] + turned.entry[c][r];
      }
    }
    next = last;
  }
}

void BlockLists::mark_targets(std::vector<bool>& written) const {
  const auto mark = [&](int first, int count) { std::fill_n(written.begin() + first, count, true); };
  for (const Block& block : lists_[static_cast<int>(Shape::kRow)].blocks) mark(block.target[0], 3);
  for (int c = 0; c < 3; ++c) {
    for (const Block& block : lists_[static_cast<int>(Shape::kLower)].blocks) mark(block.target[c], 3 - c);
    for (const Block& block : lists_[static_cast<int>(Shape::kPair)].blocks) mark(block.target[c], 3);
  }
}

void BlockLists::sum_piece(int piece, const double* buffer, double* target) const {
  const auto [shape, begin, end] = pieces_[piece];
  const List& list = lists_[static_cast<int>(shape)];
  switch (shape) {
    case Shape::kPair:
      return sum_blocks<Shape::kPair>(list, begin, end, buffer, target);
    case Shape::kLower:
      return sum_blocks<Shape::kLower>(list, begin, end, buffer, target);
    case Shape::kRow:
      return sum_blocks<Shape::kRow>(list, begin, end, buffer, target);
  }
}

}  // namespace lissom
