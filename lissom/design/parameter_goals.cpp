#include "lissom/design/parameter_goals.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lissom/core/assert.h"

namespace lissom {

ParameterGoal make_closeness(std::span<const Parameter> parameters, VecX start, double weight) {
  const int m = static_cast<int>(parameters.size());
  LISSOM_ASSERT(start.size() == m);
  SparseMatrix rows(m, m);
  for (int i = 0; i < m; ++i) rows.insert(i, i) = 1 / (parameters[i].scale * std::sqrt(m));
  return {"closeness to the start", rows, std::move(start), weight};
}

ParameterGoal make_smoothness(std::span<const Parameter> parameters, std::span<const std::array<int, 2>> neighbours,
                              double weight) {
  const int m = static_cast<int>(parameters.size());
  std::vector<int> count(m, 0), row(m, -1);
  for (const auto& [a, b] : neighbours) {
    LISSOM_ASSERT(a != b && std::min(a, b) >= 0 && std::max(a, b) < m);
    ++count[a];
    ++count[b];
  }
  int size = 0;
  for (int i = 0; i < m; ++i) {
    if (count[i] > 0) row[i] = size++;
  }
  std::vector<Eigen::Triplet<double>> entries;
  const auto factor = [&](int i) { return 1 / (parameters[i].scale * std::sqrt(size)); };
  for (int i = 0; i < m; ++i) {
    if (row[i] >= 0) entries.emplace_back(row[i], i, factor(i));
  }
  for (const auto& [a, b] : neighbours) {
    entries.emplace_back(row[a], b, -factor(a) / count[a]);
    entries.emplace_back(row[b], a, -factor(b) / count[b]);
  }
  SparseMatrix rows(size, m);
  rows.setFromTriplets(entries.begin(), entries.end());
  return {"smooth parameters", rows, VecX::Zero(m), weight};
}

std::vector<std::array<int, 2>> neighbours_along_rods(const RodControls& controls, const Structure& structure,
                                                      std::span<const int> first) {
  std::vector<int> at_node(structure.nodes.size(), -1);
  std::vector<std::vector<int>> between(structure.rods.size());
  for (int c = 0; c < controls.size(); ++c) {
    const RodControls::Control& control = controls.controls()[c];
    if (control.node >= 0) {
      at_node[control.node] = c;
    } else {
      between[control.rod].push_back(c);
    }
  }
  std::vector<std::array<int, 2>> pairs;
  for (std::size_t r = 0; r < structure.rods.size(); ++r) {
    std::vector<int> along{at_node[structure.rods[r].nodes.front()]};
    along.insert(along.end(), between[r].begin(), between[r].end());
    along.push_back(at_node[structure.rods[r].nodes.back()]);
    for (std::size_t i = 1; i < along.size(); ++i) {
      const auto [a, b] = std::minmax(along[i - 1], along[i]);
      if (a != b) pairs.push_back({a, b});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<std::array<int, 2>> all;
  for (const int begin : first) {
    for (const auto& [a, b] : pairs) all.push_back({begin + a, begin + b});
  }
  return all;
}

OneSided one_sided_wishes(std::span<const ParameterGoal> wishes, const VecX& p, const VecX& scale) {
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> values;
  for (const ParameterGoal& wish : wishes) {
    if (wish.kind == GoalKind::kReach) continue;
    const double sign = (wish.kind == GoalKind::kAtMost ? 1 : -1) * std::sqrt(wish.weight);
    VecX deviation = wish.rows * (p - wish.target);
    if (wish.level.size() > 0) deviation -= wish.level;
    const int first = static_cast<int>(values.size());
    for (const double d : deviation) values.push_back(sign * d);
    for (int c = 0; c < wish.rows.outerSize(); ++c) {
      for (SparseMatrix::InnerIterator it(wish.rows, c); it; ++it) {
        entries.emplace_back(first + static_cast<int>(it.row()), c, sign * it.value() * scale[c]);
      }
    }
  }
  OneSided made;
  made.value = Eigen::Map<const VecX>(values.data(), static_cast<Eigen::Index>(values.size()));
  made.rows.resize(made.value.size(), p.size());
  made.rows.setFromTriplets(entries.begin(), entries.end());
  return made;
}

}  // namespace lissom
