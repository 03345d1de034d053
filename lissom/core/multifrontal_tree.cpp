#include "lissom/core/multifrontal_tree.h"

#include <algorithm>

namespace lissom::multifrontal {

namespace {

/// Liu, A compact row storage scheme for Cholesky factors using elimination trees, 1986.
std::vector<int> elimination_tree(const Triangle& upper) {
  const int n = upper.size();
  std::vector<int> parent(n, -1), ancestor(n, -1);
  for (int j = 0; j < n; ++j) {
    for (int p = upper.start[j]; p < upper.start[j + 1]; ++p) {
      for (int i = upper.row[p]; i != -1 && i < j;) {
        const int next = ancestor[i];
        ancestor[i] = j;
        if (next == -1) parent[i] = j;
        i = next;
      }
    }
  }
  return parent;
}

/// Fronts before and while they are joined. Lists are linked through arrays.
struct Front {
  int pivots = 0;
  int updates = 0;
  int parent = -1;
  int first_child = -1, next_sibling = -1;
  int first_column = 0, columns = 0;        ///< its own, before others join
  int first_joined = -1, next_joined = -1;  ///< fronts that have become part of it
};

/// Supernodes: runs of columns whose patterns differ by the pivots only.
std::vector<Front> supernodes(std::span<const int> parent, std::span<const int> counts) {
  std::vector<Front> fronts;
  std::vector<int> front_of(parent.size());
  for (int j = 0; j < static_cast<int>(parent.size()); ++j) {
    if (j == 0 || parent[j - 1] != j || counts[j] != counts[j - 1] - 1) {
      fronts.push_back({.first_column = j});
    }
    Front& front = fronts.back();
    front_of[j] = static_cast<int>(fronts.size()) - 1;
    front.columns = ++front.pivots;
    front.updates = counts[j] - 1;
  }
  for (Front& front : fronts) {
    const int above = parent[front.first_column + front.columns - 1];
    if (above >= 0) front.parent = front_of[above];
  }
  for (int f = static_cast<int>(fronts.size()) - 1; f >= 0; --f) {  // so that children ascend
    Front& front = fronts[f];
    if (front.parent < 0) continue;
    front.next_sibling = fronts[front.parent].first_child;
    fronts[front.parent].first_child = f;
  }
  return fronts;
}

/// Joins with front p those children, and their children, for which that saves time.
void join_children(std::vector<Front>& fronts, int p) {
  Front& front = fronts[p];
  int kept = -1, waiting = front.first_child;
  while (waiting >= 0) {
    const int c = waiting;
    Front& child = fronts[c];
    waiting = child.next_sibling;
    const double apart = front_time(child.pivots, child.updates) + front_time(front.pivots, front.updates);
    if (front_time(child.pivots + front.pivots, front.updates) > apart) {
      child.next_sibling = kept;
      kept = c;
      continue;
    }
    front.pivots += child.pivots;
    child.next_joined = front.first_joined;
    front.first_joined = c;
    for (int g = child.first_child; g >= 0;) {
      const int next = fronts[g].next_sibling;
      fronts[g].parent = p;
      fronts[g].next_sibling = waiting;
      waiting = g;
      g = next;
    }
  }
  front.first_child = kept;
}

}  // namespace

double front_time(double pivots, double updates) {
  const double operations = pivots * (updates * updates + pivots * updates + pivots * pivots / 3);
  return 1e-9 * (150 + 1.0 * pivots * (pivots + updates) + 0.6 * updates * updates + operations / 30);
}

AssemblyTree assembly_tree(const Triangle& upper, std::span<const int> column_counts) {
  std::vector<Front> fronts = supernodes(elimination_tree(upper), column_counts);
  const int count = static_cast<int>(fronts.size());
  for (int f = 0; f < count; ++f) join_children(fronts, f);

  AssemblyTree tree;
  tree.order.reserve(column_counts.size());
  tree.first_pivot.push_back(0);
  std::vector<int> number(count, -1), stack, joined, columns;
  for (int root = 0; root < count; ++root) {
    if (fronts[root].parent >= 0) continue;
    stack.push_back(root);
    while (!stack.empty()) {
      const int f = stack.back();
      if (fronts[f].first_child >= 0) {  // before their parent
        for (int c = fronts[f].first_child; c >= 0; c = fronts[c].next_sibling) stack.push_back(c);
        fronts[f].first_child = -1;
        continue;
      }
      stack.pop_back();
      number[f] = tree.fronts();
      tree.parent.push_back(fronts[f].parent);  // renumbered below
      tree.updates.push_back(fronts[f].updates);
      tree.time += front_time(fronts[f].pivots, fronts[f].updates);
      columns.clear();
      joined.assign(1, f);
      while (!joined.empty()) {
        const Front& part = fronts[joined.back()];
        joined.pop_back();
        for (int c = 0; c < part.columns; ++c) columns.push_back(part.first_column + c);
        for (int j = part.first_joined; j >= 0; j = fronts[j].next_joined) joined.push_back(j);
      }
      std::sort(columns.begin(), columns.end());
      tree.order.insert(tree.order.end(), columns.begin(), columns.end());
      tree.first_pivot.push_back(static_cast<int>(tree.order.size()));
    }
  }
  for (int& parent : tree.parent) {
    if (parent >= 0) parent = number[parent];
  }
  return tree;
}

}  // namespace lissom::multifrontal
