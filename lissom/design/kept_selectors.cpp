#include "lissom/design/kept_selectors.h"

#include <fmt/format.h>
#include <utility>

namespace lissom {

namespace {

/// Calls f(selector, where) for what joints and poses select, ModelT: Model or const Model.
template <class ModelT, class F>
void each_selector(ModelT& model, const F& f) {
  const auto all = [&](auto& list, const std::string& where) {
    for (std::size_t i = 0; i < list.size(); ++i) f(list[i].at, fmt::format("{}/{}", where, i));
  };
  all(model.joints, "/joints");
  for (std::size_t p = 0; p < model.poses.size(); ++p) {
    auto& pose = model.poses[p];
    const std::string where = fmt::format("/poses/{}", p);
    all(pose.supports, where + "/supports");
    all(pose.soft_pins, where + "/soft_pins");
    all(pose.forces, where + "/forces");
    all(pose.moments, where + "/moments");
    all(pose.edge_loads, where + "/edge_loads");
  }
}

template <class SelectorT, class F>
void each_place(SelectorT& selector, const F& f) {
  if (selector.kind == Selector::Kind::kBox || selector.kind == Selector::Kind::kPoint) return f(selector);
  for (auto& part : selector.parts) each_place(part, f);
}

/// All boxes and points, those in named sets included.
template <class ModelT, class F>
void each_place_of(ModelT& model, const F& f) {
  for (auto& set : model.sets) each_place(set.nodes, f);
  each_selector(model, [&](auto& selector, const std::string&) { each_place(selector, f); });
}

/// Nothing where a selector cannot be resolved: whoever uses it says why.
std::vector<int> nodes_of(const Model& model, const Structure& structure, const Selector& selector) {
  Result<std::vector<int>> nodes = select(model, structure, selector, "");
  return nodes ? std::move(nodes).value() : std::vector<int>();
}

}  // namespace

KeptSelectors::KeptSelectors(const Model& model, const Structure& structure) {
  each_place_of(model, [&](const Selector& place) { places_.push_back(nodes_of(model, structure, place)); });
  each_selector(model, [&](const Selector& selector, const std::string&) {
    selected_.push_back(nodes_of(model, structure, selector));
  });
}

Status KeptSelectors::rename(Model& model, const Structure& moved) const {
  std::size_t number = 0;
  each_place_of(model, [&](Selector& place) {
    const std::vector<int>& nodes = places_[number++];
    if (nodes.empty()) return;
    std::vector<Selector> points;
    for (const int node : nodes) {
      Selector point;
      point.kind = Selector::Kind::kPoint;
      point.point = moved.nodes[static_cast<std::size_t>(node)];
      points.push_back(std::move(point));
    }
    if (points.size() == 1) {
      place = points[0];
    } else {
      place = Selector{};
      place.kind = Selector::Kind::kUnion;
      place.parts = std::move(points);
    }
  });
  Status status;
  number = 0;
  each_selector(model, [&](const Selector& selector, const std::string& where) {
    const std::vector<int>& before = selected_[number++];
    if (!status || nodes_of(model, moved, selector) == before) return;
    status = Error{ErrorCode::kConflict, where, "other nodes would be selected where the drawing has moved",
                   "select by the names of rods, or move the drawing less"};
  });
  return status;
}

}  // namespace lissom
