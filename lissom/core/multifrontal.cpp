#include "lissom/core/multifrontal.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace lissom::multifrontal {

namespace {

/// Columns of an update matrix, and the part of the parent's front that they are added to.
struct Addition {
  const double* from;
  std::ptrdiff_t from_stride;
  int first, last;  ///< columns
  double* to;
  std::ptrdiff_t to_stride;
  int offset;  ///< row of the parent's panel that is the first row, and the first column, of `to`
};

void add_columns(const Addition& a, const int* place, const Plan::Run* run) {
  for (int j = a.first; j < a.last; ++j) {
    while (run->end <= j) ++run;
    const double* from = a.from + j * a.from_stride;
    double* to = a.to + (place[j] - a.offset) * a.to_stride - a.offset;
    int i = j;
    for (const Plan::Run* r = run;; ++r) {
      double* moved = to + (place[r->begin] - r->begin);
      for (; i < r->end; ++i) moved[i] += from[i];
      if (r->last) break;
    }
  }
}

}  // namespace

Factor::Factor(Plan plan, ThreadPool* threads)
    : plan_(std::move(plan)),
      threads_(threads),
      factor_(plan_.factor_size),
      reciprocal_(plan_.unknowns),
      updates_(plan_.updates_size),
      scratch_(plan_.scratch_size),
      counts_(plan_.parts.size()) {}

/// The panel of a front: its part of the matrix, and what its children pass on.
void Factor::assemble(int f, const Task& task) {
  const Front& front = plan_.fronts[f];
  const Front& next = plan_.fronts[f + 1];
  const std::ptrdiff_t stride = front.stride();
  double* panel = factor_.data() + front.panel;
  std::fill(panel, panel + stride * front.pivots, 0.0);
  for (int e = front.entries; e < next.entries; ++e) panel[plan_.entry[e].place] = task.values[plan_.entry[e].source];
  if (task.shift != 0) {
    for (int k = 0; k < front.pivots; ++k) {
      panel[k * stride + k] += task.shift * task.metric[plan_.order[front.first + k]];
    }
  }
  for (int c = front.children; c < next.children; ++c) {
    const Front& child = plan_.fronts[plan_.child[c]];
    add_columns({updates_.data() + child.update, padded(child.updates), 0, child.shared, panel, stride, 0},
                plan_.place.data() + child.rows, plan_.run.data() + child.runs);
  }
}

/// The update matrix takes the other columns of the children only once it is formed, which saves clearing it.
void Factor::eliminate(int f, const Task& task, double* scratch, PivotCount& count) {
  assemble(f, task);
  const Front& front = plan_.fronts[f];
  const Panel panel{factor_.data() + front.panel, front.pivots, front.stride()};
  factor_panel(panel, {scratch, reciprocal_.data() + front.first, front.first, task.on_negative}, count);
  if (count.broken || front.updates == 0) return;
  double* update = updates_.data() + front.update;
  form_update(panel, scratch, update);
  for (int c = front.children; c < plan_.fronts[f + 1].children; ++c) {
    const Front& child = plan_.fronts[plan_.child[c]];
    add_columns({updates_.data() + child.update, padded(child.updates), child.shared, child.updates, update,
                 padded(front.updates), padded(front.pivots)},
                plan_.place.data() + child.rows, plan_.run.data() + child.runs);
  }
}

void Factor::eliminate_part(int p, const Task& task, double* scratch) {
  PivotCount& count = counts_[p];
  count = {};
  // Parts after a broken one are of no use; those before it are, as the report names the first.
  if (broken_part_.load(std::memory_order_relaxed) < p) return;
  for (int f = plan_.parts[p].begin; f < plan_.parts[p].end && !count.broken; ++f) eliminate(f, task, scratch, count);
  if (!count.broken) return;
  int broken = broken_part_.load(std::memory_order_relaxed);
  while (p < broken && !broken_part_.compare_exchange_weak(broken, p, std::memory_order_relaxed)) {
  }
}

PivotCount Factor::factorize(std::span<const double> values, double shift, std::span<const double> metric,
                             OnNegative on_negative) {
  const Task task{values, shift, metric, on_negative};
  const int parts = static_cast<int>(plan_.parts.size());
  broken_part_.store(parts, std::memory_order_relaxed);
  if (threads_ != nullptr && threads_->threads() > 1) {
    const auto part = [&](int p) { eliminate_part(p, task, scratch_.data() + plan_.parts[p].scratch); };
    threads_->run(parts, std::cref(part));
  } else {
    for (int p = 0; p < parts; ++p) eliminate_part(p, task, scratch_.data());
  }
  PivotCount count;
  for (int p = 0; p < parts && !count.broken; ++p) {
    count.negative += counts_[p].negative;
    count.broken = counts_[p].broken;
    if (count.first_bad < 0) count.first_bad = counts_[p].first_bad;
  }
  for (const int f : plan_.top) {
    if (count.broken) break;
    eliminate(f, task, scratch_.data(), count);
  }
  return count;
}

}  // namespace lissom::multifrontal
