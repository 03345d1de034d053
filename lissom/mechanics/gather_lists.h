#pragma once
/// Sums of a long buffer into a shorter vector, each entry from fixed places in a fixed order: the same bytes at any
/// number of threads. Entries with equally many places stand together, so that the inner loop has a constant length.

#include <cstddef>
#include <vector>

namespace lissom {

class GatherLists {
 public:
  GatherLists() = default;

  /// `visit(emit)` calls emit(target, place) for every pair, in the same order each of the two times it is called. All
  /// places are below 2^31. `holds_sum`, one per target: those to whose value the sum is added; the others are overwritten,
  /// by 0 where they have no place.
  template <class Visit>
  GatherLists(const std::vector<bool>& holds_sum, const Visit& visit) {
    std::vector<int> count(holds_sum.size(), 0);
    visit([&](int target, std::ptrdiff_t) { ++count[target]; });
    const std::vector<std::ptrdiff_t> first = arrange(count, holds_sum);
    std::vector<std::ptrdiff_t> next = first;
    visit([&](int target, std::ptrdiff_t place) { place_[next[target]++] = static_cast<int>(place); });
  }

  /// The work is cut into pieces that may run on any thread.
  int pieces() const { return static_cast<int>(pieces_.size()); }
  void sum_piece(int piece, const double* buffer, double* target) const;

 private:
  /// Targets with the same number of places, all of which hold a sum or none.
  struct Run {
    int count = 0;
    bool adds = false;
    std::ptrdiff_t begin = 0, end = 0, first_place = 0;
  };

  /// Sorts the targets into runs; returns where the places of each begin.
  std::vector<std::ptrdiff_t> arrange(const std::vector<int>& count, const std::vector<bool>& holds_sum);

  std::vector<Run> runs_, pieces_;
  std::vector<int> target_;
  std::vector<int> place_;
};

}  // namespace lissom
