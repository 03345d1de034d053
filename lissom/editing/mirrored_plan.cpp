#include "lissom/editing/mirrored_plan.h"

#include <algorithm>
#include <map>

#include "lissom/editing/people_units.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr double kNear = 1e-6;  // of the size

/// The image of a place, exact where the line runs through the origin.
Vec2 image_of(const PlanMirror& mirror, const Vec2& place) {
  Vec2 image = mirror.image(place);
  if (mirror.at != 0) image[mirror.axis] = rounded_length(image[mirror.axis]);
  if (image[mirror.axis] == 0) image[mirror.axis] = 0;  // without a sign
  return image;
}

int point_at(const Plan& plan, const Vec2& place, double near) {
  const int nearest = nearest_point(plan, place);
  return nearest >= 0 && (point_of(plan, nearest).at - place).norm() <= near ? nearest : -1;
}

/// "wing-l" <-> "wing-r" when that is free; else empty.
template <class Named>
std::string other_side(const std::vector<Named>& list, const std::string& name) {
  if (name.size() < 3 || !(name.ends_with("-l") || name.ends_with("-r"))) return {};
  std::string other = name;
  other.back() = name.back() == 'l' ? 'r' : 'l';
  const auto same = [&](const Named& one) { return one.name == other; };
  return std::none_of(list.begin(), list.end(), same) ? other : std::string();
}

bool same_rod(const PlanRod& a, const PlanRod& b) {
  if (a.closed != b.closed || a.points.size() != b.points.size()) return false;
  if (a.closed) return std::is_permutation(a.points.begin(), a.points.end(), b.points.begin());
  return a.points == b.points || std::equal(a.points.begin(), a.points.end(), b.points.rbegin());
}

bool changed(const PlanPoint& before, const PlanPoint& after) {
  return before.at != after.at || before.r_n != after.r_n || before.r_b != after.r_b || before.split != after.split;
}

void follow(PlanPoint& partner, const PlanPoint& leader, const PlanMirror& mirror) {
  partner.at = image_of(mirror, leader.at);
  partner.r_n = leader.r_n;
  partner.r_b = leader.r_b;
  partner.split = leader.split;
}

bool is_image(const PlanPoint& a, const PlanPoint& b, const PlanMirror& mirror, double near) {
  return (mirror.image(a.at) - b.at).norm() <= near && a.r_n == b.r_n && a.r_b == b.r_b && a.split == b.split;
}

void take_mean(PlanPoint& a, PlanPoint& b, const PlanMirror& mirror) {
  const Vec2 mean = (a.at + mirror.image(b.at)) / 2;
  a.at = {rounded_length(mean.x()), rounded_length(mean.y())};
  a.r_n = a.r_n == b.r_n ? a.r_n : rounded_radius((a.r_n + b.r_n) / 2);
  a.r_b = a.r_b == b.r_b ? a.r_b : rounded_radius((a.r_b + b.r_b) / 2);
  a.split = a.split || b.split;
  follow(b, a, mirror);
}

}  // namespace

std::vector<std::array<int, 2>> pairs_of(const Plan& plan, const PlanMirror& mirror) {
  std::vector<std::array<int, 2>> pairs;
  const double near = kNear * plan_size(plan);
  for (std::size_t i = 0; i < plan.points.size(); ++i) {
    const int own = static_cast<int>(i), other = point_at(plan, mirror.image(plan.points[i].at), near);
    if (other >= own) pairs.push_back({own, other});
  }
  return pairs;
}

int add_mirror_images(Model& model, const std::vector<int>& rods, const PlanMirror& mirror) {
  Plan& plan = *model.plan;
  const double near = kNear * plan_size(plan);
  std::map<int, int> images;
  const auto image = [&](int point) {
    const auto known = images.find(point);
    if (known != images.end()) return known->second;
    const PlanPoint from = point_of(plan, point);
    const Vec2 place = image_of(mirror, from.at);
    int other = point_at(plan, place, near);
    if (other < 0) {
      std::string name = other_side(plan.points, from.name);
      if (name.empty()) name = unused_point_name(plan);
      plan.points.push_back({std::move(name), place, from.r_n, from.r_b, from.split});
      other = static_cast<int>(plan.points.size()) - 1;
    }
    return images[point] = other;
  };
  int added = 0;
  for (const int r : rods) {
    PlanRod rod = rod_of(plan, r);
    for (int& point : rod.points) point = image(point);
    const auto there = [&](const PlanRod& other) { return same_rod(rod, other); };
    if (std::any_of(plan.rods.begin(), plan.rods.end(), there)) continue;
    const std::string name = other_side(plan.rods, rod.name);
    rod.name = name.empty() ? unused_rod_name(model) : name;
    plan.rods.push_back(std::move(rod));
    ++added;
  }
  return added;
}

void keep_symmetry(const Plan& before, Plan& after, const PlanMirror& mirror) {
  std::map<std::string, int> numbers;
  for (std::size_t i = 0; i < after.points.size(); ++i) numbers[after.points[i].name] = static_cast<int>(i);
  const double near = kNear * plan_size(before);
  for (const auto& [a, b] : pairs_of(before, mirror)) {
    const PlanPoint &old_a = point_of(before, a), &old_b = point_of(before, b);
    const auto at_a = numbers.find(old_a.name), at_b = numbers.find(old_b.name);
    if (at_a == numbers.end() || at_b == numbers.end()) continue;
    PlanPoint &new_a = point_of(after, at_a->second), &new_b = point_of(after, at_b->second);
    const bool a_changed = changed(old_a, new_a), b_changed = changed(old_b, new_b);
    if (a == b) {
      if (a_changed) new_a.at[mirror.axis] = mirror.at;
    } else if (a_changed && b_changed) {
      if (!is_image(new_a, new_b, mirror, near)) take_mean(new_a, new_b, mirror);
    } else if (a_changed) {
      follow(new_b, new_a, mirror);
    } else if (b_changed) {
      follow(new_a, new_b, mirror);
    }
  }
}

}  // namespace lissom
