#include "lissom/editing/rod_heirs.h"

#include <algorithm>
#include <limits>

#include "lissom/editing/rod_curve.h"
#include "lissom/model/expand_plan.h"

namespace lissom {

namespace {

constexpr int kSteps = 32;  // of a piece of a rod

double length_of(const std::vector<Vec2>& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

Vec2 place_at(const std::vector<Vec2>& line, double fraction) {
  double left = fraction * length_of(line);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double own = (line[i] - line[i - 1]).norm();
    if (left <= own && own > 0) return line[i - 1] + left / own * (line[i] - line[i - 1]);
    left -= own;
  }
  return line.back();
}

struct Nearest {
  double distance = std::numeric_limits<double>::infinity();  ///< m
  double fraction = 0;
};

Nearest nearest_on(const std::vector<Vec2>& line, const Vec2& to) {
  Nearest best;
  double before = 0, at = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 u = line[i] - line[i - 1];
    const double own = u.norm();
    const double t = own > 0 ? std::clamp((to - line[i - 1]).dot(u) / (own * own), 0.0, 1.0) : 0;
    const double distance = (line[i - 1] + t * u - to).norm();
    if (distance < best.distance) {
      best.distance = distance;
      at = before + t * own;
    }
    before += own;
  }
  best.fraction = before > 0 ? at / before : 0;
  constexpr double kEnd = 1e-9;
  if (best.fraction < kEnd) best.fraction = 0;
  if (best.fraction > 1 - kEnd) best.fraction = 1;
  return best;
}

/// Whether two lists have a piece in common: two neighbouring points.
bool share_piece(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  const auto place = [&](const std::string& name) { return std::find(b.begin(), b.end(), name) - b.begin(); };
  std::ptrdiff_t common = 0;
  for (const std::string& name : a) common += place(name) < static_cast<std::ptrdiff_t>(b.size()) ? 1 : 0;
  return common >= 2;
}

}  // namespace

std::vector<RodHeirs::Part> RodHeirs::parts_of(const Plan& plan) {
  std::vector<Part> parts;
  const std::vector<std::string> names = plan_rod_names(plan);
  for (const PlanRod& rod : plan.rods) {
    if (rod.role == PlanRole::kGhost) continue;
    const RodCurve curve(plan, rod);
    const int n = static_cast<int>(rod.points.size()), pieces = curve.pieces();
    const auto point = [&](int i) -> const PlanPoint& {
      return plan.points[static_cast<std::size_t>(rod.points[static_cast<std::size_t>(i % n)])];
    };
    // A closed rod begins at its first split point, if it has one.
    int first = 0;
    while (rod.closed && first < n && !point(first).split) ++first;
    const bool ring = rod.closed && first == n;
    if (ring) first = 0;
    const auto begin = [&] { parts.push_back({names[parts.size()], rod.name, {}, {}}); };
    begin();
    for (int k = 0; k < pieces; ++k) {
      const int piece = (first + k) % n;
      parts.back().points.push_back(point(piece).name);
      for (int s = k > 0 && !parts.back().line.empty() ? 1 : 0; s <= kSteps; ++s) {
        parts.back().line.push_back(curve.point(piece, double(s) / kSteps));
      }
      const bool last = k + 1 == pieces;
      if (last || point(piece + 1).split) {
        if (!ring) parts.back().points.push_back(point(piece + 1).name);
        if (!last && !ring) begin();
      }
    }
  }
  return parts;
}

RodHeirs::RodHeirs(const Plan& before, const Plan& after, const std::map<std::string, std::string>& points,
                   const std::map<std::string, std::vector<std::string>>& rods)
    : before_(parts_of(before)), after_(parts_of(after)), rods_(rods) {
  for (Part& part : before_) {
    for (std::string& name : part.points) {
      if (const auto found = points.find(name); found != points.end()) name = found->second;
    }
  }
  for (const PlanRod& rod : before.rods) rods_before_.push_back(rod.name);
  for (const PlanRod& rod : after.rods) rods_after_.push_back(rod.name);
}

const RodHeirs::Part* RodHeirs::part(const std::string& rod) const {
  const auto found = std::find_if(before_.begin(), before_.end(), [&](const Part& one) { return one.name == rod; });
  return found == before_.end() ? nullptr : &*found;
}

bool RodHeirs::known(const std::string& rod) const { return part(rod) != nullptr; }

std::vector<std::string> RodHeirs::of_plan_rod(const std::string& rod) const {
  const auto changed = rods_.find(rod);
  const std::vector<std::string> wanted = changed == rods_.end() ? std::vector<std::string>{rod} : changed->second;
  std::vector<std::string> there;
  for (const std::string& name : wanted) {
    if (std::find(rods_after_.begin(), rods_after_.end(), name) != rods_after_.end()) there.push_back(name);
  }
  return there;
}

std::vector<const RodHeirs::Part*> RodHeirs::heirs(const Part& part) const {
  std::vector<const Part*> all, nearer;
  for (const std::string& name : of_plan_rod(part.plan_rod)) {
    for (const Part& other : after_) {
      if (other.plan_rod != name) continue;
      if (other.points == part.points) return {&other};
      all.push_back(&other);
      if (share_piece(part.points, other.points)) nearer.push_back(&other);
    }
  }
  return nearer.empty() ? all : nearer;
}

std::vector<std::string> RodHeirs::of(const std::string& rod) const {
  std::vector<std::string> names;
  const Part* own = part(rod);
  if (own == nullptr) return names;
  for (const Part* heir : heirs(*own)) names.push_back(heir->name);
  return names;
}

PlaceOnRod RodHeirs::of(const PlaceOnRod& place) const {
  const Part* own = part(place.rod);
  if (own == nullptr) return {};
  const std::vector<const Part*> all = heirs(*own);
  if (all.size() == 1 && all[0]->points == own->points) return {all[0]->name, place.fraction};
  const Vec2 at = place_at(own->line, place.fraction);
  PlaceOnRod best;
  double least = std::numeric_limits<double>::infinity();
  for (const Part* heir : all) {
    const Nearest near = nearest_on(heir->line, at);
    if (near.distance >= least) continue;
    least = near.distance;
    best = {heir->name, near.fraction};
  }
  return best;
}

}  // namespace lissom
