#include <algorithm>
#include <fmt/format.h>
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
  for (std::size_t r = 0; r < samples.rods.size(); ++r) {
    for (const int node : samples.rods[r]) {
      if (covered[static_cast<std::size_t>(node)]) continue;
      const std::size_t i = static_cast<std::size_t>(node);
      const bool point = i < plan.points.size();
      return Error{ErrorCode::kGeometry, fmt::format("/plan/rods/{}", r),
                   fmt::format("{} leaves the fabric at {}{}", rod_name(plan, static_cast<int>(r)),
                               point ? fmt::format("its point \"{}\", ", plan.points[i].name) : std::string(),
                               in_mm(samples.nodes[i])),
                   fmt::format("the fabric ends at {} and at its holes: keep every rod inside or on it", edge)};
    }
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

}  // namespace lissom
