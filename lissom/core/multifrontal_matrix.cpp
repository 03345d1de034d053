#include "lissom/core/multifrontal_matrix.h"

#include <algorithm>

namespace lissom::multifrontal {

Triangle kept_part(const SparsePattern& pattern, std::span<const int> kept) {
  Triangle t;
  t.start.push_back(0);
  for (int j = 0; j < pattern.size(); ++j) {
    if (kept[j] < 0) continue;
    for (int p = pattern.column_start()[j]; p < pattern.column_start()[j + 1]; ++p) {
      const int i = kept[pattern.row()[p]];
      if (i < 0) continue;
      t.row.push_back(i);
      t.source.push_back(p);
    }
    t.start.push_back(static_cast<int>(t.row.size()));
  }
  return t;
}

Triangle transposed(const Triangle& t) {
  const int n = t.size();
  Triangle r;
  r.start.assign(static_cast<std::size_t>(n) + 1, 0);
  r.row.resize(t.row.size());
  r.source.resize(t.row.size());
  for (const int i : t.row) ++r.start[i + 1];
  for (int i = 0; i < n; ++i) r.start[i + 1] += r.start[i];
  std::vector<int> fill(r.start.begin(), r.start.end() - 1);
  for (int j = 0; j < n; ++j) {
    for (int p = t.start[j]; p < t.start[j + 1]; ++p) {
      const int q = fill[t.row[p]]++;
      r.row[q] = j;
      r.source[q] = t.source[p];
    }
  }
  return r;
}

Triangle permuted_upper(const Triangle& t, std::span<const int> order) {
  const int n = t.size();
  std::vector<int> place(n);
  for (int k = 0; k < n; ++k) place[order[k]] = k;
  Triangle lower;  // rows unsorted
  lower.start.assign(static_cast<std::size_t>(n) + 1, 0);
  lower.row.resize(t.row.size());
  lower.source.resize(t.row.size());
  for (int j = 0; j < n; ++j) {
    for (int p = t.start[j]; p < t.start[j + 1]; ++p) ++lower.start[std::min(place[j], place[t.row[p]]) + 1];
  }
  for (int j = 0; j < n; ++j) lower.start[j + 1] += lower.start[j];
  std::vector<int> fill(lower.start.begin(), lower.start.end() - 1);
  for (int j = 0; j < n; ++j) {
    for (int p = t.start[j]; p < t.start[j + 1]; ++p) {
      const auto [column, row] = std::minmax(place[j], place[t.row[p]]);
      const int q = fill[column]++;
      lower.row[q] = row;
      lower.source[q] = t.source[p];
    }
  }
  return transposed(lower);
}

}  // namespace lissom::multifrontal
