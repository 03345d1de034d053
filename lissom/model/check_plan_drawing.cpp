#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <numeric>

#include "lissom/geometry/segment_pairs.h"
#include "lissom/model/check_plan.h"

namespace lissom {

namespace {

std::string in_mm(const Vec2& p) { return fmt::format("({:.4g}, {:.4g}) mm", 1000 * p.x(), 1000 * p.y()); }

std::string rod_name(const Plan& plan, int rod) {
  const PlanRod& drawn = plan.rods[static_cast<std::size_t>(rod)];
  return fmt::format("{} \"{}\"", drawn.role == PlanRole::kGhost ? "ghost" : "rod", drawn.name);
}

/// The edges of all rods.
struct Segments {
  std::vector<std::array<int, 2>> ends;
  std::vector<int> rod;

  Segments(const Plan& plan, const PlanSamples& samples) {
    for (std::size_t r = 0; r < samples.rods.size(); ++r) {
      const std::vector<int>& nodes = samples.rods[r];
      for (std::size_t i = 0; i + (plan.rods[r].closed ? 0 : 1) < nodes.size(); ++i) {
        ends.push_back({nodes[i], nodes[(i + 1) % nodes.size()]});
        rod.push_back(static_cast<int>(r));
      }
    }
  }
};

/// Number of the node that two edges share, as places in each; -1 when there is none.
int shared_node(const std::array<int, 2>& a, const std::array<int, 2>& b) {
  for (const int node : a) {
    if (node == b[0] || node == b[1]) return node;
  }
  return -1;
}

/// Lengths (m) over which pairs of printed rods are nearer than their radii, away from common points.
std::map<std::array<int, 2>, double> overlaps(const Plan& plan, const PlanSamples& samples,
                                              const std::vector<double>& r_b) {
  constexpr double kFar = 6;  // in sums of radii: rods that meet at 10 degrees have come apart there
  const Segments segments(plan, samples);
  const auto at = [&](int node) -> const Vec2& { return samples.nodes[static_cast<std::size_t>(node)]; };
  const auto middle = [&](std::size_t k) -> Vec2 { return (at(segments.ends[k][0]) + at(segments.ends[k][1])) / 2; };
  const auto length = [&](std::size_t k) { return (at(segments.ends[k][1]) - at(segments.ends[k][0])).norm(); };
  const auto radius = [&](std::size_t k) {
    return (r_b[static_cast<std::size_t>(segments.ends[k][0])] + r_b[static_cast<std::size_t>(segments.ends[k][1])]) /
           2;
  };
  std::map<std::array<int, 2>, double> lengths;
  int counted = -1;  // pairs come by first edge: each is counted once per rod that it lies beside
  std::vector<int> beside;
  for (const auto& [i, j] :
       near_segments(samples.nodes, segments.ends, 2 * *std::max_element(r_b.begin(), r_b.end()))) {
    const std::size_t p = static_cast<std::size_t>(i), q = static_cast<std::size_t>(j);
    const int r = segments.rod[p], s = segments.rod[q];
    const PlanRod &first = plan.rods[static_cast<std::size_t>(r)], &second = plan.rods[static_cast<std::size_t>(s)];
    if (r == s || first.role == PlanRole::kGhost || second.role == PlanRole::kGhost) continue;
    const double sum = radius(p) + radius(q);
    const auto &a = segments.ends[p], &b = segments.ends[q];
    if (segment_distance(at(a[0]), at(a[1]), at(b[0]), at(b[1])) >= sum) continue;
    bool near_joint = false;
    for (const int point : first.points) {
      if (std::find(second.points.begin(), second.points.end(), point) == second.points.end()) continue;
      const double reach = kFar * sum + length(p) + length(q);
      near_joint = near_joint || (at(point) - middle(p)).norm() < reach || (at(point) - middle(q)).norm() < reach;
    }
    if (near_joint) continue;
    if (i != counted) beside.clear();
    counted = i;
    if (std::find(beside.begin(), beside.end(), s) != beside.end()) continue;
    beside.push_back(s);
    lengths[{r, s}] += length(p);
  }
  return lengths;
}

double drawing_size(const PlanSamples& samples) {
  Vec2 low = samples.nodes[0], high = low;
  for (const Vec2& p : samples.nodes) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

}  // namespace

Status check_plan_drawing(const Plan& plan, const PlanSamples& samples) {
  const Segments segments(plan, samples);
  const auto at = [&](int node) -> const Vec2& { return samples.nodes[static_cast<std::size_t>(node)]; };
  constexpr double kTouch = 1e-7;  // of the size of the drawing
  for (const auto& [i, j] : near_segments(samples.nodes, segments.ends, kTouch * drawing_size(samples))) {
    const std::size_t first = static_cast<std::size_t>(i), second = static_cast<std::size_t>(j);
    const auto &a = segments.ends[first], &b = segments.ends[second];
    const int r = segments.rod[first], q = segments.rod[second];
    const std::string where = fmt::format("/plan/rods/{}", q);
    const int node = shared_node(a, b);
    if (node < 0) {
      const Vec2 middle = (at(a[0]) + at(a[1]) + at(b[0]) + at(b[1])) / 4;
      const std::string crossing =
          r == q ? fmt::format("{} crosses itself", rod_name(plan, q))
                 : fmt::format("{} and {} cross without a common point", rod_name(plan, r), rod_name(plan, q));
      return Error{ErrorCode::kGeometry, where, crossing + " near " + in_mm(middle),
                   r == q ? "move its points, or draw it as two rods that share a point there"
                          : "add a point there and name it in both rods: they are joined at it"};
    }
    const Vec2 u = (at(a[0] == node ? a[1] : a[0]) - at(node)).normalized();
    const Vec2 v = (at(b[0] == node ? b[1] : b[0]) - at(node)).normalized();
    if (u.dot(v) < 1 - 1e-8) continue;
    return Error{ErrorCode::kGeometry, where,
                 r == q ? fmt::format("{} turns back on itself at {}", rod_name(plan, q), in_mm(at(node)))
                        : fmt::format("{} and {} lie on each other from {} on", rod_name(plan, r), rod_name(plan, q),
                                      in_mm(at(node))),
                 r == q ? "move its points" : "draw one rod where they run together"};
  }
  return {};
}

Status check_plan_mesh(const Plan& plan, const PlanSamples& samples, const PlanarMesh& mesh) {
  std::vector<int> part(mesh.points.size(), -1);
  std::iota(part.begin(), part.end(), 0);
  const auto root = [&](int i) {
    while (part[static_cast<std::size_t>(i)] != i) {
      int& up = part[static_cast<std::size_t>(i)];
      up = part[static_cast<std::size_t>(up)];
      i = up;
    }
    return i;
  };
  std::vector<char> covered(mesh.points.size(), 0);
  for (const auto& t : mesh.triangles) {
    for (const int v : t) {
      covered[static_cast<std::size_t>(v)] = 1;
      const int a = root(v), b = root(t[0]);
      part[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  }
  const std::string edge = plan.fabric.outline.empty() ? "the outer loop of the rods" : "its outline";
  const auto outside = [&](const std::vector<int>& nodes) {
    for (const int node : nodes) {
      if (!covered[static_cast<std::size_t>(node)]) return node;
    }
    return -1;
  };
  for (std::size_t r = 0; r < samples.rods.size(); ++r) {
    const int point = outside(plan.rods[r].points), node = point >= 0 ? point : outside(samples.rods[r]);
    if (node < 0) continue;
    const std::size_t i = static_cast<std::size_t>(node);
    return Error{ErrorCode::kGeometry, fmt::format("/plan/rods/{}", r),
                 fmt::format("{} leaves the fabric at {}{}", rod_name(plan, static_cast<int>(r)),
                             point >= 0 ? fmt::format("its point \"{}\", ", plan.points[i].name) : std::string(),
                             in_mm(samples.nodes[i])),
                 fmt::format("the fabric ends at {} and at its holes: keep every rod inside or on it", edge)};
  }
  for (std::size_t r = 1; r < samples.rods.size(); ++r) {
    if (root(samples.rods[r][0]) == root(samples.rods[0][0])) continue;
    return Error{ErrorCode::kGeometry, "/plan/fabric",
                 fmt::format("the fabric falls into parts that do not hang together: {} and {} are on different ones",
                             rod_name(plan, 0), rod_name(plan, static_cast<int>(r))),
                 "join the parts by a point that they share, or describe two models"};
  }
  return {};
}

void note_plan(const Plan& plan, const PlanSamples& samples, const std::vector<double>& r_b,
               std::vector<std::string>& notes) {
  if (plan.fabric.pre_stretch.minCoeff() < 1) {
    notes.push_back(
        fmt::format("the fabric is slack as printed: its pre-stretch is {:g}; give more than 1, for example 1.4",
                    plan.fabric.pre_stretch.minCoeff()));
  }
  constexpr double kUnusualStretch = 2.5;
  if (plan.fabric.pre_stretch.maxCoeff() > kUnusualStretch) {
    notes.push_back(fmt::format("the pre-stretch of {:g} is beyond what fabrics bear: 1.2 to 1.8 is usual",
                                plan.fabric.pre_stretch.maxCoeff()));
  }
  const std::map<std::array<int, 2>, double> lengths = overlaps(plan, samples, r_b);
  std::size_t told = 0;
  constexpr std::size_t kMost = 4;
  for (const auto& [rods, length] : lengths) {
    if (told++ == kMost) break;
    notes.push_back(
        fmt::format("{} and {} overlap over {:.3g} mm: they are nearer to each other than their radii; move "
                    "them apart, make them thinner, or draw one rod",
                    rod_name(plan, rods[0]), rod_name(plan, rods[1]), 1000 * length));
  }
  if (lengths.size() > kMost) notes.push_back(fmt::format("{} more pairs of rods overlap", lengths.size() - kMost));
}

}  // namespace lissom
