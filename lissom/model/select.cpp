#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

#include "lissom/core/nearest_name.h"
#include "lissom/model/membrane_rim.h"
#include "lissom/model/select_parts.h"
#include "lissom/model/structure.h"

namespace lissom {

namespace {

using Nodes = std::vector<int>;

constexpr SelectorWord kWords[] = {{"all", Selector::Kind::kAll},
                                   {"joints", Selector::Kind::kJoints},
                                   {"free_ends", Selector::Kind::kEnds},
                                   {"boundary", Selector::Kind::kBoundary}};

void sort_unique(Nodes& nodes) {
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
}

class Selection {
 public:
  Selection(const Model& model, const Structure& structure, const std::string& where)
      : model_(model), structure_(structure), where_(where), known_(model.sets.size()) {}

  Result<Nodes> resolve(const Selector& selector, int depth) {
    switch (selector.kind) {
      case Selector::Kind::kSet:
        return named_set(selector, depth);
      case Selector::Kind::kAll:
        return where_true([](size_t) { return true; });
      case Selector::Kind::kRod:
        return rod(selector);
      case Selector::Kind::kPoint:
        return point(selector);
      case Selector::Kind::kBox:
        return where_true([&](size_t i) {
          const Vec3& p = structure_.nodes[i];
          return (p.array() >= selector.low.array()).all() && (p.array() <= selector.high.array()).all();
        });
      case Selector::Kind::kJoints: {
        const std::vector<int> passages = count_passages(structure_);
        return where_true([&](size_t i) { return passages[i] > 1; });
      }
      case Selector::Kind::kEnds:
        return free_ends();
      case Selector::Kind::kBoundary:
        return boundary_nodes(structure_);
      case Selector::Kind::kMembrane:
      case Selector::Kind::kRim:
        return membrane(selector);
      case Selector::Kind::kPlanPoint:
        return plan_point(selector);
      case Selector::Kind::kUnion:
        return parts(selector, depth);
    }
    return Nodes{};
  }

 private:
  template <class Predicate>
  Nodes where_true(const Predicate& predicate) const {
    Nodes nodes;
    for (size_t i = 0; i < structure_.nodes.size(); ++i) {
      if (predicate(i)) nodes.push_back(static_cast<int>(i));
    }
    return nodes;
  }

  Nodes free_ends() const {
    const std::vector<int> passages = count_passages(structure_);
    Nodes nodes;
    for (const StructureRod& rod : structure_.rods) {
      if (rod.closed) continue;
      for (const int node : {rod.nodes.front(), rod.nodes.back()}) {
        if (passages[static_cast<size_t>(node)] == 1) nodes.push_back(node);
      }
    }
    return nodes;
  }

  Result<Nodes> named_set(const Selector& selector, int depth) {
    if (depth > static_cast<int>(model_.sets.size())) {
      return Error{ErrorCode::kConflict, where_, fmt::format("the set \"{}\" refers to itself", selector.name),
                   "break the circle of sets"};
    }
    std::vector<std::string> names;
    for (size_t i = 0; i < model_.sets.size(); ++i) {
      names.push_back(model_.sets[i].name);
      if (names.back() != selector.name) continue;
      if (known_[i]) return *known_[i];
      Result<Nodes> nodes = resolve(model_.sets[i].nodes, depth + 1);
      if (nodes) known_[i] = nodes.value();
      return nodes;
    }
    return Error{ErrorCode::kUnknown, where_, fmt::format("there is no set named \"{}\"", selector.name),
                 names.empty() ? "describe it under `sets`" : suggestion(selector.name, names)};
  }

  Result<Nodes> parts(const Selector& selector, int depth) {
    Nodes all;
    for (const Selector& part : selector.parts) {
      const Result<Nodes> nodes = resolve(part, depth);
      if (!nodes) return nodes.error();
      all.insert(all.end(), nodes.value().begin(), nodes.value().end());
    }
    sort_unique(all);  // here, not only at the end: unions of unions would double each time
    return all;
  }

  Result<Nodes> rod(const Selector& selector) const {
    const int number = structure_.rod_index(selector.name);
    if (number < 0) {
      std::vector<std::string> names;
      for (const StructureRod& known : structure_.rods) names.push_back(known.name);
      return Error{ErrorCode::kUnknown, where_, fmt::format("there is no rod named \"{}\"", selector.name),
                   suggestion(selector.name, names)};
    }
    const StructureRod& found = structure_.rods[static_cast<size_t>(number)];
    if (selector.fraction < 0) return found.nodes;
    if (!(selector.fraction <= 1)) {
      return Error{ErrorCode::kRange, where_,
                   fmt::format("the place along rod \"{}\" is at {:g} of its length", selector.name, selector.fraction),
                   "give a number from 0 (start) to 1 (end)"};
    }
    std::vector<double> lengths{0};
    for (int edge : found.edges) {
      lengths.push_back(lengths.back() + structure_.edges[static_cast<size_t>(edge)].rest_length);
    }
    const double place = selector.fraction * lengths.back();
    size_t best = 0;
    for (size_t i = 1; i < lengths.size(); ++i) {
      // Rounding must not decide between two nodes at the same distance: the first is taken.
      if (std::abs(lengths[i] - place) < std::abs(lengths[best] - place) - 1e-9 * lengths.back()) best = i;
    }
    return Nodes{found.nodes[best % found.nodes.size()]};
  }

  Result<Nodes> membrane(const Selector& selector) const {
    std::vector<std::string> names;
    for (size_t m = 0; m < structure_.membranes.size(); ++m) {
      names.push_back(structure_.membranes[m].name);
      if (names.back() != selector.name) continue;
      if (selector.kind == Selector::Kind::kMembrane) return structure_.membranes[m].nodes;
      return rim(static_cast<int>(m), selector.rim);
    }
    return Error{ErrorCode::kUnknown, where_, fmt::format("there is no membrane named \"{}\"", selector.name),
                 suggestion(selector.name, names)};
  }

  Nodes rim(int membrane, Selector::Rim which) const {
    Nodes nodes;
    const std::vector<RimLoop> loops = rim_loops(structure_, membrane);
    for (size_t i = 0; i < loops.size(); ++i) {
      if (which != Selector::Rim::kAll && (which == Selector::Rim::kOuter) != (i == 0)) continue;
      for (const RimEdge& edge : loops[i]) nodes.push_back(edge.node0);
    }
    return nodes;
  }

  Result<Nodes> point(const Selector& selector) const {
    int best = -1;
    double distance = 0;
    for (size_t i = 0; i < structure_.nodes.size(); ++i) {
      const double d = (structure_.nodes[i] - selector.point).norm();
      if (best >= 0 && !(d < distance)) continue;
      best = static_cast<int>(i);
      distance = d;
    }
    const double tolerance = selector.tolerance > 0 ? selector.tolerance : structure_.mean_edge_length / 2;
    if (best >= 0 && distance <= tolerance) return Nodes{best};
    const Vec3 p = best >= 0 ? structure_.nodes[static_cast<size_t>(best)] : Vec3::Zero();
    return Error{
        ErrorCode::kGeometry, where_,
        fmt::format(
            "no node lies within {:g} m of ({:g}, {:g}, {:g}); the nearest, at ({:g}, {:g}, {:g}), is {:g} m away",
            tolerance, selector.point.x(), selector.point.y(), selector.point.z(), p.x(), p.y(), p.z(), distance),
        "correct the point (are its units right?) or give a larger `tolerance`"};
  }

  Result<Nodes> plan_point(const Selector& selector) const {
    std::vector<std::string> names;
    if (model_.plan) {
      for (const PlanPoint& known : model_.plan->points) {
        names.push_back(known.name);
        if (known.name != selector.name) continue;
        Selector at;
        at.kind = Selector::Kind::kPoint;
        at.point = Vec3(known.at.x(), known.at.y(), 0);
        return point(at);
      }
    }
    return Error{ErrorCode::kUnknown, where_, fmt::format("the plan has no point named \"{}\"", selector.name),
                 names.empty() ? "describe it under `plan`" : suggestion(selector.name, names)};
  }

  const Model& model_;
  const Structure& structure_;
  const std::string& where_;
  std::vector<std::optional<Nodes>> known_;  ///< by set: each is resolved once, however often sets name each other
};

}  // namespace

std::span<const SelectorWord> selector_words() { return kWords; }

Result<std::vector<int>> select(const Model& model, const Structure& structure, const Selector& selector,
                                const std::string& where) {
  Result<Nodes> found = Selection(model, structure, where).resolve(selector, 0);
  if (!found) return found;
  Nodes nodes = std::move(found).value();
  sort_unique(nodes);
  if (nodes.empty()) {
    return Error{ErrorCode::kGeometry, where, "the selection holds no node",
                 "check the limits of boxes (units, sign) and that the parts named exist"};
  }
  return nodes;
}

}  // namespace lissom
