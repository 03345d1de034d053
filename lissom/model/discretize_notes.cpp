#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <utility>

#include "lissom/model/discretize_parts.h"

namespace lissom {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kRemark = 20 * kDegree, kStrong = 30 * kDegree;
constexpr int kShown = 8;        // rods that are named
constexpr double kTouch = 1e-3;  // of an edge: a rod end closer than this is meant to lie on it

/// An end of a rod that nothing else shares.
struct LooseEnd {
  double place = 0;  ///< m, coordinate that the ends are sorted by
  int rod = -1, node = -1;
};

std::vector<LooseEnd> loose_ends(const Draft& draft, int axis) {
  const Structure& s = draft.structure;
  std::vector<LooseEnd> ends;
  for (size_t r = 0; r < s.rods.size(); ++r) {
    if (s.rods[r].closed) continue;
    for (const int node : {s.rods[r].nodes.front(), s.rods[r].nodes.back()}) {
      if (draft.passages[static_cast<size_t>(node)] != 1) continue;
      ends.push_back({s.nodes[static_cast<size_t>(node)][axis], static_cast<int>(r), node});
    }
  }
  std::sort(ends.begin(), ends.end(), [](const LooseEnd& a, const LooseEnd& b) {
    return std::pair(a.place, a.node) < std::pair(b.place, b.node);
  });
  return ends;
}

double distance_to(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (a + t * (b - a) - p).norm();
}

}  // namespace

void note_loose_ends(Draft& draft) {
  Structure& s = draft.structure;
  if (draft.model.merge_distance < 0) return;  // asked to keep all apart
  Vec3 low = s.nodes[0], high = low;
  for (const Vec3& p : s.nodes) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const std::vector<LooseEnd> ends = loose_ends(draft, static_cast<int>(axis));
  std::vector<int> touched(s.nodes.size(), -1);  // rod by end node
  for (const StructureEdge& edge : s.edges) {
    const Vec3 &a = s.nodes[static_cast<size_t>(edge.node0)], &b = s.nodes[static_cast<size_t>(edge.node1)];
    const double near = std::max(kTouch * (b - a).norm(), draft.model.merge_distance);
    const double from = std::min(a[axis], b[axis]) - near, to = std::max(a[axis], b[axis]) + near;
    auto end = std::lower_bound(ends.begin(), ends.end(), from,
                                [](const LooseEnd& e, double place) { return e.place < place; });
    for (; end != ends.end() && end->place <= to; ++end) {
      if (end->node == edge.node0 || end->node == edge.node1) continue;
      if (distance_to(s.nodes[static_cast<size_t>(end->node)], a, b) > near) continue;
      touched[static_cast<size_t>(end->node)] = edge.rod;
    }
  }
  int remarked = 0;
  for (const LooseEnd& end : ends) {
    const int other = touched[static_cast<size_t>(end.node)];
    if (other < 0 || ++remarked > kShown) continue;
    const Vec3 p = 1e3 * s.nodes[static_cast<size_t>(end.node)];
    s.notes.push_back(fmt::format(
        "{} ends on {} at ({:.4g}, {:.4g}, {:.4g}) mm, but is not joined to it; make that place "
        "a point or a node of both",
        rod_label(draft.model, static_cast<size_t>(end.rod)),
        other == end.rod ? "itself" : rod_label(draft.model, static_cast<size_t>(other)), p.x(), p.y(), p.z()));
  }
  if (remarked > kShown)
    s.notes.push_back(fmt::format("{} more rod ends lie on rods without a joint", remarked - kShown));
}

void note_turning_angles(Draft& draft) {
  Structure& s = draft.structure;
  std::vector<double> most(s.rods.size(), 0);
  for (const StructurePair& pair : s.pairs) {
    const StructureEdge &first = s.edges[static_cast<size_t>(pair.edge0)],
                        &second = s.edges[static_cast<size_t>(pair.edge1)];
    const double drawn = std::atan2(first.drawn.t.cross(second.drawn.t).norm(), first.drawn.t.dot(second.drawn.t));
    const double rest = 2 * std::atan(std::hypot(pair.rest_kappa_1, pair.rest_kappa_2) / 2);
    double& angle = most[static_cast<size_t>(first.rod)];
    angle = std::max(angle, std::max(drawn, rest));
  }
  int remarked = 0;
  for (size_t r = 0; r < most.size(); ++r) {
    if (most[r] <= kRemark + 1e-9 || ++remarked > kShown) continue;
    s.notes.push_back(
        fmt::format("{}: turns by {:.0f} degrees from edge to edge, {}; use about {} edges, or end the rod at "
                    "a corner and start another one",
                    rod_label(draft.model, r), most[r] / kDegree,
                    most[r] > kStrong ? "so its bending is clearly wrong" : "so its bending is several percent off",
                    static_cast<int>(std::ceil(double(s.rods[r].edges.size()) * most[r] / (10 * kDegree)))));
  }
  if (remarked > kShown) s.notes.push_back(fmt::format("{} more rods turn by more than 20 degrees", remarked - kShown));
}

}  // namespace lissom
