#include "lissom/editing/name_keeper.h"

#include <algorithm>

namespace lissom {

namespace {

void add_once(std::vector<std::string>& list, std::string name) {
  if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(std::move(name));
}

}  // namespace

NameKeeper::NameKeeper(const Plan& before, const Model& after, const NameChanges& names)
    : names_(names), heirs_(before, *after.plan, names.points, names.rods) {
  for (const PlanPoint& point : before.points) points_before_.insert(point.name);
  for (const PlanPoint& point : after.plan->points) points_.insert(point.name);
  for (const NamedSet& set : after.sets) sets_.insert(set.name);
}

std::string NameKeeper::point(const std::string& name) const {
  if (!points_before_.contains(name)) return name;
  const auto changed = names_.points.find(name);
  const std::string& now = changed == names_.points.end() ? name : changed->second;
  return points_.contains(now) ? now : std::string();
}

template <class Keep>
Kept NameKeeper::keep_union(Selector& selector, const Keep& keep) {
  Kept all = Kept::kWhole;
  std::vector<Selector> parts;
  for (Selector& part : selector.parts) {
    const Kept own = keep(part);
    if (own != Kept::kWhole) all = Kept::kPart;
    if (own == Kept::kNone) continue;
    const auto same = [&](const Selector& other) {
      return part.kind == Selector::Kind::kPlanPoint && other.kind == part.kind && other.name == part.name;
    };
    if (std::none_of(parts.begin(), parts.end(), same)) parts.push_back(std::move(part));
  }
  selector.parts = std::move(parts);
  return selector.parts.empty() ? Kept::kNone : all;
}

Kept NameKeeper::keep_rod(Selector& selector) const {
  if (!heirs_.known(selector.name)) return Kept::kWhole;
  if (selector.fraction >= 0) {
    const PlaceOnRod place = heirs_.of(PlaceOnRod{selector.name, selector.fraction});
    selector.name = place.rod;
    selector.fraction = place.fraction;
    return place.rod.empty() ? Kept::kNone : Kept::kWhole;
  }
  const std::vector<std::string> rods = heirs_.of(selector.name);
  if (rods.empty()) return Kept::kNone;
  if (rods.size() == 1) {
    selector.name = rods[0];
    return Kept::kWhole;
  }
  Selector all;
  all.kind = Selector::Kind::kUnion;
  for (const std::string& rod : rods) {
    selector.name = rod;
    all.parts.push_back(selector);
  }
  selector = std::move(all);
  return Kept::kWhole;
}

Kept NameKeeper::keep(Selector& selector) const {
  switch (selector.kind) {
    case Selector::Kind::kPlanPoint:
      selector.name = point(selector.name);
      return selector.name.empty() ? Kept::kNone : Kept::kWhole;
    case Selector::Kind::kSet:
      return has_set(selector.name) ? Kept::kWhole : Kept::kNone;
    case Selector::Kind::kRod:
      return keep_rod(selector);
    case Selector::Kind::kUnion:
      return keep_union(selector, [this](Selector& part) { return keep(part); });
    default:
      return Kept::kWhole;
  }
}

Kept NameKeeper::keep_sets(Selector& selector) const {
  if (selector.kind == Selector::Kind::kSet) return has_set(selector.name) ? Kept::kWhole : Kept::kNone;
  if (selector.kind != Selector::Kind::kUnion) return Kept::kWhole;
  return keep_union(selector, [this](Selector& part) { return keep_sets(part); });
}

std::vector<std::string> NameKeeper::keep_rods(const std::vector<std::string>& rods) const {
  std::vector<std::string> now;
  for (const std::string& rod : rods) {
    if (!heirs_.known(rod)) add_once(now, rod);
    for (std::string& name : heirs_.of(rod)) add_once(now, std::move(name));
  }
  return now;
}

std::vector<std::string> NameKeeper::keep_points(const std::vector<std::string>& points) const {
  std::vector<std::string> now;
  for (const std::string& name : points) {
    if (std::string here = point(name); !here.empty()) add_once(now, std::move(here));
  }
  return now;
}

}  // namespace lissom
