#include "lissom/core/multifrontal_plan.h"

#include <algorithm>

#include "lissom/core/assert.h"
#include "lissom/core/multifrontal_kernels.h"

namespace lissom::multifrontal {

namespace {

/// s, estimated, from which several threads bring more than waking them costs.
constexpr double kWorthThreads = 0.3e-3;
/// Of the time, that a part takes at most: smaller parts leave more to the top of the tree, which one thread does.
constexpr double kShare = 1.0 / 8;

/// Hands out places in a line of memory that has a beginning and no end: the lowest free one that is large enough.
class Memory {
 public:
  explicit Memory(std::int64_t begin) : begin_(begin), end_(begin) {}
  std::int64_t take(std::int64_t size) {
    for (std::size_t k = 0; k < gaps_.size(); ++k) {
      Gap& gap = gaps_[k];
      if (gap.end - gap.begin < size) continue;
      const std::int64_t place = gap.begin;
      gap.begin += size;
      if (gap.begin == gap.end) gaps_.erase(gaps_.begin() + static_cast<std::ptrdiff_t>(k));
      return place;
    }
    end_ += size;
    return end_ - size;
  }
  void give_back(std::int64_t place, std::int64_t size) {
    if (size == 0 || place < begin_) return;  // what lies before the beginning is not its own
    auto next = std::find_if(gaps_.begin(), gaps_.end(), [&](const Gap& g) { return g.begin > place; });
    next = gaps_.insert(next, {place, place + size});
    if (next + 1 != gaps_.end() && next->end == (next + 1)->begin) {
      next->end = (next + 1)->end;
      gaps_.erase(next + 1);
    }
    if (next != gaps_.begin() && (next - 1)->end == next->begin) {
      (next - 1)->end = next->end;
      gaps_.erase(next);
    }
  }
  std::int64_t end() const { return end_; }

 private:
  struct Gap {
    std::int64_t begin, end;
  };
  std::vector<Gap> gaps_;  // ascending, never touching; below end_
  std::int64_t begin_, end_;
};

std::int64_t update_size(const Front& front) {
  const std::int64_t rows = padded(front.updates);
  return rows * rows;
}

std::int64_t panel_size(const Front& front) { return static_cast<std::int64_t>(front.stride()) * front.pivots; }

/// Finds a place for the update matrix of front f; its children are done with then.
void place_update(Plan& plan, int f, Memory& memory) {
  plan.fronts[f].update = memory.take(update_size(plan.fronts[f]));
  for (int c = plan.fronts[f].children; c < plan.fronts[f + 1].children; ++c) {
    const Front& child = plan.fronts[plan.child[c]];
    memory.give_back(child.update, update_size(child));
  }
}

/// The rows of every front: those of its columns in the matrix and those that its children pass on.
void find_rows(const Triangle& lower, Plan& plan) {
  std::vector<int> seen(plan.unknowns, -1);
  for (int f = 0; f + 1 < static_cast<int>(plan.fronts.size()); ++f) {
    Front& front = plan.fronts[f];
    const int end = front.first + front.pivots;
    front.rows = static_cast<int>(plan.row.size());
    const auto add = [&](int row) {
      if (row < end || seen[row] == f) return;
      seen[row] = f;
      plan.row.push_back(row);
    };
    for (int p = lower.start[front.first]; p < lower.start[end]; ++p) add(lower.row[p]);
    for (int c = front.children; c < plan.fronts[f + 1].children; ++c) {
      const Front& child = plan.fronts[plan.child[c]];
      for (int i = child.shared; i < child.updates; ++i) add(plan.row[child.rows + i]);
    }
    std::sort(plan.row.begin() + front.rows, plan.row.end());
    LISSOM_ASSERT(static_cast<int>(plan.row.size()) - front.rows == front.updates);
    if (front.parent < 0) continue;
    const int parents_end = plan.fronts[front.parent].first + plan.fronts[front.parent].pivots;
    while (front.shared < front.updates && plan.row[front.rows + front.shared] < parents_end) ++front.shared;
  }
  plan.fronts.back().rows = static_cast<int>(plan.row.size());
}

/// Where the rows of update matrices go, and where the entries of the matrix do.
void find_places(const Triangle& lower, Plan& plan) {
  plan.place.resize(plan.row.size());
  std::vector<int> place(plan.unknowns);
  for (int f = 0; f + 1 < static_cast<int>(plan.fronts.size()); ++f) {
    Front& front = plan.fronts[f];
    for (int k = 0; k < front.pivots; ++k) place[front.first + k] = k;
    for (int i = 0; i < front.updates; ++i) place[plan.row[front.rows + i]] = padded(front.pivots) + i;
    front.entries = static_cast<int>(plan.entry.size());
    for (int k = 0; k < front.pivots; ++k) {
      for (int p = lower.start[front.first + k]; p < lower.start[front.first + k + 1]; ++p) {
        plan.entry.push_back({lower.source[p], k * front.stride() + place[lower.row[p]]});
      }
    }
    for (int c = front.children; c < plan.fronts[f + 1].children; ++c) {
      const Front& child = plan.fronts[plan.child[c]];
      for (int i = child.rows; i < child.rows + child.updates; ++i) plan.place[i] = place[plan.row[i]];
    }
  }
  plan.fronts.back().entries = static_cast<int>(plan.entry.size());
  for (int f = 0; f + 1 < static_cast<int>(plan.fronts.size()); ++f) {
    Front& front = plan.fronts[f];
    front.runs = static_cast<int>(plan.run.size());
    const int* to = plan.place.data() + front.rows;
    for (int i = 0; i < front.updates; ++i) {
      const bool goes_on = i > 0 && i != front.shared && to[i] == to[i - 1] + 1;
      if (goes_on) {
        plan.run.back().end = i + 1;
      } else {
        plan.run.push_back({i, i + 1});
      }
    }
    if (front.updates > 0) plan.run.back().last = true;
  }
  plan.fronts.back().runs = static_cast<int>(plan.run.size());
}

/// Cuts the tree: subtrees that take at most a share of the time, neighbours among them joined up to that.
void find_parts(Plan& plan) {
  const int count = static_cast<int>(plan.fronts.size()) - 1;
  std::vector<double> below(count, 0.0);  // time of the subtree
  double time = 0;
  for (int f = 0; f < count; ++f) {
    const Front& front = plan.fronts[f];
    const double own = front_time(front.pivots, front.updates);
    time += own;
    below[f] += own;
    if (front.parent >= 0) below[front.parent] += below[f];
  }
  const double most = time < kWorthThreads ? 0 : kShare * time;
  double taken = 0;
  bool open = false;
  for (int f = 0; f < count; ++f) {
    if (below[f] > most) {
      plan.top.push_back(f);
      open = false;
      continue;
    }
    if (!open) {
      plan.parts.push_back({.begin = f, .end = f, .scratch = 0});
      taken = 0;
      open = true;
    }
    plan.parts.back().end = f + 1;
    const int parent = plan.fronts[f].parent;
    if (parent >= 0 && below[parent] <= most) continue;
    taken += below[f];
    open = taken < most / 2;
  }
}

void find_memory(Plan& plan) {
  for (Front& front : plan.fronts) {
    front.panel = plan.factor_size;
    plan.factor_size += panel_size(front);
    plan.most_rows = std::max(plan.most_rows, front.stride());
  }
  for (Plan::Part& part : plan.parts) {
    Memory memory(plan.updates_size);
    std::int64_t largest = 0;
    for (int f = part.begin; f < part.end; ++f) {
      largest = std::max(largest, panel_size(plan.fronts[f]));
      place_update(plan, f, memory);
    }
    plan.updates_size = memory.end();
    part.scratch = plan.scratch_size;
    plan.scratch_size += largest;
  }
  Memory memory(plan.updates_size);
  for (const int f : plan.top) {
    plan.scratch_size = std::max(plan.scratch_size, panel_size(plan.fronts[f]));
    place_update(plan, f, memory);
  }
  plan.updates_size = memory.end();
}

}  // namespace

int Front::stride() const { return padded(pivots) + padded(updates); }

Plan make_plan(const Triangle& lower, std::span<const int> order, const AssemblyTree& tree) {
  Plan plan;
  plan.unknowns = lower.size();
  plan.order.resize(plan.unknowns);
  for (int k = 0; k < plan.unknowns; ++k) plan.order[k] = order[tree.order[k]];
  const Triangle permuted = transposed(permuted_upper(lower, plan.order));

  const int count = tree.fronts();
  plan.fronts.resize(static_cast<std::size_t>(count) + 1);
  for (int f = 0; f < count; ++f) {
    Front& front = plan.fronts[f];
    front.first = tree.first_pivot[f];
    front.pivots = tree.first_pivot[f + 1] - tree.first_pivot[f];
    front.updates = tree.updates[f];
    front.parent = tree.parent[f];
    if (front.parent >= 0) ++plan.fronts[front.parent + 1].children;
  }
  for (int f = 0; f < count; ++f) plan.fronts[f + 1].children += plan.fronts[f].children;
  plan.child.resize(plan.fronts[count].children);
  std::vector<int> next(count);
  for (int f = 0; f < count; ++f) next[f] = plan.fronts[f].children;
  for (int f = 0; f < count; ++f) {
    if (tree.parent[f] >= 0) plan.child[next[tree.parent[f]]++] = f;
  }
  find_rows(permuted, plan);
  find_places(permuted, plan);
  find_parts(plan);
  find_memory(plan);
  return plan;
}

}  // namespace lissom::multifrontal
