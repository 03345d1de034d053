#include "lissom/mechanics/block_lists.h"

#include <algorithm>
#include <cstring>

namespace lissom {

namespace {

constexpr int kGrain = 1024;
using Part = BlockLists::Part;

typedef double Row __attribute__((vector_size(4 * sizeof(double))));

[[gnu::always_inline]] inline Row load(const double* p) {
  Row row;
  std::memcpy(&row, p, sizeof row);
  return row;
}

template <Part P>
void sum_block(const double* buffer, const BlockSource* begin, const BlockSource* end,
               const BlockLists::Columns& target, double* out) {
  constexpr int kRows = P == Part::kRow ? 1 : 3;
  Row row0 = {}, row1 = {}, row2 = {};
  for (const BlockSource* s = begin; s != end; ++s) {
    const double* first = buffer + s->first;
    row0 += load(first);
    if constexpr (kRows == 3) {
      row1 += load(first + s->row[0]);
      row2 += load(first + s->row[1]);
    }
  }
  double sum[3][4];
  std::memcpy(sum[0], &row0, sizeof row0);
  std::memcpy(sum[1], &row1, sizeof row1);
  std::memcpy(sum[2], &row2, sizeof row2);
  for (int c = 0; c < (P == Part::kRow ? 1 : 3); ++c) {
    double* column = out + target[c];
    if constexpr (P == Part::kFull) {
      for (int r = 0; r < 3; ++r) column[r] += sum[r][c];
    } else if constexpr (P == Part::kTransposed) {
      for (int r = 0; r < 3; ++r) column[r] += sum[c][r];
    } else if constexpr (P == Part::kLower) {
      for (int r = c; r < 3; ++r) column[r - c] += sum[r][c];
    } else {
      for (int r = 0; r < 3; ++r) column[r] += sum[0][r];
    }
  }
}

template <Part P, class Block>
void sum_all(const std::vector<Block>& blocks, const std::vector<BlockSource>& sources, const double* buffer,
             double* out, ThreadPool* threads) {
  parallel_for(threads, static_cast<int>(blocks.size()), kGrain, [&](int begin, int end) {
    const BlockSource* next = sources.data() + (begin > 0 ? blocks[begin - 1].end : 0);
    for (int i = begin; i < end; ++i) {
      const BlockSource* last = sources.data() + blocks[i].end;
      sum_block<P>(buffer, next, last, blocks[i].target, out);
      next = last;
    }
  });
}

}  // namespace

void BlockLists::add(Part part, const Columns& target, const BlockSource& source) {
  added_[static_cast<int>(part)].push_back({target, source});
}

void BlockLists::arrange() {
  for (int p = 0; p < kParts; ++p) {
    std::vector<Entry>& added = added_[p];
    // Equal targets together, in the order in which they were added.
    std::stable_sort(added.begin(), added.end(),
                     [](const Entry& a, const Entry& b) { return a.target[0] < b.target[0]; });
    struct Run {
      std::size_t begin, end;
    };
    std::vector<Run> runs;
    for (std::size_t i = 0; i < added.size(); ++i) {
      if (i == 0 || added[i].target[0] != added[i - 1].target[0]) runs.push_back({i, i});
      runs.back().end = i + 1;
    }
    // In the order of the buffer, as far as that goes: what is read is then still in the cache when it is read again.
    std::sort(runs.begin(), runs.end(), [&](const Run& a, const Run& b) {
      return added[a.end - 1].source.first < added[b.end - 1].source.first;
    });
    sources_[p].reserve(added.size());
    blocks_[p].reserve(runs.size());
    for (const Run& run : runs) {
      for (std::size_t i = run.begin; i < run.end; ++i) sources_[p].push_back(added[i].source);
      blocks_[p].push_back({added[run.begin].target, static_cast<int>(sources_[p].size())});
    }
    added = {};
  }
}

void BlockLists::sum(const double* buffer, double* target, ThreadPool* threads) const {
  const auto part = [&]<Part P>() {
    constexpr int kIndex = static_cast<int>(P);
    sum_all<P>(blocks_[kIndex], sources_[kIndex], buffer, target, threads);
  };
  part.template operator()<Part::kFull>();
  part.template operator()<Part::kTransposed>();
  part.template operator()<Part::kLower>();
  part.template operator()<Part::kRow>();
}

}  // namespace lissom
