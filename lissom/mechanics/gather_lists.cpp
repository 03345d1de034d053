#include "lissom/mechanics/gather_lists.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace lissom {

namespace {

constexpr int kGrain = 4096;  // targets of a piece

/// `Count` places per target; 0: as many as `count` says.
template <bool Adds, int Count>
void sum_run(const double* buffer, const int* target, const int* place, int count, int targets, double* out) {
  const int n = Count > 0 ? Count : count;
  for (int i = 0; i < targets; ++i, place += n) {
    double sum = 0;
    for (int k = 0; k < n; ++k) sum += buffer[place[k]];
    if constexpr (Adds) {
      out[target[i]] += sum;
    } else {
      out[target[i]] = sum;
    }
  }
}

/// By number of places; the first serves all others.
using SumRun = void (*)(const double*, const int*, const int*, int, int, double*);
template <bool Adds>
constexpr std::array<SumRun, 9> kSumRun = {sum_run<Adds, 0>, sum_run<Adds, 1>, sum_run<Adds, 2>,
                                           sum_run<Adds, 3>, sum_run<Adds, 4>, sum_run<Adds, 5>,
                                           sum_run<Adds, 6>, sum_run<Adds, 7>, sum_run<Adds, 8>};

}  // namespace

std::vector<std::ptrdiff_t> GatherLists::arrange(const std::vector<int>& count, const std::vector<bool>& holds_sum) {
  target_.resize(count.size());
  std::iota(target_.begin(), target_.end(), 0);
  std::stable_sort(target_.begin(), target_.end(), [&](int a, int b) {
    return std::pair(bool{holds_sum[a]}, count[a]) < std::pair(bool{holds_sum[b]}, count[b]);
  });
  std::vector<std::ptrdiff_t> first(count.size(), 0);
  std::ptrdiff_t place = 0;
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(target_.size()); ++i) {
    const int n = count[target_[i]];
    const bool adds = holds_sum[target_[i]];
    if (n == 0 && adds) continue;
    if (runs_.empty() || runs_.back().count != n || runs_.back().adds != adds) runs_.push_back({n, adds, i, i, place});
    runs_.back().end = i + 1;
    first[target_[i]] = place;
    place += n;
  }
  place_.resize(place);
  for (const Run& run : runs_) {
    for (std::ptrdiff_t begin = run.begin; begin < run.end; begin += kGrain) {
      pieces_.push_back({run.count, run.adds, begin, std::min(run.end, begin + kGrain),
                         run.first_place + (begin - run.begin) * run.count});
    }
  }
  return first;
}

void GatherLists::sum_piece(int piece, const double* buffer, double* target) const {
  const Run& run = pieces_[piece];
  const size_t length = run.count < static_cast<int>(kSumRun<true>.size()) ? run.count : 0;
  const SumRun sum = run.adds ? kSumRun<true>[length] : kSumRun<false>[length];
  sum(buffer, target_.data() + run.begin, place_.data() + run.first_place, run.count,
      static_cast<int>(run.end - run.begin), target);
}

}  // namespace lissom
