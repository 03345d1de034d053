#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

#include "lissom/geometry/surface_mending.h"

namespace lissom {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;
using Point = Kernel::Point_3;

constexpr int kMostCrossings = 1'000'000;

struct TooMany {};  // thrown out of CGAL's loop over pairs of boxes, and caught around it

/// Pairs of triangles that have more in common than the corners and sides they share. Corners are one when their
/// coordinates are.
class Crossings {
 public:
  explicit Crossings(const Surface& surface) : triangles_(surface.triangles), place_(surface.vertices.size()) {
    const auto& x = surface.vertices;
    for (const Vec3& v : x) points_.emplace_back(v.x(), v.y(), v.z());
    std::vector<int> order;
    for (std::size_t v = 0; v < x.size(); ++v) {
      if (x[v].allFinite()) order.push_back(static_cast<int>(v));
    }
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return points_[a] != points_[b] ? points_[a] < points_[b] : a < b; });
    for (std::size_t i = 0; i < order.size(); ++i) {
      place_[order[i]] = i > 0 && points_[order[i]] == points_[order[i - 1]] ? place_[order[i - 1]] : order[i];
    }
  }

  /// In order; false when there are more than are looked for.
  bool find(std::vector<std::array<int, 2>>& pairs) {
    std::vector<Box> boxes;
    boxes.reserve(triangles_.size());
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
      const auto& own = triangles_[t];
      boxes.emplace_back(points_[own[0]].bbox() + points_[own[1]].bbox() + points_[own[2]].bbox(), t);
    }
    // Of sound surfaces about 10 per triangle.
    long long left = 100 * static_cast<long long>(triangles_.size()) + 1'000'000;
    bool all = true;
    try {
      CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
        if (--left < 0 || pairs.size() >= kMostCrossings) throw TooMany();
        const int t = std::min(a.info(), b.info()), u = std::max(a.info(), b.info());
        if (cross(t, u)) pairs.push_back({t, u});
      });
    } catch (const TooMany&) {
      all = false;
    }
    std::sort(pairs.begin(), pairs.end());
    return all;
  }

 private:
  using Triangle = Kernel::Triangle_3;
  using Segment = Kernel::Segment_3;
  Point corner(int t, int i) const { return points_[triangles_[t][i % 3]]; }
  Triangle triangle(int t) const { return {corner(t, 0), corner(t, 1), corner(t, 2)}; }
  int place(int t, int i) const { return place_[triangles_[t][i % 3]]; }

  bool cross(int t, int u) const {
    // Corners of both in the same place: which one of t, which one of u.
    int shared = 0, in_t = 0, in_u = 0, sum_t = 0, sum_u = 0;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        if (place(t, i) != place(u, j)) continue;
        ++shared;
        in_t = i, in_u = j;
        sum_t += i, sum_u += j;
      }
    }
    if (shared == 0) return CGAL::do_intersect(triangle(t), triangle(u));
    if (shared == 1) {
      return CGAL::do_intersect(Segment(corner(t, in_t + 1), corner(t, in_t + 2)), triangle(u)) ||
             CGAL::do_intersect(Segment(corner(u, in_u + 1), corner(u, in_u + 2)), triangle(t));
    }
    if (shared > 2) return true;
    // Over a common side two triangles meet again only when one is folded back flat onto the other.
    const int tip_t = 3 - sum_t, tip_u = 3 - sum_u;
    const Point &a = corner(t, tip_t + 1), &b = corner(t, tip_t + 2), &c = corner(t, tip_t), &d = corner(u, tip_u);
    return CGAL::orientation(a, b, c, d) == CGAL::COPLANAR && CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
  }

  const Triangles& triangles_;
  std::vector<Point> points_;
  std::vector<int> place_;  // first vertex with the same coordinates, by vertex
};

}  // namespace

Status look_for_crossings(Mending& mending) {
  std::vector<std::array<int, 2>> pairs;
  const bool all = Crossings(mending.surface).find(pairs);
  SurfaceNote note{.what = "pairs of triangles that cross or touch", .places = {}, .done = "kept"};
  if (!all) note.what += ", at least (the search was cut short)";
  for (const auto& [t, u] : pairs) {
    note.add(fmt::format("{} and {}", mending.triangle_name(t), mending.triangle_name(u)),
             Vec3(0.5 * (mending.middle(t) + mending.middle(u))));
  }
  if (!all && pairs.empty()) note.add("all over the surface");
  if (note.count > 0 && mending.options.crossings == SurfaceRepairOptions::Crossings::kRefuse) {
    return Error{
        ErrorCode::kGeometry, pairs.empty() ? mending.where : mending.triangle_place(pairs.front()[0]),
        fmt::format("the surface crosses or touches itself in {} pairs of triangles, the first {} at {}", pairs.size(),
                    note.places.front().element, in_millimetres(note.places.front().at.value_or(Vec3::Zero()))),
        "move the parts apart or unite them in the program that made the surface"};
  }
  mending.note(std::move(note), SurfaceNote::Outcome::kKept);
  return {};
}

}  // namespace lissom
